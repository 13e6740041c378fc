//! Points of a product of projective lines.

use super::rough_root::rough_root;
use super::system::Variable;
use crate::numeric::complex::{Complex, ONE};
use crate::numeric::complex_matrix::Vector;

/// A point: of every variable either its value or, where `flipped`, the inverse of its value,
/// whichever is small.
#[derive(Clone, Copy)]
pub(super) struct ProjectivePoint<const N: usize> {
    pub(super) x: Vector<N>,
    pub(super) flipped: [bool; N],
}

impl<const N: usize> ProjectivePoint<N> {
    /// Square of the distance, which adds up the distances on the spheres of the variables.
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let apart = |j: usize| {
            let (a, b) = (self.x[j], other.x[j]);
            let apart = if self.flipped[j] == other.flipped[j] {
                a - b
            } else {
                a * b - ONE
            };
            apart.square() / ((1.0 + a.square()) * (1.0 + b.square()))
        };
        (0..N).map(apart).sum()
    }

    /// A number between -1/2 and 1/2 that differs by less than the distance between two points.
    pub(super) fn key(&self) -> f64 {
        self.x[0].re / (1.0 + self.x[0].square())
    }

    /// The point at which the reflected equations hold.
    pub(super) fn reflection(&self, variables: &[Variable]) -> Self {
        let mut image = *self;
        for (j, variable) in variables.iter().enumerate() {
            let (from, flip) = match variable {
                Variable::Unit => (j, true),
                Variable::Length | Variable::Number => (j, false),
                Variable::Point => (j + 1, false),
                Variable::Conjugate => (j - 1, false),
            };
            image.x[j] = self.x[from].conjugate();
            image.flipped[j] = self.flipped[from] != flip;
        }
        image
    }

    /// Returns the distance of the coordinate of each variable from its value in a real solution:
    /// that of its reflection.
    pub(super) fn gaps(&self, variables: &[Variable]) -> [f64; N] {
        let image = self.reflection(variables);
        core::array::from_fn(|j| {
            let (x, other) = (self.x[j], image.x[j]);
            let gap = match self.flipped[j] == image.flipped[j] {
                true => x - other,
                // The other coordinate is the inverse of this one.
                false => x * other - ONE,
            };
            rough_root(gap.square())
        })
    }

    /// The values of the variables; infinite ones are not finite numbers.
    pub(super) fn values(&self) -> Vector<N> {
        core::array::from_fn(|j| self.value(j))
    }

    fn value(&self, j: usize) -> Complex {
        if self.flipped[j] {
            self.x[j].inverse()
        } else {
            self.x[j]
        }
    }

    /// Returns whether no variable is infinite and no unit vector is zero.
    pub(super) fn is_inside(&self, variables: &[Variable]) -> bool {
        (0..N).all(|j| !self.is_outer(j, variables) || self.x[j].square() > OUTSIDE * OUTSIDE)
    }

    /// Returns whether a variable would be infinite, or a unit vector zero, if its coordinate
    /// vanished.
    pub(super) fn is_outer(&self, j: usize, variables: &[Variable]) -> bool {
        self.flipped[j] || variables[j] == Variable::Unit
    }
}

/// Coordinates below this are taken for zero: their inverses are no values of a scaled system.
const OUTSIDE: f64 = 1e-7;

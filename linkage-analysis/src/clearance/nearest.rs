//! A place of the cycle where two shapes are nearest to each other.

use super::case::{Case, Variation};
use super::shape::{between, difference};
use crate::components::Components;
use linkage_core::numeric::vector::dot;

/// A place of the cycle with a local minimum of the distance of two shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<const K: usize> {
    /// The angle of the shaft.
    pub at: f64,
    /// The distance; 0 where the shapes touch, up to rounding of their coordinates.
    pub distance: f64,
    /// Position on the shapes: on a segment 0 at its first and 1 at its second end, on a point 0.
    pub feet: [f64; 2],
    /// The unit vector from the second shape to the first one; NaN where they touch.
    pub direction: [f64; K],
    pub(super) case: Case<K>,
}

impl<const K: usize> Nearest<K> {
    pub(super) fn new(at: f64, case: Case<K>) -> Self {
        let distance = case.distance();
        let direction = |component| {
            if distance > 0.0 {
                component / distance
            } else {
                f64::NAN
            }
        };
        Self {
            at,
            distance,
            feet: case.feet,
            direction: case.gap[0].map(direction),
            case,
        }
    }

    /// The second derivative of the distance with respect to the angle.
    #[must_use]
    pub fn bend(&self) -> f64 {
        self.case.bend() / self.distance
    }

    /// The derivatives of the distance with respect to all parameters, from those of the points
    /// here: for each point of both shapes the result of `sensitivity(point)` at the angle
    /// [`at`](Self::at).
    ///
    /// Neither the angle at which the distance is least nor the places along segments need follow
    /// the parameters, since the distance does not notice, to first order (the envelope theorem):
    /// `dD/dp = direction . (dP/dp - dQ/dp)`. It is NaN where the shapes touch.
    #[must_use]
    pub fn sensitivity<V: Components<K>, const A: usize, const B: usize, const P: usize>(
        &self,
        first: [[V; P]; A],
        second: [[V; P]; B],
    ) -> [f64; P] {
        core::array::from_fn(|p| {
            let first = first.map(|point| point[p].components());
            let second = second.map(|point| point[p].components());
            let [a, b] = [
                foot_point(&first, self.feet[0]),
                foot_point(&second, self.feet[1]),
            ];
            dot(&self.direction, &difference(&a, &b))
        })
    }

    /// The derivatives of the angle [`at`](Self::at) with respect to all parameters, in radians for
    /// a unit of each: for each point of both shapes the results of `sensitivity(point)` and
    /// `sensitivity(velocity(point))` there.
    ///
    /// By the implicit function theorem, `-(d2q/dtheta dp) / (d2q/dtheta2)` with half the square of
    /// the distance for `q`, places along segments eliminated.
    #[must_use]
    pub fn shift<V: Components<K>, const A: usize, const B: usize, const P: usize>(
        &self,
        first: [[[V; P]; 2]; A],
        second: [[[V; P]; 2]; B],
    ) -> [f64; P] {
        let bend = self.case.bend();
        core::array::from_fn(|p| {
            let derivative = |order: usize| {
                let first = first.map(|point| point[order][p].components());
                let second = second.map(|point| point[order][p].components());
                let gap = difference(
                    &foot_point(&first, self.feet[0]),
                    &foot_point(&second, self.feet[1]),
                );
                (gap, [span(&first), span(&second)])
            };
            let ((gap, edges), (rate, _)) = (derivative(0), derivative(1));
            -self.case.mixed(&Variation { gap, rate, edges }) / bend
        })
    }
}

/// The value at a position of a shape.
pub(super) fn foot_point<const K: usize>(points: &[[f64; K]], foot: f64) -> [f64; K] {
    match points {
        [a, b] => between([a, b], foot),
        _ => points[0],
    }
}

/// The value at the second end less the value at the first one.
fn span<const K: usize>(points: &[[f64; K]]) -> [f64; K] {
    match points {
        [a, b] => difference(b, a),
        _ => [0.0; K],
    }
}

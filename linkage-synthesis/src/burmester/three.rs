//! Three poses: one of the two joints is free, the other one follows.

use super::super::Pose;
use super::super::error::{self, Unsolved};
use super::super::verify;
use super::Moves;
use crate::guides::Pivots;
use linkage_core::numeric::complex::{Complex, ONE};

impl Pivots {
    /// The link with this joint of the frame that leads a body through three poses.
    ///
    /// # Errors
    ///
    /// `NotFinite`, `Equal` poses; `AtInfinity` if the joint of the body is.
    pub fn with_fixed(poses: &[Pose; 3], fixed: [f64; 2]) -> Result<Self, Unsolved> {
        let moves = checked(poses)?;
        let fixed = (Complex::from(fixed) - moves.first.point.into()).scaled(1.0 / moves.unit);
        let moving = moves.moving(fixed, [0, 1]).ok_or(Unsolved::AtInfinity)?;
        verified(moves.pivots(moving, fixed), poses)
    }

    /// The link with this joint of the body (in its frame) that leads it through three poses: the
    /// centre of the circle through the places of the joint.
    ///
    /// # Errors
    ///
    /// `NotFinite`, `Equal` poses; `AtInfinity` if the places are on a straight line.
    pub fn with_moving(poses: &[Pose; 3], moving: [f64; 2]) -> Result<Self, Unsolved> {
        let moves = checked(poses)?;
        let turned = Complex::polar(moves.first.angle) * moving.into();
        let moving = turned.scaled(1.0 / moves.unit);
        let fixed = moves.fixed(moving).ok_or(Unsolved::AtInfinity)?;
        verified(moves.pivots(moving, fixed), poses)
    }
}

/// Joints that are so far away that rounding does not keep their distance are at infinity.
fn verified(pivots: Pivots, poses: &[Pose]) -> Result<Pivots, Unsolved> {
    let keeps = verify::keeps_length(&pivots, poses);
    keeps.then_some(pivots).ok_or(Unsolved::AtInfinity)
}

fn checked(poses: &[Pose; 3]) -> Result<Moves<2>, Unsolved> {
    error::check(&poses.map(|pose| [pose.point[0], pose.point[1], pose.angle]))?;
    Ok(Moves::new(&poses[0], [&poses[1], &poses[2]]))
}

/// The solution of `c z + conj(c z) = -e` for two of them.
fn meet([(c, e), (d, f)]: [(Complex, f64); 2]) -> Option<Complex> {
    let determinant = c.im * d.re - c.re * d.im;
    let size = c.size() * d.size();
    // Lines that are parallel, apart from rounding.
    if determinant.abs() <= 4.0 * f64::EPSILON * size {
        return None;
    }
    // c = c.re + i c.im: c z + conj = 2 (c.re x - c.im y)
    let half = 0.5 / determinant;
    let x = (e * d.im - f * c.im) * half;
    let y = (e * d.re - f * c.re) * half;
    Some(Complex::new(x, y))
}

impl<const N: usize> Moves<N> {
    /// The joint of the body to a joint of the frame, from two of the moves.
    pub(super) fn moving(&self, fixed: Complex, two: [usize; 2]) -> Option<Complex> {
        meet(two.map(|j| {
            let (shift, turn) = (self.shifts[j].narrow(), self.turns[j]);
            let factor = turn * (shift - fixed).conjugate() + fixed.conjugate();
            let rest = shift.square() - 2.0 * (shift.conjugate() * fixed).re;
            (factor, rest)
        }))
    }
}

impl Moves<2> {
    /// The joint of the frame to a joint of the body.
    fn fixed(&self, moving: Complex) -> Option<Complex> {
        meet([0, 1].map(|j| {
            let (shift, turn) = (self.shifts[j].narrow(), self.turns[j]);
            let factor = ((ONE - turn) * moving - shift).conjugate();
            let rest = shift.square() + 2.0 * (turn * moving * shift.conjugate()).re;
            (factor, rest)
        }))
    }
}

//! Burmester's problem: links that let a body take given poses.

mod conics;
mod curve;
mod five;
mod three;

pub use curve::{CentreCurve, CentrePoint};

use super::dyad::{self, Link};
use super::guides::{Dyad, Pivots};
use super::task::Shift;
use super::{FourBar, Pose};
use linkage_core::numeric::complex::Complex;
use std::vec::Vec;

/// All dyads that lead a body through five poses: four, of which some may be complex.
#[derive(Clone, Debug, PartialEq)]
pub struct Dyads {
    /// The real ones, in ascending order of the fixed joint.
    pub real: Vec<Dyad>,
    /// The number of complex ones: no mechanisms.
    pub complex: usize,
    /// The number of those that are too close to others, or to infinity, to decide whether they are
    /// real, or do not lead the body through all poses with rounded joints.
    pub undecided: usize,
    /// True if the count is shown: four links, each shown to exist (Krawczyk's test with discs,
    /// rounding included), to be real or complex, and to differ from the others. There are no more
    /// than four, if finitely many. It is not shown if one of them is a slider, or undecided.
    pub certified: bool,
    /// Bound of the errors of `fixed` and `moving` that comes with the certificate, in units of the
    /// poses.
    pub error: f64,
}

impl Dyads {
    /// The links among the real dyads.
    pub fn links(&self) -> impl Iterator<Item = Pivots> {
        self.real.iter().filter_map(|dyad| match dyad {
            Dyad::Link(pivots) => Some(*pivots),
            _ => None,
        })
    }

    /// The four-bars of all pairs of links: at most six.
    #[must_use]
    pub fn four_bars(&self) -> Vec<FourBar> {
        let links: Vec<Pivots> = self.links().collect();
        let pairs = links.iter().enumerate();
        pairs
            .flat_map(|(i, a)| links[i + 1..].iter().map(move |b| FourBar::of_links(a, b)))
            .collect()
    }
}

impl FourBar {
    /// The four-bar of two links of one body.
    #[must_use]
    pub fn of_links(a: &Pivots, b: &Pivots) -> Self {
        Self {
            fixed: [a.fixed, b.fixed],
            moving: [a.moving, b.moving],
        }
    }
}

/// Poses against the first one of them.
pub(super) struct Moves<const N: usize> {
    pub(super) first: Pose,
    /// The unit of length of the shifts.
    pub(super) unit: f64,
    pub(super) shifts: [Shift; N],
    pub(super) turns: [Complex; N],
}

impl<const N: usize> Moves<N> {
    /// Collects as many moves as poses after the first one.
    fn new(first: &Pose, others: [&Pose; N]) -> Self {
        let shifts = others.map(|pose| Shift::between(first.point, pose.point));
        let sizes = shifts.iter().map(|shift| shift.narrow());
        let unit = super::task::unit(sizes);
        // Poses at one place: any unit will do.
        let unit = if unit > 0.0 { unit } else { 1.0 };
        Self {
            first: *first,
            unit,
            shifts: shifts.map(|shift| shift.scaled(1.0 / unit)),
            turns: others.map(|pose| Complex::polar(pose.angle - first.angle)),
        }
    }

    fn link(&self, dyad: &dyad::Dyad<Complex>, j: usize) -> Link<Complex> {
        let shift = self.shifts[j].narrow();
        let turn = self.turns[j];
        dyad::link(dyad, [shift, shift.conjugate()], [turn, turn.conjugate()])
    }

    /// Joints in units of the poses, from a joint of the body in pose 0 and one of the frame.
    fn pivots(&self, moving: Complex, fixed: Complex) -> Pivots {
        let back = Complex::polar(-self.first.angle);
        Pivots {
            fixed: (fixed.scaled(self.unit) + self.first.point.into()).into(),
            moving: (back * moving.scaled(self.unit)).into(),
        }
    }
}

//! Burmester's problem: links that let a body take given poses.

mod conics;
mod curve;
mod five;
mod three;

pub use curve::{CentreCurve, CentrePoint};

use super::dyad::{self, Link};
use super::task::Shift;
use super::{FourBar, Pose};
use linkage_core::numeric::complex::Complex;
use std::vec::Vec;

/// A joint of the frame and a joint of the body that keep their distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pivots {
    /// The joint of the frame, a centre point.
    pub fixed: [f64; 2],
    /// The joint of the body, a circle point, in the body's frame.
    pub moving: [f64; 2],
}

impl Pivots {
    /// The distance of the joints in a pose.
    #[must_use]
    pub fn length(&self, pose: &Pose) -> f64 {
        let moving = pose.place(self.moving);
        (self.fixed[0] - moving[0]).hypot(self.fixed[1] - moving[1])
    }
}

/// The guides that can lead a body through poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dyad {
    /// A link with two revolute joints.
    Link(Pivots),
    /// A point of the body on a straight line of the frame: a slider of the frame with a revolute
    /// joint. It is a link whose fixed joint is at infinity.
    PointOnLine {
        /// The point, in the body's frame.
        moving: [f64; 2],
        /// Angle of the line, rad; it goes through the places of the point.
        angle: f64,
    },
    /// A straight line of the body through a point of the frame: a revolute joint of the frame with
    /// a slider. It is a link whose moving joint is at infinity.
    LineThroughPoint {
        /// The point of the frame.
        fixed: [f64; 2],
        /// Angle of the line in the body's frame, rad; it goes through the places of the point.
        angle: f64,
    },
}

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

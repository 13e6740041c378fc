//! Following a solution while the points are changed into others.

use super::super::path::{self, Moving, Pace, Step, Stuck};
use super::cognates::{cognate, exchanged};
use super::equations::{ALL, Shifts, Unknowns, newton};
use linkage_core::numeric::complex::{Complex, ONE};

/// The way from some points to others: not straight, but along an arc of complex points, which for
/// almost every `arc` keeps away from points with double solutions.
pub(super) struct ParameterPath<'a> {
    pub(super) from: &'a Shifts<Complex>,
    pub(super) to: &'a Shifts<Complex>,
    pub(super) arc: Complex,
}

impl Moving<ALL> for ParameterPath<'_> {
    /// Points and their derivatives.
    type Data = (Shifts<Complex>, Shifts<Complex>);

    fn evaluate(&self, t: f64) -> Self::Data {
        let rest = (ONE + (self.arc - ONE).scaled(t)).inverse();
        let part = self.arc.scaled(t) * rest;
        let slope = self.arc * rest * rest;
        let pairs = |factor: Complex, start: f64| {
            core::array::from_fn(|j| {
                core::array::from_fn(|h| {
                    let (from, to) = (self.from[j][h], self.to[j][h]);
                    to.scaled(start) + factor * (from - to)
                })
            })
        };
        (pairs(part, 1.0), pairs(slope, 0.0))
    }

    fn newton(&self, point: &Unknowns<Complex>, (shifts, drift): &Self::Data) -> Step<ALL> {
        newton(point, shifts, drift)
    }
}

/// The number of times that another cognate may be followed.
const MOST_CHANGES: usize = 12;

/// Returns the end of the path of a solution, as one of its cognates; `None` if it sticks or takes
/// too many steps.
///
/// Where the equations of one cognate are nearly singular, those of another one can be plain.
pub(super) fn follow(
    start: &Unknowns<Complex>,
    way: &ParameterPath<'_>,
    pace: Pace,
) -> Option<Unknowns<Complex>> {
    let (mut t, mut start) = (1.0, *start);
    for change in 0..MOST_CHANGES {
        let stuck = match path::follow(way, pace, t, &start) {
            Ok(end) => return Some(end),
            Err(stuck) => stuck,
        };
        let Stuck { point, .. } = stuck;
        t = stuck.t;
        let (shifts, _) = way.evaluate(t);
        // Each of the two others in turn.
        let other = if change % 2 == 0 {
            point
        } else {
            exchanged(&point)
        };
        start = cognate(&other, &shifts);
    }
    None
}

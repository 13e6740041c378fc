//! Nine points of a path: all four-bars with a coupler point that passes them (Alt's problem of 1923; Wampler, Morgan and
//! Sommese, Journal of Mechanical Design 114, 1992).
//!
//! For almost all points there are 1442 triples of cognates. Those of some stored points are followed while the points are
//! changed into the given ones.

mod cognates;
mod curve;
mod equations;
mod path;
mod search;
mod starts;
#[cfg(test)]
mod tests;

use super::Pose;
use super::error::{self, Unsolved};
use super::four_bar::{FourBar, Passage};
use super::task::{self, Shift};
use super::verify;
use crate::design::Progress;
use alloc::vec::Vec;
use linkage_core::numeric::complex::Complex;
use search::Search;

/// Triples of cognates for almost all nine points, real and complex.
///
/// The number is that of the literature (first by Wampler, Morgan and Sommese, found again by all methods since), and of
/// the generator of the stored solutions: a number computed with much evidence, not a theorem.
pub const TRIPLES: usize = 1442;

/// The four-bars through nine points.
#[derive(Clone, Debug, PartialEq)]
pub struct NinePoints {
    /// The real ones: three four-bars with the same coupler curve each (Roberts).
    pub triples: Vec<Triple>,
    /// How many triples are complex: no mechanisms.
    pub complex: usize,
    /// Paths without an end of their own: at points with a symmetry or next to others with double solutions. Also triples of which a
    /// cognate does not close at all points with the joints that rounding leaves.
    pub undecided: usize,
}

impl NinePoints {
    /// Whether all [`TRIPLES`] have been found: each shown to exist, to be real or complex and to differ from the others
    /// (Krawczyk's test on discs, rounding included). There are no others then, if 1442 is the number. This holds whatever
    /// way they have been found.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.triples.len() + self.complex == TRIPLES
    }
}

/// Three four-bars with the same coupler curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Triple {
    /// The cognates; each two have a joint of the frame in common.
    pub four_bars: [PathFourBar; 3],
    /// Bound of the errors of the joints of the first one, in units of the points.
    pub error: f64,
}

impl Triple {
    /// Whether both links of each cognate keep their lengths at all points.
    fn closes(&self) -> bool {
        let mut cognates = self.four_bars.iter();
        cognates.all(|own| verify::closes(&own.four_bar, &own.poses))
    }
}

/// A four-bar and how it passes the points.
#[derive(Clone, Debug, PartialEq)]
pub struct PathFourBar {
    /// Its joints. The coupler's frame has its origin at the point of the path, and angle 0 at the first point.
    pub four_bar: FourBar,
    /// The coupler at the points.
    pub poses: [Pose; 9],
    /// Circuits, branches, order.
    pub passage: Passage,
}

/// Nine points against the first one.
struct Task {
    first: [f64; 2],
    unit: f64,
    shifts: [Shift; 8],
}

/// All four-bars with a coupler point that passes the nine points, in any order and on any circuit.
///
/// The same points always give the same listing, whatever the number of threads.
///
/// # Errors
///
/// `NotFinite`; `Equal` points; `OnCircle` or `OnLine` for more than six points on a circle or a line.
pub fn nine_points(points: &[[f64; 2]; 9]) -> Result<NinePoints, Unsolved> {
    nine_points_reporting(points, |_| true)
}

/// As [`nine_points`], telling how far it has come some dozen times; it stops where `report` gives `false`.
///
/// # Errors
///
/// As [`nine_points`], and `Stopped`.
pub fn nine_points_reporting(
    points: &[[f64; 2]; 9],
    mut report: impl FnMut(Progress) -> bool,
) -> Result<NinePoints, Unsolved> {
    let task = Task::new(points)?;
    let search = Search::run(&task, &mut report)?;
    let mut found = NinePoints {
        triples: Vec::new(),
        complex: 0,
        undecided: TRIPLES.saturating_sub(search.found.len()),
    };
    for (certificate, _) in &search.found {
        match certificate.real {
            Some(true) => {
                let triple = task.triple(certificate);
                match triple.closes() {
                    true => found.triples.push(triple),
                    false => found.undecided += 1,
                }
            }
            Some(false) => found.complex += 1,
            None => found.undecided += 1,
        }
    }
    let place = |triple: &Triple| triple.four_bars[0].four_bar.fixed;
    found.triples.sort_by(|a, b| {
        place(a)
            .partial_cmp(&place(b))
            .unwrap_or(core::cmp::Ordering::Equal)
    });
    Ok(found)
}

impl Task {
    fn new(points: &[[f64; 2]; 9]) -> Result<Self, Unsolved> {
        error::check(points)?;
        curve::check(points)?;
        let [first, others @ ..] = *points;
        let shifts = others.map(|point| Shift::between(first, point));
        let unit = task::unit(shifts.iter().map(|shift| shift.narrow()));
        Ok(Self {
            first,
            unit,
            shifts: shifts.map(|shift| shift.scaled(1.0 / unit)),
        })
    }

    fn plain(&self) -> equations::Shifts<Complex> {
        self.shifts.map(|shift| shift.wide().map(Complex::narrow))
    }

    fn triple(&self, certificate: &search::Certificate) -> Triple {
        let shifts = self.plain();
        let first = certificate.discs.map(|disc| disc.middle);
        let second = cognates::cognate(&first, &shifts);
        let third = cognates::cognate(&cognates::exchanged(&first), &shifts);
        let radii = certificate.discs[..8].iter().map(|disc| disc.radius);
        Triple {
            four_bars: [first, second, third].map(|unknowns| self.four_bar(&unknowns)),
            error: radii.fold(0.0, f64::max) * self.unit,
        }
    }

    fn four_bar(&self, unknowns: &equations::Unknowns<Complex>) -> PathFourBar {
        let length = |number: Complex| number.scaled(self.unit);
        let place = |shift: Complex| (length(shift) + self.first.into()).into();
        let [x, _, a, _, y, _, b, ..] = *unknowns;
        let four_bar = FourBar {
            fixed: [a, b].map(place),
            moving: [x, y].map(|joint| length(joint).into()),
        };
        let poses = core::array::from_fn(|j| match j {
            0 => Pose::new(self.first, 0.0),
            _ => Pose::new(
                place(self.shifts[j - 1].narrow()),
                unknowns[6 + 2 * j].angle(),
            ),
        });
        let passage = four_bar.passage(&poses);
        PathFourBar {
            four_bar,
            poses,
            passage,
        }
    }
}

//! Nine points of a path: all four-bars with a coupler point that passes them (Alt's problem of
//! 1923; Wampler, Morgan and Sommese, Journal of Mechanical Design 114, 1992).
//!
//! For almost all points there are 1442 triples of cognates. Those of some stored points are
//! followed while the points are changed into the given ones.

mod cognates;
mod curve;
mod division;
mod equations;
mod listing;
mod path;
mod result;
mod search;
mod stored_solutions;
mod task;
#[cfg(test)]
mod tests;

pub use division::{NinePointsPart, NinePointsSearch};
pub use result::{NinePoints, PathFourBar, TRIPLES, Triple};

use super::error::Unsolved;
use linkage_design::Progress;

/// All four-bars with a coupler point that passes the nine points, in any order and on any circuit.
///
/// The same points always give the same listing, whatever the number of threads.
///
/// # Errors
///
/// `NotFinite`; `Equal` points; `OnCircle` or `OnLine` for more than six points on a circle or a
/// line.
pub fn nine_points(points: &[[f64; 2]; 9]) -> Result<NinePoints, Unsolved> {
    nine_points_reporting(points, |_| true)
}

/// Lists as [`nine_points`] does, with some dozen reports of the progress; stops where `report`
/// gives `false`.
///
/// # Errors
///
/// As [`nine_points`], and `Stopped`.
pub fn nine_points_reporting(
    points: &[[f64; 2]; 9],
    report: impl FnMut(Progress) -> bool,
) -> Result<NinePoints, Unsolved> {
    NinePointsSearch::new(points)?.progress(report).run()
}

//! Nine points of a path: all four-bars with a coupler point that passes them (Alt's problem of
//! 1923; Wampler, Morgan and Sommese, Journal of Mechanical Design 114, 1992).
//!
//! For almost all points there are 1442 triples of cognates. Those of some stored points are
//! followed while the points are changed into the given ones.

mod cognates;
mod curve;
mod equations;
mod path;
mod result;
mod search;
mod stored_solutions;
mod task;
#[cfg(test)]
mod tests;

pub use result::{NinePoints, PathFourBar, TRIPLES, Triple};

use super::error::Unsolved;
use linkage_design::Progress;
use search::SolutionSearch;
use std::vec::Vec;
use task::Task;

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
    mut report: impl FnMut(Progress) -> bool,
) -> Result<NinePoints, Unsolved> {
    let task = Task::new(points)?;
    let search = SolutionSearch::run(&task, &mut report)?;
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
    let fixed_joint = |triple: &Triple| triple.four_bars[0].four_bar.fixed;
    found.triples.sort_by(|a, b| {
        fixed_joint(a)
            .partial_cmp(&fixed_joint(b))
            .unwrap_or(core::cmp::Ordering::Equal)
    });
    Ok(found)
}

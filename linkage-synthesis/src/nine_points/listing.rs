//! The four-bars of the solutions that a search found.

use super::result::{NinePoints, TRIPLES, Triple};
use super::search::FoundSolution;
use super::task::Task;
use std::vec::Vec;

/// Lists the real four-bars of solutions, each of which is shown to differ from the others.
pub(super) fn listing(task: &Task, solutions: &[FoundSolution]) -> NinePoints {
    let mut found = NinePoints {
        triples: Vec::new(),
        complex: 0,
        undecided: TRIPLES.saturating_sub(solutions.len()),
    };
    for (certificate, _) in solutions {
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
    found
}

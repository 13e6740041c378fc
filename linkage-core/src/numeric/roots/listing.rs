//! Follows all paths and accepts their ends only if they fit together.

use super::consistency;
use super::continuum::is_continuum;
use super::endgame::{PathEnd, Root};
use super::homotopy::Homotopy;
use super::path_trace::{Trace, follow};
use super::path_tracker::Pace;
use super::polynomial::{self, Polynomial};
use super::precise;
use super::projective::ProjectivePoint;
use super::real;
use super::system::{Listing, Unlisted, Variable};
use alloc::vec::Vec;

/// The number of attempts to follow all paths, each from another start system and with smaller
/// steps.
const ATTEMPTS: usize = 4;
/// Multiple solutions that are examined for being part of a continuum.
const EXAMINED: usize = 8;

/// For at most `N` variables.
pub(super) fn list<const N: usize>(
    variables: &[Variable],
    target: &mut Vec<Polynomial>,
    paths: usize,
) -> Result<Listing, Unlisted> {
    polynomial::fill(target, N);
    let count = variables.len();
    let variables: [Variable; N] =
        core::array::from_fn(|j| variables.get(j).copied().unwrap_or(Variable::Length));
    let mut doubts = paths;
    for attempt in 0..ATTEMPTS {
        let mut homotopy = Homotopy::<N>::new(target, attempt);
        match listing(&mut homotopy, &variables, target, attempt) {
            Outcome::Listed(mut listing) => {
                for solution in listing.real.iter_mut().chain(&mut listing.meeting) {
                    solution.truncate(count);
                }
                return Ok(listing);
            }
            Outcome::Degenerate => return Err(Unlisted::Degenerate),
            Outcome::Doubtful(count) => doubts = count,
        }
    }
    let lost = doubts;
    Err(Unlisted::Lost { lost, paths })
}

/// The result of following all paths once.
enum Outcome {
    Listed(Listing),
    Degenerate,
    /// A number of uncertain ends.
    Doubtful(usize),
}

fn listing<const N: usize>(
    homotopy: &mut Homotopy<N>,
    variables: &[Variable],
    target: &[Polynomial],
    attempt: usize,
) -> Outcome {
    let pace = Pace::of_attempt(attempt);
    let starts = homotopy.starts();
    let mut traces: Vec<Trace<N>> = starts
        .iter()
        .map(|start| follow(homotopy, variables, pace, start))
        .collect();
    let (_, multiple) = sorted(&traces);
    let mut examined = multiple.iter().take(EXAMINED);
    if examined.any(|point| is_continuum(homotopy, point)) {
        return Outcome::Degenerate;
    }
    consistency::lose_single(&mut traces);
    precise::pursue(homotopy, variables, target, attempt, &mut traces);
    let (roots, multiple) = sorted(&traces);
    let doubts = consistency::count(&traces, &roots);
    if doubts > 0 {
        return Outcome::Doubtful(doubts);
    }
    let blurred = traces
        .iter()
        .filter(|trace| matches!(trace.end, PathEnd::Blurred));
    let blurred = blurred.count();
    // Those at infinity were of use for finding duplicates only.
    let inside = |root: &Root<N>| root.point.is_inside(variables);
    let roots: Vec<Root<N>> = roots.into_iter().filter(inside).collect();
    match real::list(homotopy, variables, &roots, blurred) {
        None => Outcome::Doubtful(roots.len()),
        Some(real) => Outcome::Listed(Listing {
            real,
            meeting: real::meeting(variables, &multiple),
            complex: roots.len(),
            multiple: multiple.len(),
            blurred,
            paths: traces.len(),
        }),
    }
}

/// The isolated solutions and the multiple ones.
fn sorted<const N: usize>(traces: &[Trace<N>]) -> (Vec<Root<N>>, Vec<ProjectivePoint<N>>) {
    let (mut roots, mut multiple) = (Vec::with_capacity(traces.len()), Vec::new());
    for trace in traces {
        match trace.end {
            PathEnd::Regular(root) => roots.push(root),
            PathEnd::Multiple(point) => multiple.push(point),
            PathEnd::Outside | PathEnd::Blurred | PathEnd::Lost => {}
        }
    }
    (roots, multiple)
}

//! Following one solution from the start system to the given one.

use super::endgame::{self, PathEnd};
use super::homotopy::Homotopy;
use super::path_tracker::{Pace, PathTracker};
use super::projective::ProjectivePoint;
use super::system::Variable;
use crate::numeric::complex_matrix::Vector;
use alloc::vec::Vec;

/// A path that has been followed.
pub(super) struct Trace<const N: usize> {
    /// The position at `WAYPOINT`, and the smallest pivot there. There all paths are apart.
    pub(super) waypoint: (ProjectivePoint<N>, f64),
    pub(super) end: PathEnd<N>,
    /// `t` and where it was shortly before its end, where numbers still have digits to spare.
    pub(super) mark: Option<(f64, ProjectivePoint<N>)>,
}

/// The value of `t` at which paths are compared, and behind which ends are looked for.
const WAYPOINT: f64 = 0.1;
const MOST_STEPS: usize = 500;
/// Ways and steps in `t` below this are nothing: the waypoint is reached, or a path sticks.
const SHORT: f64 = 1e-9;
/// With more digits paths are followed on from about here.
const RESUMED: f64 = 1e-7;

/// Follows the path that starts at `start`.
pub(super) fn follow<const N: usize>(
    homotopy: &mut Homotopy<N>,
    variables: &[Variable],
    pace: Pace,
    start: &Vector<N>,
) -> Trace<N> {
    homotopy.turn([false; N]);
    let nowhere = homotopy.projective_point(*start);
    let lost = Trace {
        waypoint: (nowhere, 0.0),
        end: PathEnd::Lost,
        mark: None,
    };
    let Some(mut tracker) = PathTracker::new(homotopy, variables, pace, start) else {
        return lost;
    };
    let mut steps = 0;
    loop {
        let rest = tracker.now().t - WAYPOINT;
        if rest < SHORT {
            break;
        }
        // Not one long and one tiny step.
        let longest = if tracker.step() < rest {
            0.5 * rest
        } else {
            rest
        };
        tracker.advance(longest);
        steps += 1;
        if steps > MOST_STEPS || tracker.step() < SHORT {
            return lost;
        }
    }
    let waypoint = (
        tracker.homotopy.projective_point(tracker.now().x),
        tracker.pivot,
    );
    let mut marks = Vec::new();
    let end = endgame::find(&mut tracker, MOST_STEPS - steps, &mut marks);
    let mark = marks.into_iter().rev().find(|(t, _)| *t > RESUMED);
    Trace {
        waypoint,
        end,
        mark,
    }
}

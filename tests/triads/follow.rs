//! Continuation of a pose in fine steps.

use crate::legs::{Leg, Pose, determinant, distance, reach, step};

/// Follows a pose while the legs move with an input from one value to another; `Err` with the input where
/// it ends in a turning point.
///
/// Towards a turning point the determinant goes to zero with the root of the distance: steps are so short
/// that none leads across, where another pose may begin close by.
pub(crate) fn follow(
    legs: impl Fn(f64) -> [Leg; 3],
    pose: Pose,
    way: (f64, f64),
) -> Result<Pose, f64> {
    follow_and_measure(legs, pose, way).map(|(pose, _)| pose)
}

/// The same with the smallest determinant on the way.
pub(crate) fn follow_and_measure(
    legs: impl Fn(f64) -> [Leg; 3],
    pose: Pose,
    (from, to): (f64, f64),
) -> Result<(Pose, f64), f64> {
    let (mut at, mut here, mut length) = (from, pose, (to - from) / 64.0);
    let mut last = determinant(&legs(from), &pose);
    let mut least = last.abs();
    while at != to {
        let longest = (5.0 * last * last).min(0.02);
        length = length.clamp(-longest, longest);
        let next = if (to - at).abs() <= length.abs() {
            to
        } else {
            at + length
        };
        let there = legs(next);
        let mut pose = here;
        let mut moved = f64::INFINITY;
        let mut contracts = true;
        for _ in 0..8 {
            let before = pose;
            step(&there, &mut pose);
            let now = distance(&before, &pose, reach(&there));
            contracts &= now.is_finite() && (now < 0.3 * moved || now < 1e-10);
            moved = now;
        }
        let near = distance(&here, &pose, reach(&there)) < 0.05;
        let determinant = determinant(&there, &pose);
        if contracts && near && (0.6..1.7).contains(&(determinant / last)) {
            (at, here, last) = (next, pose, determinant);
            least = least.min(determinant.abs());
            length *= 1.5;
        } else {
            length *= 0.25;
        }
        if length.abs().min(longest) < 1e-8 {
            return Err(at);
        }
    }
    Ok((here, least))
}

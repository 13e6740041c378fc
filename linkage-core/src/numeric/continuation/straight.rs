//! Straight ways from one position to another.

use super::Correction;
use super::follow::Follower;
use alloc::vec::Vec;

/// The first step, as a share of the way; a step that succeeds is doubled.
const FIRST: f64 = 0.125;

/// Steps that are a smaller share of the way are not tried.
const SHORTEST: f64 = 1e-9;

/// Beside a dead point, as near as the shortest steps lead, the determinant is a ten thousandth of
/// its first value; where it is more, the path has not ended at a dead point.
const VANISHED: f64 = 0.01;

/// Corrections on a way, at most: a way to a dead point takes some hundred.
const CORRECTIONS: usize = 4000;

/// Follows the solution `state` at the inputs `from` straight to the inputs `to`. Returns the share
/// of the way at which a dead point is met, where the solution ends; `None` if there is none on the
/// way, or if that is not found out quickly.
pub fn dead_point(
    correction: &mut dyn Correction,
    from: &[f64],
    state: &[f64],
    to: &[f64],
) -> Option<f64> {
    let mut state = state.to_vec();
    let mut follower = Follower::new(correction, from, &mut state, CORRECTIONS)?;
    let first = follower.settle(from, &mut state)?;
    let (mut share, mut step, mut determinant) = (0.0_f64, FIRST, first);
    while share < 1.0 && step >= SHORTEST {
        let next = (share + step).min(1.0);
        let x: Vec<f64> = from
            .iter()
            .zip(to)
            .map(|(a, b)| a + next * (b - a))
            .collect();
        let mut moved = state.clone();
        match follower.settle(&x, &mut moved) {
            Some(there) => {
                (share, state, determinant) = (next, moved, there);
                step *= 2.0;
            }
            None if follower.exhausted() => return None,
            None => step *= 0.5,
        }
    }
    (share < 1.0 && determinant.abs() < VANISHED * first.abs()).then_some(share)
}

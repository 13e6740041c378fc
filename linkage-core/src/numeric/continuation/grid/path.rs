//! Straight ways from a known solution to another place of a grid.

use super::super::follow::Follower;
use alloc::vec::Vec;

/// A step is as long as this share of the way at least, if the determinant has nearly vanished by
/// then: a dead point is there.
const SHORT: f64 = 1.0 / 256.0;

/// The shortest step: beside a dead point the determinant goes with the root of the distance, and
/// is a thousandth of its value at the start.
const SHORTEST: f64 = 1e-6;

/// A determinant below this share of the one at the reference has nearly vanished.
const VANISHING: f64 = 0.3;

/// The largest determinant beside a dead point, as a part of the one at the start of the path.
/// Where it is larger, the path has not ended at a dead point.
const LEFT: f64 = 0.1;

/// The end of a path.
pub(super) enum PathEnd {
    /// At the place, with this determinant.
    Reached(f64),
    /// At a dead point.
    DeadPoint,
    /// Somewhere else: the solution may exist.
    Lost,
}

/// Brings a solution from one place to another, in smaller steps if need be; the determinants are
/// those at the first place and at the reference.
pub(super) fn follow(
    follower: &mut Follower<'_>,
    from: &[f64],
    to: &[f64],
    state: &mut [f64],
    [first, reference]: [f64; 2],
) -> PathEnd {
    let (mut share, mut step, mut last) = (0.0_f64, 1.0_f64, first.abs());
    let mut moved = state.to_vec();
    loop {
        let next = (share + step).min(1.0);
        let x: Vec<f64> = if next < 1.0 {
            let pairs = from.iter().zip(to);
            pairs.map(|(a, b)| a + next * (b - a)).collect()
        } else {
            to.to_vec()
        };
        moved.copy_from_slice(state);
        match follower.settle(&x, &mut moved) {
            Some(determinant) => {
                state.copy_from_slice(&moved);
                if next == 1.0 {
                    return PathEnd::Reached(determinant);
                }
                (share, last) = (next, determinant.abs());
                step *= 2.0;
            }
            None if follower.exhausted() => return PathEnd::Lost,
            None => step *= 0.5,
        }
        let vanishing = last < VANISHING * reference.abs();
        if step < SHORT && vanishing {
            return PathEnd::DeadPoint;
        }
        if step < SHORTEST {
            let dead = vanishing || last < LEFT * first.abs();
            return if dead {
                PathEnd::DeadPoint
            } else {
                PathEnd::Lost
            };
        }
    }
}

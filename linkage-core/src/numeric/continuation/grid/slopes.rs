//! The slopes and second differences of the state along a cell.

use super::super::follow::Follower;
use super::layout::Layout;
use alloc::vec;
use alloc::vec::Vec;

/// Slopes are taken over this part of a cell, to both sides.
const PART: f64 = 1.0 / 16.0;

/// The changes of the state along the cell, input by input, and how much it bends along them.
pub(super) fn slopes(
    follower: &mut Follower<'_>,
    layout: &Layout<'_>,
    centre: &[f64],
    state: &[f64],
) -> (Vec<f64>, Vec<f64>) {
    let mut slopes = Vec::with_capacity(centre.len() * state.len());
    let mut bends = vec![0.0; centre.len()];
    for (axis, scale) in layout.0.iter().enumerate() {
        let mut side = |part: f64| {
            let mut x = centre.to_vec();
            x[axis] += part * scale.spacing();
            let mut moved = state.to_vec();
            follower.settle(&x, &mut moved).map(|_| moved)
        };
        let empty = scale.spacing() == 0.0;
        let (below, above) = if empty {
            (None, None)
        } else {
            (side(-PART), side(PART))
        };
        for (index, &here) in state.iter().enumerate() {
            let [down, up] =
                [&below, &above].map(|side| side.as_ref().map(|side| (side[index] - here) / PART));
            slopes.push(match (down, up) {
                (Some(down), Some(up)) => {
                    bends[axis] += (up + down).abs();
                    0.5 * (up - down)
                }
                (Some(down), None) => -down,
                (None, Some(up)) => up,
                (None, None) => 0.0,
            });
        }
    }
    (slopes, bends)
}

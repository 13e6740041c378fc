//! Crossings of a value.

use super::curve::Curve;
use super::monotone_pieces::{crossing, monotone_pieces};
use alloc::vec::Vec;

/// A place where a quantity passes a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<const N: usize> {
    /// The input.
    pub at: f64,
    /// The quantity and its derivatives there, as the curve's function gives them.
    pub jet: [f64; N],
}

/// The places of [`Curve::crossings`].
pub(super) fn crossings<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    value: f64,
) -> Vec<Crossing<N>> {
    // Over the seam of a cycle over which the quantity advances, it is higher by that.
    let advance = curve.source.advance.unwrap_or(0.0);
    let mut found = Vec::new();
    for part in &curve.solved {
        for pair in monotone_pieces(part).windows(2) {
            let [a, b] = [&pair[0].node, &pair[1].node];
            let mut pass = |level: f64, is_here: &dyn Fn(f64) -> bool| {
                if (a.jet[0] < level) == (b.jet[0] < level) {
                    return;
                }
                let node = crossing(&curve.source, a, b, level);
                if is_here(node.u) {
                    let node = curve.source.in_range(node);
                    let (at, jet) = (node.u, node.jet);
                    found.push(Crossing { at, jet });
                }
            };
            if advance == 0.0 {
                pass(value, &|_| true);
            } else {
                pass(value, &|u| u < curve.source.high);
                pass(value + advance, &|u| u >= curve.source.high);
            }
        }
    }
    found.sort_by(|a, b| a.at.total_cmp(&b.at));
    found
}

//! Where a quantity passes a value.

use super::course::Course;
use super::stations::{passage, stations};
use alloc::vec::Vec;

/// A place where a quantity passes a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage<const N: usize> {
    /// The input.
    pub at: f64,
    /// The quantity and its derivatives there, as the course's function gives them.
    pub jet: [f64; N],
}

/// The places of [`Course::passages`].
pub(super) fn passages<const N: usize, F: Fn(f64) -> [f64; N]>(
    course: &Course<N, F>,
    value: f64,
) -> Vec<Passage<N>> {
    // Over the seam of a cycle over which the quantity advances, it is higher by that.
    let advance = course.source.advance.unwrap_or(0.0);
    let mut found = Vec::new();
    for part in &course.solved {
        for pair in stations(part).windows(2) {
            let [a, b] = [&pair[0].node, &pair[1].node];
            let mut pass = |level: f64, is_here: &dyn Fn(f64) -> bool| {
                if (a.jet[0] < level) == (b.jet[0] < level) {
                    return;
                }
                let node = passage(&course.source, a, b, level);
                if is_here(node.u) {
                    let node = course.source.in_range(node);
                    let (at, jet) = (node.u, node.jet);
                    found.push(Passage { at, jet });
                }
            };
            if advance == 0.0 {
                pass(value, &|_| true);
            } else {
                pass(value, &|u| u < course.source.high);
                pass(value + advance, &|u| u >= course.source.high);
            }
        }
    }
    found.sort_by(|a, b| a.at.total_cmp(&b.at));
    found
}

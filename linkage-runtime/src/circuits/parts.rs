//! A slab in parts, in each of which the sign of a slack is shown by its bounds: no root between
//! two places is missed, however near to each other two of them are.

use alloc::vec::Vec;
use linkage_core::Enclosure;

/// Parts to begin with.
const FIRST: usize = 8;

/// Halvings of a part, at most. The remaining part is a ten millionth of the slab, where two zeros
/// of a slack are rounding.
const HALVINGS: usize = 22;

/// Bounds that are computed for one slack at most.
const MOST: usize = 3000;

/// Parts of a slab, of parameters from -1 to 1.
pub(super) struct Parts {
    /// Ends of the parts. A slack has one root at most between two neighbours, if its signs there
    /// differ.
    pub(super) ends: Vec<f64>,
    /// True if this is proven for all of them.
    pub(super) shown: bool,
}

/// Divides a slab until the bounds of a slack prove its sign, or its monotonicity, over every part.
/// A slack above `rounding` is positive. With `single`, only the existence of a slack counts.
pub(super) fn parts(slack: &dyn Fn(Enclosure) -> Enclosure, single: bool, rounding: f64) -> Parts {
    let at = |index: usize| 2.0 * (index as f64 / FIRST as f64) - 1.0;
    // The lowest one is on top.
    let mut open: Vec<(f64, f64, usize)> = (0..FIRST)
        .rev()
        .map(|k| (at(k), at(k + 1), HALVINGS))
        .collect();
    let mut parts = Parts {
        ends: Vec::new(),
        shown: true,
    };
    let mut left = MOST;
    while let Some((low, high, halvings)) = open.pop() {
        let known = left > 0 && {
            left -= 1;
            let bounds = slack(Enclosure::over(low, high));
            let ([least, most], [falls, rises]) = (bounds.range(), bounds.slopes());
            let one_sign = least > rounding || most < rounding;
            let one_sense = falls > 0.0 || rises < 0.0;
            least <= most
                && if single {
                    (most - least).is_finite()
                } else {
                    one_sign || one_sense
                }
        };
        if known || halvings == 0 || left == 0 {
            parts.shown &= known;
            parts.ends.push(high);
            continue;
        }
        let middle = 0.5 * (low + high);
        open.push((middle, high, halvings - 1));
        open.push((low, middle, halvings - 1));
    }
    parts
}

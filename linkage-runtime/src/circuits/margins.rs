//! The smallest margin of an assembly, and the inputs without one.

use super::branch::BranchEnd;
use super::leaf::{End, Leaf};
use super::levels::Levels;
use linkage_core::numeric::range::minimum;

/// Margins that are looked at along an assembly.
const MARGINS: usize = 120;

/// The input with the smallest margin, and the margin: NaN, with its input, if the margin of a
/// coupled group is not known everywhere. Groups with a closed form have a margin wherever their
/// slack is positive, except for rounding at a change point.
pub(super) fn least<M: Levels>(mechanism: &M, leaf: &Leaf, assembly: &M::Assembly) -> (f64, f64) {
    for (end, x) in leaf.ends.into_iter().zip(leaf.inputs) {
        if let End::Turning { .. } = end {
            return (x, 0.0);
        }
    }
    let [low, high] = leaf.inputs;
    minimum(low, high, MARGINS, |x| {
        let margin = margin(mechanism, assembly, x);
        if margin.is_nan() && !leaf.is_coupled() {
            f64::INFINITY
        } else {
            margin
        }
    })
}

fn margin<M: Levels>(mechanism: &M, assembly: &M::Assembly, x: f64) -> f64 {
    mechanism.survey(assembly, x).as_ref()[0]
}

/// An assembly that is nowhere at the input `lost` ends before it: its ends then, and its least
/// margin up to there. `known` is an input at which it is.
pub(super) fn up_to<M: Levels>(
    mechanism: &M,
    assembly: &M::Assembly,
    mut ends: [BranchEnd; 2],
    [known, lost]: [f64; 2],
) -> ([BranchEnd; 2], f64, f64) {
    let [mut here, mut there] = [known, lost];
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (here + there);
        if margin(mechanism, assembly, middle).is_nan() {
            there = middle
        } else {
            here = middle
        }
    }
    ends[usize::from(lost > known)] = BranchEnd::Lost(here);
    let [low, high] = ends.map(BranchEnd::x);
    let (at, least) = minimum(low, high, MARGINS, |x| margin(mechanism, assembly, x));
    if least.is_nan() && at != here && at != lost {
        return up_to(mechanism, assembly, ends, [known, at]);
    }
    (ends, at, least)
}

//! Where a figure is largest.

use alloc::vec::Vec;
use core::ops::Range;

use super::ToleranceError;
use crate::numeric::minimum::{Point, descend};

/// How many of the highest samples are refined.
const SUMMITS: usize = 16;

/// The largest value of a figure over a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The input at which it occurs.
    pub at: f64,
    /// The value.
    pub value: f64,
    /// At how many of the positions the figure is NaN: the mechanism cannot be assembled there.
    pub missing: usize,
}

/// The largest value of a figure over a range of the input: a scan of evenly spaced positions, both
/// ends among them, then a golden section search around the highest ones.
///
/// A summit that is narrower than the spacing may be missed. The number of evaluations is at most
/// `positions` and some thousand.
///
/// # Errors
///
/// `Nothing` for an empty or infinite range or less than two positions, `NotAssembled` if the figure
/// is NaN everywhere.
///
/// ```
/// use linkage_runtime::tolerance::largest;
///
/// let extreme = largest(0.0..3.0, 30, |x: f64| x.sin())?;
/// assert!((extreme.at - 1.570_796).abs() < 1e-6 && (extreme.value - 1.0).abs() < 1e-12);
/// # Ok::<(), linkage_runtime::tolerance::ToleranceError>(())
/// ```
pub fn largest(
    range: Range<f64>,
    positions: usize,
    mut figure: impl FnMut(f64) -> f64,
) -> Result<Extreme, ToleranceError> {
    let (low, width) = (range.start, range.end - range.start);
    if !(low.is_finite() && width.is_finite() && width > 0.0) {
        return Err(ToleranceError::Nothing {
            what: "the range is empty or infinite",
        });
    }
    if positions < 2 {
        return Err(ToleranceError::Nothing {
            what: "less than two positions",
        });
    }
    let last = positions - 1;
    let place = |i: usize| {
        if i == last {
            range.end
        } else {
            low + width * (i as f64 / last as f64)
        }
    };
    let xs: Vec<f64> = (0..positions).map(place).collect();
    let values: Vec<f64> = xs.iter().map(|&x| figure(x)).collect();
    let mut best = highest(&xs, &values)?;
    let point = |i: usize| Point {
        x: xs[i],
        margin: depth(values[i]),
    };
    for summit in summits(&values) {
        let (left, right) = (summit.saturating_sub(1), (summit + 1).min(last));
        let mut lower = |x: f64| depth(figure(x));
        let found = descend(point(left), point(right), &mut lower, |_| false);
        if -found.margin > best.value {
            (best.at, best.value) = (found.x, -found.margin);
        }
    }
    Ok(best)
}

/// The largest value of a figure over given positions, without refinement: for recorded cycles.
///
/// # Errors
///
/// `Nothing` without positions, `NotAssembled` if the figure is NaN at all of them.
pub fn largest_at(
    positions: &[f64],
    mut figure: impl FnMut(f64) -> f64,
) -> Result<Extreme, ToleranceError> {
    let values: Vec<f64> = positions.iter().map(|&x| figure(x)).collect();
    highest(positions, &values)
}

fn highest(xs: &[f64], values: &[f64]) -> Result<Extreme, ToleranceError> {
    if xs.is_empty() {
        return Err(ToleranceError::Nothing {
            what: "no positions",
        });
    }
    let missing = values.iter().filter(|value| value.is_nan()).count();
    let assembled = xs.iter().zip(values).filter(|(_, value)| !value.is_nan());
    let (&at, &value) = assembled
        .reduce(|best, next| if next.1 > best.1 { next } else { best })
        .ok_or(ToleranceError::NotAssembled)?;
    Ok(Extreme { at, value, missing })
}

/// The samples that are not below their neighbours, the highest first.
fn summits(values: &[f64]) -> Vec<usize> {
    let height = |i: usize| -depth(values[i]);
    let last = values.len() - 1;
    let is_summit = |&i: &usize| {
        height(i) > f64::NEG_INFINITY
            && height(i) >= height(i.saturating_sub(1))
            && height(i) >= height((i + 1).min(last))
    };
    let mut summits: Vec<usize> = (0..values.len()).filter(is_summit).collect();
    summits.sort_by(|&a, &b| height(b).total_cmp(&height(a)));
    summits.truncate(SUMMITS);
    summits
}

/// The figure turned upside down, with what is NaN highest.
fn depth(value: f64) -> f64 {
    if value.is_nan() {
        f64::INFINITY
    } else {
        -value
    }
}

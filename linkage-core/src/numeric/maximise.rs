//! The highest point of a function without derivatives over a range.

use super::golden_section::{Point, descend};
use alloc::vec::Vec;

/// The number of highest samples that are refined.
const SUMMITS: usize = 16;

/// The highest value found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maximum {
    pub at: f64,
    pub value: f64,
    /// At how many of the samples there was none.
    pub missing: usize,
}

/// Returns the highest value over `low` to `high`: the highest of evenly spaced positions (two or
/// more, both ends among them) and of golden section searches around the highest ones. `None` if
/// all of them are NaN.
pub fn maximise(
    [low, high]: [f64; 2],
    positions: usize,
    mut figure: impl FnMut(f64) -> f64,
) -> Option<Maximum> {
    let last = positions - 1;
    let position = |i: usize| {
        if i == last {
            high
        } else {
            low + (high - low) * (i as f64 / last as f64)
        }
    };
    let xs: Vec<f64> = (0..positions).map(position).collect();
    let values: Vec<f64> = xs.iter().map(|&x| figure(x)).collect();
    let mut best = highest_of(&xs, &values)?;
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
    Some(best)
}

/// The highest of given values that are not NaN.
pub fn highest_of(xs: &[f64], values: &[f64]) -> Option<Maximum> {
    let missing = values.iter().filter(|value| value.is_nan()).count();
    let assembled = xs.iter().zip(values).filter(|(_, value)| !value.is_nan());
    let (&at, &value) = assembled.reduce(|best, next| if next.1 > best.1 { next } else { best })?;
    Some(Maximum { at, value, missing })
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

/// Returns the figure turned upside down; NaN becomes the highest.
fn depth(value: f64) -> f64 {
    if value.is_nan() {
        f64::INFINITY
    } else {
        -value
    }
}

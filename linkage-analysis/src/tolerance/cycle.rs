//! The largest value of a figure.

use alloc::vec::Vec;
use core::ops::Range;

use super::ToleranceError;
use linkage_core::numeric::maximise::{self, Maximum};

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
/// `Nothing` for an empty or infinite range or less than two positions, `NotAssembled` if the
/// figure is NaN everywhere.
///
/// ```
/// use linkage_analysis::tolerance::largest;
///
/// let extreme = largest(0.0..3.0, 30, |x: f64| x.sin())?;
/// assert!((extreme.at - 1.570_796).abs() < 1e-6 && (extreme.value - 1.0).abs() < 1e-12);
/// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
/// ```
pub fn largest(
    range: Range<f64>,
    positions: usize,
    figure: impl FnMut(f64) -> f64,
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
    let maximum = maximise::maximise([low, range.end], positions, figure);
    maximum.map(extreme).ok_or(ToleranceError::NotAssembled)
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
    if values.is_empty() {
        return Err(ToleranceError::Nothing {
            what: "no positions",
        });
    }
    let maximum = maximise::highest_of(positions, &values);
    maximum.map(extreme).ok_or(ToleranceError::NotAssembled)
}

fn extreme(maximum: Maximum) -> Extreme {
    Extreme {
        at: maximum.at,
        value: maximum.value,
        missing: maximum.missing,
    }
}

//! The smallest value of a figure without derivatives.

use super::SummaryError;
use linkage_core::numeric::maximise::maximise;

/// The smallest value of a figure over a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minimum {
    /// The input at which it occurs.
    pub at: f64,
    /// The value.
    pub value: f64,
    /// At how many of the positions the figure is NaN: the mechanism cannot be assembled there.
    pub missing: usize,
}

/// The smallest value of a figure that has no derivative, such as `margin()`, over a range of the
/// input.
///
/// It is searched for, and not solved for as everything in a [`Curve`](super::Curve): a scan of
/// evenly spaced positions, both ends among them, then a golden section search around the lowest
/// ones. A hollow that is narrower than the spacing may be missed. The value is good to the last
/// digits, the place to about eight where the figure is smooth.
///
/// # Errors
///
/// `Range` for an empty or infinite range, `Positions` for less than two, `NotAssembled` if the
/// figure is NaN at all positions.
///
/// ```
/// use linkage_analysis::summary::minimise;
///
/// let margin = minimise((0.0, 6.0), 60, |phi: f64| 0.5 + 0.25 * phi.cos())?;
/// assert!((margin.value - 0.25).abs() < 1e-15 && (margin.at - std::f64::consts::PI).abs() < 1e-7);
/// # Ok::<(), linkage_analysis::summary::SummaryError>(())
/// ```
pub fn minimise(
    range: (f64, f64),
    positions: usize,
    mut figure: impl FnMut(f64) -> f64,
) -> Result<Minimum, SummaryError> {
    let (from, to) = range;
    if !((to - from).is_finite() && to > from) {
        return Err(SummaryError::Range { from, to });
    }
    if positions < 2 {
        return Err(SummaryError::Positions { positions });
    }
    let found = maximise([from, to], positions, |x| -figure(x));
    let summit = found.ok_or(SummaryError::NotAssembled { positions })?;
    Ok(Minimum {
        at: summit.at,
        value: -summit.value,
        missing: summit.missing,
    })
}

//! The input of a suspension: the travel of the wheel, with its range.

use super::roles::Points;
use super::suspension::Suspension;
use super::wheel_travel::reach;
use crate::error::ImportError;
use crate::placement::{Placement, difference, length};

/// The largest travel that is tried, as a part of the distance from the chassis to the wheel.
const MOST_TRAVEL: f64 = 0.15;

/// The part of a reach that is left out next to a dead point.
const BESIDE: f64 = 0.9;

/// The input, with the range in which the carrier is held.
pub(super) fn input(suspension: &Suspension, points: &Points) -> Result<String, ImportError> {
    let inner = points
        .by_role
        .values()
        .map(|point| length(difference(*point, suspension.centre)));
    let size = inner.fold(0.0, f64::max);
    let most = MOST_TRAVEL * size;
    let most = round_down(most);
    let found = reach(
        &suspension.holds,
        suspension.centre,
        most,
        size,
        |placement| {
            suspension
                .rocker
                .is_none_or(|rocker| rocker.is_reached(placement))
        },
    );
    let drawn = Placement::shifted([0.0; 3]);
    if suspension
        .rocker
        .is_some_and(|rocker| !rocker.is_reached(&drawn))
    {
        return Err(ImportError::new(
            "the push rod points at the axis of the rocker where it is drawn: a dead point",
        ));
    }
    if found[0] == 0.0 || found[1] == 0.0 {
        return Err(ImportError::new(
            "the drawn position is a dead point, or the carrier cannot move: the points do not make a suspension",
        ));
    }
    let ends = [0, 1].map(|end| match found[end].abs() == most {
        true => found[end],
        false => found[end].signum() * round_down(BESIDE * found[end].abs()),
    });
    let [low, high] = ends.map(|end| suspension.length(end));
    Ok(format!(
        "input travel = 0{} in {low}..{high};    // of the wheel centre, up is bump",
        suspension.unit
    ))
}

/// A length with two digits, not above the given one.
fn round_down(value: f64) -> f64 {
    let step = 10f64.powf(value.abs().log10().floor() - 1.0);
    let found = (value / step).floor() * step;
    // Without the noise of the product.
    format!("{found:.4e}").parse().unwrap_or(found)
}

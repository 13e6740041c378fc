//! The numbers of a pin that make sense.

use super::error::PinError;
use super::pin::{Limit, Member, Mounting, Pin, Width};

/// All numbers must be positive and finite; the gap may be 0.
pub(super) fn validate(pin: &Pin) -> Result<(), PinError> {
    positive("the load", pin.load)?;
    limit(
        pin.bending,
        "the strength in bending",
        "the safety factor in bending",
    )?;
    limit(
        pin.shear,
        "the strength in shear",
        "the safety factor in shear",
    )?;
    match pin.mounting {
        Mounting::Clevis { rod, fork, .. } => {
            member(rod, &ROD)?;
            member(fork, &FORK)
        }
        Mounting::Overhung { hub, seat, gap } => {
            member(hub, &HUB)?;
            member(seat, &SEAT)?;
            if gap >= 0.0 && gap.is_finite() {
                return Ok(());
            }
            Err(PinError::Invalid {
                what: "the gap between seat and hub",
                value: gap,
                expected: "finite and not negative",
            })
        }
    }
}

/// Names of the numbers of a member: width, ratio, strength, safety factor.
type Names = [&'static str; 4];

const ROD: Names = [
    "the width of the rod",
    "the ratio of the rod's width to the diameter",
    "the strength of the rod under pressure",
    "the safety factor of the rod's pressure",
];
const FORK: Names = [
    "the width of the fork's cheek",
    "the ratio of the fork's width to the diameter",
    "the strength of the fork under pressure",
    "the safety factor of the fork's pressure",
];
const HUB: Names = [
    "the width of the hub",
    "the ratio of the hub's width to the diameter",
    "the strength of the hub under pressure",
    "the safety factor of the hub's pressure",
];
const SEAT: Names = [
    "the length of the seat",
    "the ratio of the seat's length to the diameter",
    "the strength of the seat under pressure",
    "the safety factor of the seat's pressure",
];

fn member(member: Member, [width, ratio, strength, safety]: &Names) -> Result<(), PinError> {
    match member.width {
        Width::Fixed(length) => positive(width, length)?,
        Width::Ratio(multiple) => positive(ratio, multiple)?,
    }
    limit(member.pressure, strength, safety)
}

fn limit(limit: Limit, strength: &'static str, safety: &'static str) -> Result<(), PinError> {
    positive(strength, limit.strength)?;
    positive(safety, limit.safety)
}

pub(super) fn positive(what: &'static str, value: f64) -> Result<(), PinError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(PinError::Invalid {
        what,
        value,
        expected: "positive and finite",
    })
}

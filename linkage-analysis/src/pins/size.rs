//! The diameter that a pin needs.

use core::fmt;

use super::criterion::{BearingPart, Criterion};
use super::error::PinError;
use super::formulas::formulas;
use super::pin::{Limit, Mounting, Pin};
use super::validate::validate;
use linkage_core::format::rounded;

/// The diameter that a pin needs, with its criterion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// The diameter: the largest of those below.
    pub diameter: f64,
    /// The diameter required by bending.
    pub bending: f64,
    /// The diameter required by shear.
    pub shear: f64,
    /// The diameters required by the bearing pressures: in the rod and in the fork, or in the hub
    /// and in the seat.
    pub bearing: [f64; 2],
    /// The criterion that requires the largest diameter.
    pub governing: Criterion,
}

impl Pin {
    /// The diameter that is required, which no check exceeds and one just meets. Take the next
    /// larger [standard diameter](super::standard_diameter) or any other that is not smaller.
    ///
    /// # Errors
    ///
    /// `Invalid` for a number that is not positive and finite, `SeatTooShort` if an overhung pin's
    /// seat has a fixed length that no diameter makes up for, `OutOfRange` if a result overflows.
    pub fn diameter(&self) -> Result<Size, PinError> {
        validate(self)?;
        let mut required = [0.0; 4];
        let checks = formulas(self).into_iter().zip(self.limits());
        for (to, ((formula, limit), criterion)) in
            required.iter_mut().zip(checks.zip(self.criteria()))
        {
            *to = formula.diameter(self.load, limit.stress())?;
            if !(*to > 0.0 && to.is_finite()) {
                return Err(PinError::OutOfRange { criterion });
            }
        }
        let [bending, shear, bearing @ ..] = required;
        let largest = largest(&required);
        Ok(Size {
            diameter: required[largest],
            bending,
            shear,
            bearing,
            governing: self.criteria()[largest],
        })
    }

    /// The checks, in the order of their formulas.
    pub(super) fn criteria(&self) -> [Criterion; 4] {
        let parts = match self.mounting {
            Mounting::Clevis { .. } => [BearingPart::Rod, BearingPart::Fork],
            Mounting::Overhung { .. } => [BearingPart::Hub, BearingPart::Seat],
        };
        let [first, second] = parts.map(Criterion::Bearing);
        [Criterion::Bending, Criterion::Shear, first, second]
    }

    /// Their limits.
    pub(super) fn limits(&self) -> [Limit; 4] {
        let members = match self.mounting {
            Mounting::Clevis { rod, fork, .. } => [rod, fork],
            Mounting::Overhung { hub, seat, .. } => [hub, seat],
        };
        let [first, second] = members.map(|member| member.pressure);
        [self.bending, self.shear, first, second]
    }
}

/// The index of the largest number; the first of equal ones.
pub(super) fn largest(numbers: &[f64; 4]) -> usize {
    (1..4).fold(
        0,
        |best, i| if numbers[i] > numbers[best] { i } else { best },
    )
}

/// One line: the diameter, its criterion, and the requirement of each check.
impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second] = self.bearing;
        write!(
            f,
            "{} by {} (bending {}, shear {}, bearing {} and {})",
            rounded(self.diameter),
            self.governing,
            rounded(self.bending),
            rounded(self.shear),
            rounded(first),
            rounded(second)
        )
    }
}

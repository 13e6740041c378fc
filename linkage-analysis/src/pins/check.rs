//! The stresses of a pin.

use super::criterion::Criterion;
use super::error::PinError;
use super::formulas::formulas;
use super::pin::{Limit, Pin};
use super::size::largest;
use super::validate::{positive, validate};

/// A stress that exceeds the allowable one by this share or less does so by rounding: the diameter
/// that is required was computed.
const ROUNDING: f64 = 1e-12;

/// A stress of a pin of known diameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stress {
    /// The stress.
    pub value: f64,
    /// The allowable stress.
    pub allowable: f64,
    /// The safety factor that there is: strength over stress.
    pub safety: f64,
}

impl Stress {
    fn new(value: f64, limit: Limit) -> Self {
        Self {
            value,
            allowable: limit.stress(),
            safety: limit.strength / value,
        }
    }

    /// The stress as part of the allowable one: above 1 it is too large.
    #[must_use]
    pub fn utilization(&self) -> f64 {
        self.value / self.allowable
    }
}

/// The stresses of a pin of known diameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// Bending stress of the pin.
    pub bending: Stress,
    /// Shear stress of the pin.
    pub shear: Stress,
    /// Bearing pressures: in the rod and in the fork, or in the hub and in the seat.
    pub bearing: [Stress; 2],
    /// The criterion with the largest part of its allowable stress.
    pub governing: Criterion,
}

impl Check {
    /// Returns true if no stress exceeds its allowable stress, except for rounding (1e-12 of it):
    /// true for the required diameter.
    #[must_use]
    pub fn holds(&self) -> bool {
        let [first, second] = self.bearing;
        let stresses = [self.bending, self.shear, first, second];
        stresses.iter().all(|s| s.utilization() <= 1.0 + ROUNDING)
    }
}

impl Pin {
    /// The stresses at a diameter.
    ///
    /// # Errors
    ///
    /// `Invalid` for a number that is not positive and finite, `OutOfRange` if a stress overflows.
    pub fn check(&self, diameter: f64) -> Result<Check, PinError> {
        validate(self)?;
        positive("the diameter", diameter)?;
        let criteria = self.criteria();
        let limits = self.limits();
        let stresses = formulas(self).map(|formula| formula.stress(self.load, diameter));
        let beyond = |stress: &f64| !(*stress > 0.0 && stress.is_finite());
        if let Some(index) = stresses.iter().position(beyond) {
            return Err(PinError::OutOfRange {
                criterion: criteria[index],
            });
        }
        let [bending, shear, first, second] =
            core::array::from_fn(|i| Stress::new(stresses[i], limits[i]));
        let used = [bending, shear, first, second].map(|stress: Stress| stress.utilization());
        Ok(Check {
            bending,
            shear,
            bearing: [first, second],
            governing: criteria[largest(&used)],
        })
    }
}

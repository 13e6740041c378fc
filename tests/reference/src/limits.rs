//! The errors that are accepted.

use crate::Measure;

/// The largest errors that are accepted, in the units that [`Measure`] names.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// For [`Measure::Position`].
    pub condition: f64,
    /// For [`Measure::Value`].
    pub value: f64,
    /// For [`Measure::Margin`].
    pub margin: f64,
    /// For first derivatives.
    pub first: f64,
    /// For second and mixed derivatives.
    pub second: f64,
    /// For third derivatives.
    pub third: f64,
}

impl Limits {
    /// Limits of positions by `condition`, `value` and `margin`, and of first, second and third
    /// derivatives.
    pub const fn new(
        [condition, value, margin]: [f64; 3],
        [first, second, third]: [f64; 3],
    ) -> Self {
        Self {
            condition,
            value,
            margin,
            first,
            second,
            third,
        }
    }

    /// For mechanisms of extreme proportions: wider limits for derivatives, which are small
    /// differences where a mechanism all but turns as a whole.
    pub fn any_proportions(self) -> Self {
        Self {
            value: 2.0 * self.value,
            margin: 2.0 * self.margin,
            ..self.times(10.0)
        }
    }

    /// All limits but that of positions times a factor, for a written form that does not fit the
    /// mechanism: an unknown point far from the origin at the end of a short link carries roundings
    /// of its distance.
    pub fn times(self, factor: f64) -> Self {
        Self {
            condition: self.condition,
            value: factor * self.value,
            margin: factor * self.margin,
            first: factor * self.first,
            second: factor * self.second,
            third: factor * self.third,
        }
    }

    pub(crate) fn of(&self, measure: Measure) -> f64 {
        match measure {
            Measure::Position => self.condition,
            Measure::Value => self.value,
            Measure::Margin => self.margin,
            Measure::First | Measure::Sensitivity => self.first,
            Measure::Second | Measure::Mixed | Measure::Pair => self.second,
            Measure::Third | Measure::MixedSecond => self.third,
        }
    }
}

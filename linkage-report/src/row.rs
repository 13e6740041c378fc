//! A figure and its quantity.

use std::string::String;

/// A figure of the cycle, such as a limit or a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct SummaryRow {
    /// The quantity that it is about, such as `p10.x`.
    pub quantity: String,
    /// The kind of figure: `stroke`, `highest`, `smallest transmission angle`.
    pub what: String,
    /// Its value.
    pub value: f64,
    /// The unit of the value: `mm`, `rad`; empty for a number.
    pub unit: String,
    /// The input at which it occurs, in the unit of the input.
    pub at: Option<f64>,
}

impl SummaryRow {
    /// A figure; [`at`](Self::at) is left open.
    pub fn new(
        quantity: impl Into<String>,
        what: impl Into<String>,
        value: f64,
        unit: impl Into<String>,
    ) -> Self {
        Self {
            quantity: quantity.into(),
            what: what.into(),
            value,
            unit: unit.into(),
            at: None,
        }
    }

    /// The same, with the input at which it occurs.
    #[must_use]
    pub fn at_input(mut self, input: f64) -> Self {
        self.at = Some(input);
        self
    }
}

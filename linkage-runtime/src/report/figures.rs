//! Figures of the cycle.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::Report;
use crate::summary::{Course, Extreme, Extremes};

/// A figure of the cycle, such as a limit or a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct SummaryRow {
    /// The quantity that it is about, such as `p10.x`.
    pub quantity: String,
    /// What it is: `stroke`, `highest`, `smallest transmission angle`.
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
    pub fn at(mut self, input: f64) -> Self {
        self.at = Some(input);
        self
    }
}

impl Report {
    /// Figures of the cycle.
    #[must_use]
    pub fn summary(mut self, rows: impl IntoIterator<Item = SummaryRow>) -> Self {
        self.summary.extend(rows);
        self
    }

    /// The figures of a quantity's course, in its unit: limits, stroke, extreme derivatives by the input as far as their own
    /// derivatives were given, time ratio.
    #[must_use]
    pub fn course<const N: usize, F: Fn(f64) -> [f64; N]>(
        self,
        quantity: &str,
        unit: &str,
        course: &Course<N, F>,
    ) -> Self {
        let row = |what: &str, value: f64, unit: &str| SummaryRow::new(quantity, what, value, unit);
        let at = |what: &str, extreme: Extreme, unit: &str| {
            row(what, extreme.value, unit).at(extreme.at)
        };
        let input = self.input.unit;
        let position = course.position();
        let mut rows = Vec::from([
            at("lowest", position.lowest, unit),
            at("highest", position.highest, unit),
            row("stroke", position.stroke(), unit),
        ]);
        for (order, name) in [(1, "first derivative"), (2, "second derivative")] {
            if let Some(Extremes {
                lowest, highest, ..
            }) = course.extremes_of(order)
            {
                let unit = derivative(unit, input, order);
                rows.push(at(&format!("lowest {name}"), *lowest, &unit));
                rows.push(at(&format!("highest {name}"), *highest, &unit));
            }
        }
        if let Some(time) = course.time_ratio() {
            rows.push(row("rises in", time.rise, input));
            rows.push(row("falls in", time.fall, input));
            rows.push(row("time ratio", time.ratio(), ""));
        }
        self.summary(rows)
    }
}

/// The unit of a derivative by the input.
fn derivative(unit: &str, input: &str, order: usize) -> String {
    let unit = if unit.is_empty() { "1" } else { unit };
    match order {
        1 => format!("{unit}/{input}"),
        _ => format!("{unit}/{input}^{order}"),
    }
}

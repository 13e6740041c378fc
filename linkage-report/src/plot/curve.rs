//! Curves of a plot, with their bands.

use std::string::{String, ToString};
use std::vec::Vec;

use crate::accuracy::BandKind;
use crate::palette::Style;

/// Numbers as they are shown.
#[derive(Clone, Debug)]
pub(super) struct Quantity {
    pub(super) name: String,
    pub(super) unit: String,
    /// True for values that were given in radians.
    pub(super) from_radians: bool,
    pub(super) values: Vec<f64>,
}

#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) section: usize,
    pub(super) quantity: Quantity,
    pub(super) bands: Vec<Band>,
    /// The style in the report. Without one it follows from the order.
    pub(super) style: Option<Style>,
    pub(super) thin: bool,
}

#[derive(Clone, Debug)]
pub(super) struct Band {
    pub(super) kind: BandKind,
    pub(super) half: Vec<f64>,
}

impl Quantity {
    /// Angles become degrees.
    pub(super) fn new(name: &str, unit: &str, values: &[f64]) -> Self {
        Self {
            name: name.to_string(),
            unit: String::from(if unit == "rad" { "deg" } else { unit }),
            from_radians: unit == "rad",
            values: shown(unit == "rad", values),
        }
    }
}

impl Curve {
    pub(super) fn style(&self, index: usize) -> Style {
        self.style.unwrap_or(Style::numbered(index))
    }

    pub(super) const fn width(&self) -> f64 {
        if self.thin { 1.0 } else { 1.8 }
    }
}

pub(super) fn shown(radians: bool, values: &[f64]) -> Vec<f64> {
    let show = |x: &f64| if radians { x.to_degrees() } else { *x };
    values.iter().map(show).collect()
}

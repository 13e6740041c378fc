//! Quantities that are drawn as arrows.

use std::string::String;
use std::vec::Vec;

use super::geometry::moved;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Length and half the width of an arrow's head.
const HEAD: [f64; 2] = [2.4, 0.9];

/// A quantity that is drawn as an arrow at a point.
#[derive(Clone, Debug)]
pub(super) struct Vector<'a> {
    pub(super) point: usize,
    pub(super) name: String,
    pub(super) components: Vec<&'a [f64]>,
    pub(super) unit: &'static str,
    /// Units of length of the mechanism for a unit of the quantity.
    pub(super) length: f64,
}

impl Vector<'_> {
    pub(super) fn value_at(&self, row: usize) -> [f64; 3] {
        let mut value = [0.0; 3];
        for (to, component) in value.iter_mut().zip(&self.components) {
            *to = component[row];
        }
        value
    }

    /// Returns the step from the point to the end of the arrow.
    pub(super) fn step(&self, row: usize) -> [f64; 3] {
        self.value_at(row).map(|x| self.length * x)
    }
}

/// A filled head at the end of a line.
pub(super) fn head(svg: &mut Svg, from: [f64; 2], to: [f64; 2], colour: Colour) {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let way = [0, 1].map(|k| (to[k] - from[k]) / length);
    let corners = [
        to,
        moved(to, way, -HEAD[0], HEAD[1]),
        moved(to, way, -HEAD[0], -HEAD[1]),
    ];
    svg.add(Element::polygon(corners).class("head").fill(colour));
}

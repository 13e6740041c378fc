//! The parts of a machine with their colours, below the title.

use std::vec::Vec;

use super::Drawing;
use super::parts::OUTLINE;
use super::sheet::Sheet;
use crate::report::colour::Colour;
use crate::report::svg::{Element, Svg};

/// Height of a line, size of the letters and average width of one.
const LINE: f64 = 5.0;
const SIZE: f64 = 3.2;
const LETTER: f64 = 1.95;
/// Between the edges of the sheet and the entries; width and height of a swatch; between it and its name, and to the next swatch.
const LEFT: f64 = 6.0;
const SWATCH: [f64; 2] = [6.0, 2.4];
const APART: [f64; 2] = [1.8, 6.0];

/// An entry: its line, where it begins, its colour and its name.
struct Entry {
    line: usize,
    left: f64,
    hue: usize,
    name: &'static str,
}

/// What the legend takes of a sheet of this width.
pub(super) fn height(drawing: &Drawing<'_>, width: f64) -> f64 {
    let last = entries(drawing, width).pop();
    last.map_or(0.0, |entry| LINE * (entry.line + 1) as f64)
}

fn entries(drawing: &Drawing<'_>, width: f64) -> Vec<Entry> {
    let (mut line, mut left) = (0, LEFT);
    let parts = drawing.shown.picture.parts.iter().enumerate();
    let entries = parts.map(|(hue, part)| {
        let long = SWATCH[0] + APART[0] + LETTER * part.name.chars().count() as f64;
        if left > LEFT && left + long > width - LEFT {
            (line, left) = (line + 1, LEFT);
        }
        let entry = Entry {
            line,
            left,
            hue,
            name: part.name,
        };
        left += long + APART[1];
        entry
    });
    entries.collect()
}

impl Drawing<'_> {
    pub(super) fn legend(&self, svg: &mut Svg, sheet: &Sheet<'_>) {
        for entry in entries(self, sheet.size[0]) {
            let group = Element::new("g").class("part").set("data-name", entry.name);
            svg.group(group, |svg| {
                let middle = self.head() + LINE * (entry.line as f64 + 0.5);
                let [width, high] = SWATCH;
                let corner = |(x, y): (f64, f64)| [entry.left + x * width, middle + y * high];
                let corners = [(0.0, -0.5), (1.0, -0.5), (1.0, 0.5), (0.0, 0.5)];
                let swatch = Element::polygon(corners.map(corner));
                svg.add(
                    swatch
                        .fill(Colour::Link(entry.hue))
                        .stroke(Colour::Ink, OUTLINE),
                );
                let at = [entry.left + width + APART[0], middle + 0.35 * SIZE];
                svg.words(Element::text(at, SIZE).fill(Colour::Ink), entry.name);
            });
        }
    }
}

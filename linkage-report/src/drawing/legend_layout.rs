//! Places of the entries of the legend.

use std::vec::Vec;

use super::options::Drawing;
use super::sizes::LETTER_WIDTH;

/// Height of a line.
pub(super) const LINE: f64 = 5.0;
/// Between the edges of the sheet and the entries; width and height of a swatch; between it and its
/// name, and to the next swatch.
pub(super) const LEFT: f64 = 6.0;
pub(super) const SWATCH: [f64; 2] = [6.0, 2.4];
pub(super) const APART: [f64; 2] = [1.8, 6.0];

/// An entry: its line, where it begins, its colour and its name.
pub(super) struct Entry {
    pub(super) line: usize,
    pub(super) left: f64,
    pub(super) hue: usize,
    pub(super) name: &'static str,
}

/// Returns the height of the legend on a sheet of this width.
pub(super) fn height(drawing: &Drawing<'_>, width: f64) -> f64 {
    let last = entries(drawing, width).pop();
    last.map_or(0.0, |entry| LINE * (entry.line + 1) as f64)
}

pub(super) fn entries(drawing: &Drawing<'_>, width: f64) -> Vec<Entry> {
    let (mut line, mut left) = (0, LEFT);
    let parts = drawing.shown.picture.parts.iter().enumerate();
    let entries = parts.map(|(hue, part)| {
        let long = SWATCH[0] + APART[0] + LETTER_WIDTH * part.name.chars().count() as f64;
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

//! Names of curves beside their panel.

use std::string::String;

use super::super::palette::Style;
use super::stroke::{dashed, shade};
use crate::accuracy::BandKind;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

const LINE: f64 = 19.0;
const SAMPLE: f64 = 30.0;
/// Average width of a character of 12 pixels, rather too wide: fonts differ.
const CHARACTER: f64 = 7.2;

/// A line of the legend.
pub(super) struct Entry<'a> {
    pub(super) name: &'a str,
    /// The style of its curve.
    pub(super) style: Style,
    pub(super) width: f64,
    /// `None` for the curve itself.
    pub(super) band: Option<BandKind>,
}

impl Entry<'_> {
    fn words(&self) -> String {
        match self.band {
            None => String::from(self.name),
            Some(kind) => std::format!("{} \u{b1} {}", self.name, kind.name()),
        }
    }
}

/// The width that a legend takes beside its panel.
pub(super) fn width(entries: &[Entry<'_>]) -> f64 {
    let lengths = entries.iter().map(|entry| entry.words().chars().count());
    match lengths.max() {
        None => 0.0,
        Some(longest) => SAMPLE + 8.0 + CHARACTER * longest as f64,
    }
}

/// The height that so many lines take beside their panel.
pub(super) fn height(lines: usize) -> f64 {
    LINE * lines as f64
}

pub(super) fn draw(svg: &mut Svg, [left, top]: [f64; 2], entries: &[Entry<'_>]) {
    for (line, entry) in entries.iter().enumerate() {
        let y = top + LINE * line as f64;
        let colour = entry.style.colour();
        match entry.band {
            None => svg.add(dashed(
                Element::line([left, y], [left + SAMPLE, y]).stroke(colour, entry.width + 0.2),
                entry.style,
            )),
            Some(kind) => svg.add(
                Element::new("rect")
                    .number("x", left)
                    .number("y", y - 6.0)
                    .number("width", SAMPLE)
                    .number("height", 12.0)
                    .fill(colour)
                    .number("fill-opacity", shade(kind)),
            ),
        }
        let words = Element::text([left + SAMPLE + 8.0, y + 4.0], 12.0);
        svg.words(words.class("legend").fill(Colour::Ink), &entry.words());
    }
}

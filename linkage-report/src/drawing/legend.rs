//! The parts of a machine with their colours, below the title.

use super::caption;
use super::legend_layout::{APART, LINE, SWATCH, entries};
use super::options::Drawing;
use super::sheet::Sheet;
use super::sizes::{LETTER_SIZE, OUTLINE};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

pub(super) fn legend(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>) {
    for entry in entries(drawing, sheet.size[0]) {
        let group = Element::new("g").class("part").set("data-name", entry.name);
        svg.group(group, |svg| {
            let middle = caption::title_end(drawing) + LINE * (entry.line as f64 + 0.5);
            let [width, high] = SWATCH;
            let corner = |(x, y): (f64, f64)| [entry.left + x * width, middle + y * high];
            let corners = [(0.0, -0.5), (1.0, -0.5), (1.0, 0.5), (0.0, 0.5)];
            let swatch = Element::polygon(corners.map(corner));
            svg.add(
                swatch
                    .fill(Colour::Link(entry.hue))
                    .stroke(Colour::Ink, OUTLINE),
            );
            let at = [entry.left + width + APART[0], middle + 0.35 * LETTER_SIZE];
            svg.words(Element::text(at, LETTER_SIZE).fill(Colour::Ink), entry.name);
        });
    }
}

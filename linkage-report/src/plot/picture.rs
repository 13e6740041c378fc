//! The picture of a plot.

use std::string::String;
use std::vec::Vec;

use super::axes::Axis;
use super::builder::Plot;
use super::legend::Entry;
use super::panel::{Frame, Panel};
use super::{legend, missing, panel};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// The least width of a panel.
const NARROWEST: f64 = 160.0;

pub(super) fn drawn(plot: &Plot) -> String {
    let panels = panels(plot);
    let legends: Vec<Vec<Entry<'_>>> = panels.iter().map(Panel::legend).collect();
    let beside = legends.iter().map(|l| legend::width(l)).fold(0.0, f64::max);
    let notes = missing::gap_notes(plot);
    // The legend determines the width and the height.
    let total = plot.width.max(panel::LEFT + NARROWEST + beside + 24.0);
    let lines = legends.iter().map(Vec::len).max().unwrap_or(0);
    let tall = plot.height.max(legend::height(lines));

    let top = if plot.title.is_empty() { 14.0 } else { 44.0 };
    let below = top + panels.len() as f64 * (tall + panel::SPACE) - panel::SPACE;
    let height = below + 54.0 + 18.0 * notes.len() as f64;
    let mut svg = Svg::new(total, height, "", &described(plot));
    if !plot.title.is_empty() {
        let title = Element::text([panel::LEFT, 26.0], 16.0).set("font-weight", 600);
        svg.words(title.fill(Colour::Ink), &plot.title);
    }
    let axis = Axis::abscissa(&plot.abscissa);
    for (index, (panel, legend)) in panels.iter().zip(&legends).enumerate() {
        let above = top + index as f64 * (tall + panel::SPACE);
        let frame = Frame {
            left: panel::LEFT,
            right: total - beside - 24.0,
            top: above,
            bottom: above + tall,
        };
        panel.draw(&mut svg, frame, &axis, index + 1 == panels.len());
        legend::draw(&mut svg, [frame.right + 14.0, above + 12.0], legend);
    }
    for (line, note) in notes.iter().enumerate() {
        let at = [panel::LEFT, below + 64.0 + 18.0 * line as f64];
        let words = Element::text(at, 12.0).class("note").fill(Colour::Muted);
        svg.words(words, note);
    }
    svg.finish()
}

/// Curves by section and unit, in the order of their first one.
fn panels(plot: &Plot) -> Vec<Panel<'_>> {
    let mut panels: Vec<Panel<'_>> = Vec::new();
    for curve in &plot.curves {
        match panels.iter_mut().find(|panel| panel.takes(curve)) {
            Some(panel) => panel.curves.push(curve),
            None => panels.push(Panel {
                abscissa: &plot.abscissa.values,
                curves: Vec::from([curve]),
                gaps: missing::gaps(plot),
            }),
        }
    }
    panels
}

/// Returns the description of the picture for screen readers.
fn described(plot: &Plot) -> String {
    let names = plot.curves.iter().map(|c| c.quantity.name.as_str());
    let names = names.collect::<Vec<_>>().join(", ");
    let over = &plot.abscissa.name;
    match plot.title.as_str() {
        "" => std::format!("{names} over {over}"),
        title => std::format!("{title}: {names} over {over}"),
    }
}

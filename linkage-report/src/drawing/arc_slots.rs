//! Curved slots on paper.

use std::vec::Vec;

use super::options::Drawing;
use super::room::Taken;
use super::sheet::Sheet;
use super::sizes::{JOINT, OUTLINE};
use crate::arc_slot::{self, ArcSlot};
use linkage_core::{Guide, GuideOn};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Width of the gap: the pin is in it. Width of the link around it on each side.
const GAP: f64 = 2.0 * JOINT + 0.9;
const WALL: f64 = 1.1;
/// Distance of hatching, its length outwards and along the arc.
const HATCH: [f64; 3] = [1.5, 1.4, 1.4];

/// Draws the slots of the frame, with hatching along the outer side.
pub(super) fn on_frame(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for (_, guide) in arc_slot::arcs_on(&drawing.shown, true) {
        let Some(slot) = ArcSlot::new(&drawing.shown, guide, row) else {
            continue;
        };
        let line = on_paper(sheet, &slot);
        let group = Element::new("g").class("guide").class("arc");
        svg.group(group.set("data-name", guide.name), |svg| {
            hatched(svg, sheet, &slot);
            gap(svg, &line);
            let middle = Element::polyline(line).stroke(Colour::Frame, 0.18);
            svg.add(middle.set("stroke-dasharray", "4 1 0.8 1"));
        });
    }
}

/// Draws the slots of links, and those that are links of their own.
pub(super) fn on_links(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for (index, guide) in arc_slot::arcs_on(&drawing.shown, false) {
        let Some(slot) = ArcSlot::new(&drawing.shown, guide, row) else {
            continue;
        };
        let line = on_paper(sheet, &slot);
        let colour = Colour::Link(match guide.on {
            GuideOn::Link(link) => drawing.shown.link_hue(link),
            GuideOn::Frame | GuideOn::Itself => drawing.shown.guide_hue(index),
        });
        let group = Element::new("g").class("link").class("arc");
        svg.group(group.set("data-name", guide.name), |svg| {
            let width = GAP + 2.0 * WALL;
            svg.add(stroke(&line, Colour::Ink, width + 2.0 * OUTLINE));
            svg.add(stroke(&line, colour, width));
            gap(svg, &line);
        });
    }
}

/// Draws thin lines for all slots.
pub(super) fn ghost(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for (_, guide) in arc_slot::arcs_on(&drawing.shown, false) {
        if let Some(slot) = ArcSlot::new(&drawing.shown, guide, row) {
            svg.add(stroke(&on_paper(sheet, &slot), Colour::Frame, 0.25));
        }
    }
}

/// Returns the area of an arc; none of a straight guide.
pub(super) fn covers(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    guide: &Guide,
    row: usize,
) -> Vec<Taken> {
    let Some(slot) = ArcSlot::new(&drawing.shown, guide, row) else {
        return Vec::new();
    };
    let beside = match guide.on {
        GuideOn::Frame => HATCH[1],
        GuideOn::Link(_) | GuideOn::Itself => WALL,
    };
    let line = on_paper(sheet, &slot);
    let pieces = line.windows(2);
    pieces
        .map(|ends| Taken::new(ends, 0.5 * GAP + beside + OUTLINE))
        .collect()
}

fn on_paper(sheet: &Sheet<'_>, slot: &ArcSlot) -> Vec<[f64; 2]> {
    let line = slot.middle_line().into_iter();
    line.filter_map(|[x, y]| sheet.on_paper([x, y, 0.0]))
        .collect()
}

/// Two concentric arcs with round ends.
fn gap(svg: &mut Svg, line: &[[f64; 2]]) {
    svg.add(stroke(line, Colour::Ink, GAP + 2.0 * OUTLINE));
    svg.add(stroke(line, Colour::Paper, GAP));
}

fn stroke(line: &[[f64; 2]], colour: Colour, width: f64) -> Element {
    let line = Element::polyline(line.iter().copied());
    line.stroke(colour, width).set("stroke-linecap", "round")
}

fn hatched(svg: &mut Svg, sheet: &Sheet<'_>, slot: &ArcSlot) {
    let [distance, out, beside] = HATCH.map(|length| length / sheet.factor);
    let edge = slot.radius + 0.5 * GAP / sheet.factor;
    svg.group(Element::new("g").class("hatching"), |svg| {
        for angle in slot.angles(distance / edge) {
            let ends = [
                slot.point(edge, angle),
                slot.point(edge + out, angle - beside / edge),
            ];
            if let [Some(a), Some(b)] = ends.map(|[x, y]| sheet.on_paper([x, y, 0.0])) {
                svg.add(Element::line(a, b).stroke(Colour::Frame, 0.3));
            }
        }
    });
}

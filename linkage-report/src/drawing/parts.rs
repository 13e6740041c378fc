//! Moving parts: links, sliders, joints, ghosts.

use std::vec::Vec;

use super::geometry::{hull_places, moved};
use super::options::Drawing;
use super::sheet::Sheet;
use super::sizes::{BEYOND, BLOCK, JOINT, OUTLINE};
use super::{arc_slots, signs};
use crate::arc_slot;
use linkage_core::{GuideOn, GuideShape, PointKind};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Width of a bar, and of a link's rail.
const BAR: f64 = 2.4;
const RAIL: f64 = 1.3;
/// Radius of a point of a block that nothing turns on.
const DOT: f64 = 0.55;
/// Radius of a point that no link carries.
const LOOSE: f64 = 1.5;

/// A body on paper: a link with all its points, or the rail of a guide.
pub(super) struct Body<'a> {
    name: &'a str,
    pub(super) corners: Vec<[f64; 2]>,
    pub(super) width: f64,
    colour: Colour,
    nearness: f64,
}

impl Body<'_> {
    fn is_plate(&self) -> bool {
        self.corners.len() > 2
    }
}

/// Bars, plates and rails, the farthest first. Plates have the corners that they have at the row
/// `form`, so that all drawings of one that moves have the same.
pub(super) fn links(
    drawing: &Drawing<'_>,
    svg: &mut Svg,
    sheet: &Sheet<'_>,
    row: usize,
    form: usize,
) {
    let mut bodies = bodies(drawing, sheet, row, form, false);
    bodies.sort_by(|a, b| a.nearness.total_cmp(&b.nearness));
    let mut arcs = arc_slot::arcs_on(&drawing.shown, false);
    if arcs.next().is_some() {
        // A slot is in its plate, and below the bars with the pins.
        let (plates, bars) = bodies.into_iter().partition(Body::is_plate);
        draw(svg, plates);
        arc_slots::on_links(drawing, svg, sheet, row);
        draw(svg, bars);
    } else {
        draw(svg, bodies);
    }
}

fn draw(svg: &mut Svg, bodies: Vec<Body>) {
    for body in bodies {
        let group = Element::new("g").class("link").set("data-name", body.name);
        let group = if body.is_plate() {
            group.number("opacity", 0.9)
        } else {
            group
        };
        svg.group(group, |svg| {
            let shape =
                || Element::polygon(body.corners.iter().copied()).set("stroke-linecap", "round");
            svg.add(
                shape()
                    .fill(Colour::Ink)
                    .stroke(Colour::Ink, body.width + 2.0 * OUTLINE),
            );
            svg.add(shape().fill(body.colour).stroke(body.colour, body.width));
        });
    }
}

/// Lines and outlines without width.
pub(super) fn ghost(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for body in bodies(drawing, sheet, row, row, true) {
        let shape = Element::polygon(body.corners).set("stroke-linecap", "round");
        svg.add(
            shape
                .fill(body.colour)
                .number("fill-opacity", 0.25)
                .stroke(Colour::Frame, 0.25),
        );
    }
    arc_slots::ghost(drawing, svg, sheet, row);
    for (index, point) in drawing.shown.picture.points.iter().enumerate() {
        let is_drawn = point.kind != PointKind::Construction;
        if let Some(at) = sheet.point(index, row).filter(|_| is_drawn) {
            svg.add(Element::circle(at, 0.4).fill(Colour::Frame));
        }
    }
}

/// Blocks along their guides.
pub(super) fn sliders(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let guides = drawing.shown.picture.guides.iter();
    for guide in guides.filter(|guide| guide.shape == GuideShape::Slot) {
        let at = sheet.point(guide.slider, row);
        let direction = sheet.direction(guide.direction, row);
        if let (Some(at), Some(direction)) = (at, direction) {
            let [half, high] = BLOCK;
            let corner = |(along, left): (f64, f64)| moved(at, direction, along, left);
            let corners = [(half, high), (half, -high), (-half, -high), (-half, high)];
            let block = Element::polygon(corners.map(corner)).class("slider");
            let block = block.set("data-name", guide.name);
            svg.add(block.fill(Colour::Paper).stroke(Colour::Ink, 0.45));
        }
    }
}

/// Joints as circles, tips as dots.
pub(super) fn points(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for (index, point) in drawing.shown.picture.points.iter().enumerate() {
        let Some(at) = sheet.point(index, row) else {
            continue;
        };
        let colour = match drawing.traces.contains(&index) {
            true => Colour::Curve(drawing.point_hue(index)),
            false => Colour::Ink,
        };
        let mark = match point.kind {
            // Nothing turns there.
            PointKind::Joint if signs::only_slides(drawing, index) => {
                Element::circle(at, DOT).fill(colour)
            }
            PointKind::Ground | PointKind::Joint => Element::circle(at, JOINT)
                .fill(match signs::is_filled(drawing, index) {
                    true => colour,
                    false => Colour::Paper,
                })
                .stroke(colour, 0.45),
            PointKind::Tip => Element::circle(at, 0.8).fill(colour),
            PointKind::Loose => Element::circle(at, LOOSE)
                .fill(Colour::Paper)
                .stroke(colour, 0.35)
                .set("stroke-dasharray", "0.9 0.6"),
            PointKind::Construction => continue,
        };
        svg.add(mark.class("point").set("data-point", point.name));
    }
}

pub(super) fn bodies(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    row: usize,
    form: usize,
    ghost: bool,
) -> Vec<Body<'static>> {
    let picture = drawing.shown.picture;
    let mut bodies = Vec::new();
    for (index, link) in picture.links.iter().enumerate() {
        let points = |row| {
            let places = arc_slot::places_of_link(&drawing.shown, index, row);
            let places = places.into_iter().map(|point| sheet.on_paper(point));
            places.collect::<Option<Vec<_>>>()
        };
        if let (Some(points), Some(form)) = (points(row), points(form)) {
            let corners = hull_places(&form).into_iter();
            let near: f64 = link.points.iter().map(|p| sheet.nearness(*p, row)).sum();
            bodies.push(Body {
                name: link.name,
                corners: corners.map(|corner| points[corner]).collect(),
                width: BAR,
                colour: Colour::Link(drawing.shown.link_hue(index)),
                nearness: near / link.points.len() as f64,
            });
        }
    }
    for (index, guide) in picture.guides.iter().enumerate() {
        let colour = match guide.on {
            // Drawn by itself, but as a ghost.
            GuideOn::Itself if guide.shape == GuideShape::Cylinder && !ghost => continue,
            _ if guide.shape == GuideShape::Arc => continue,
            GuideOn::Frame => continue,
            GuideOn::Link(link) => Colour::Link(drawing.shown.link_hue(link)),
            GuideOn::Itself => Colour::Link(drawing.shown.guide_hue(index)),
        };
        let beyond = BEYOND / sheet.factor;
        let [low, high] = drawing.shown.rail(guide);
        // Beyond the slider, but not behind the origin.
        let ends = [
            if low < 0.0 { low - beyond } else { low },
            if high > 0.0 { high + beyond } else { high },
        ];
        let ends = ends.map(|way| sheet.along(guide.origin, guide.direction, way, row));
        if let [Some(a), Some(b)] = ends {
            bodies.push(Body {
                name: guide.name,
                corners: Vec::from([a, b]),
                width: RAIL,
                colour,
                nearness: sheet.nearness(guide.origin, row),
            });
        }
    }
    bodies
}

//! Drawings for programs that construct: DXF, true to size.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::geometry::{along, hull};
use super::options::Drawing;
use super::pitch_circles::PitchCircles;
use super::rows;
use crate::arc_slot::{self, ArcSlot};
use linkage_core::format::rounded;
use linkage_core::{GuideShape, PicturePart, PointKind};
use linkage_formats::ReportError;
use linkage_formats::tags::{Layer, Tags};

/// Shares of the mechanism's size, the diagonal of the box about all places of its points: the
/// radius of joints, half the length of axes, the height of letters.
const JOINT: f64 = 0.006;
const AXIS: f64 = 0.1;
const LETTER: f64 = 0.014;
/// Half the length and half the height of a slider, in radii of joints.
const BLOCK: [f64; 2] = [4.0, 2.2];
/// Half the width of a curved slot, in radii of joints.
const GAP: f64 = 1.4;

/// Returns the drawing as DXF.
pub(super) fn drawing_dxf(drawing: &Drawing<'_>) -> Result<String, ReportError> {
    let row = rows::possible_row(drawing)?;
    let [low, high] = bounds(drawing, row);
    let size = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>();
    let size = if size > 0.0 { size.sqrt() } else { 1.0 };
    let mut layers = Layer::OF_MECHANISMS.to_vec();
    let parts = drawing.shown.picture.parts.iter().enumerate();
    layers.extend(parts.map(|(index, part)| Layer::Part(part.name, index)));
    let mut tags = Tags::new(&layers, [low, high], size * JOINT);
    solid_links(drawing, &mut tags, row);
    guides(drawing, &mut tags, row, size * JOINT);
    for (centre, radius) in circles(drawing, row) {
        tags.circle(Layer::Gears, centre, radius);
    }
    axis_lines(drawing, &mut tags, row, size * AXIS);
    traced_paths(drawing, &mut tags);
    marked_points(drawing, &mut tags, row, size);
    let caption = [low[0], low[1] - 4.0 * size * LETTER, low[2]];
    tags.text(
        Layer::Names,
        caption,
        size * LETTER,
        &caption_text(drawing, row),
    );
    Ok(tags.finish())
}

/// The box about all places of points, and the gears where they are drawn.
fn bounds(drawing: &Drawing<'_>, row: usize) -> [[f64; 3]; 2] {
    let points = drawing.shown.picture.points.iter().enumerate();
    let drawn = points.filter(|(_, point)| point.kind != PointKind::Construction);
    let places = drawn.flat_map(|(index, _)| {
        (0..drawing.shown.rows()).map(move |row| drawing.shown.point_at(index, row))
    });
    let gears = circles(drawing, row).into_iter();
    let gears = gears.flat_map(|([x, y, z], radius)| [-radius, radius].map(|r| [x + r, y + r, z]));
    let places = places.filter(|point| is_known(*point)).chain(gears);
    let none = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    places.fold(none, |[low, high], point| {
        let with = |end: [f64; 3], least: fn(f64, f64) -> f64| {
            core::array::from_fn(|k| least(end[k], point[k]))
        };
        [with(low, f64::min), with(high, f64::max)]
    })
}

/// Returns the layer of an item that belongs to one part alone, or the layer of its kind.
fn layer(drawing: &Drawing<'_>, kind: Layer, has: impl Fn(&PicturePart) -> bool) -> Layer {
    let parts = drawing.shown.picture.parts.iter().enumerate();
    let mut owners = parts.filter(|(_, part)| has(part));
    match (owners.next(), owners.next()) {
        (Some((index, part)), None) => Layer::Part(part.name, index),
        _ => kind,
    }
}

fn solid_links(drawing: &Drawing<'_>, tags: &mut Tags, row: usize) {
    let spatial = drawing.shown.picture.dimension == 3;
    for index in 0..drawing.shown.picture.links.len() {
        let layer = layer(drawing, Layer::Links, |part| part.links.contains(&index));
        let places = arc_slot::places_of_link(&drawing.shown, index, row);
        match places.as_slice() {
            [a, b] => tags.line(layer, *a, *b),
            _ if spatial => {
                for (index, a) in places.iter().enumerate() {
                    for b in &places[index + 1..] {
                        tags.line(layer, *a, *b);
                    }
                }
            }
            _ => {
                let flat: Vec<_> = places.iter().map(|[x, y, _]| [*x, *y]).collect();
                let corners = hull(&flat).into_iter().map(|[x, y]| [x, y, 0.0]);
                tags.polyline(layer, true, false, corners);
            }
        }
    }
}

/// The way of each slider, the outline of a curved slot, or a cylinder between its ends.
fn guides(drawing: &Drawing<'_>, tags: &mut Tags, row: usize, radius: f64) {
    for (index, guide) in drawing.shown.picture.guides.iter().enumerate() {
        let layer = layer(drawing, Layer::Guides, |part| part.guides.contains(&index));
        let origin = drawing.shown.point_at(guide.origin, row);
        let direction = drawing.shown.way(guide.direction, row);
        let slider = drawing.shown.point_at(guide.slider, row);
        match guide.shape {
            GuideShape::Cylinder => {
                tags.line(layer, origin, slider);
                continue;
            }
            GuideShape::Arc => {
                if let Some(slot) = ArcSlot::new(&drawing.shown, guide, row) {
                    arc_outline(tags, layer, &slot, GAP * radius);
                }
                continue;
            }
            GuideShape::Slot => {}
        }
        if !is_known(direction) {
            continue;
        }
        let at = |way: f64| along(origin, direction, way);
        let [low, high] = drawing.shown.rail(guide);
        tags.line(layer, at(low), at(high));
        if drawing.shown.picture.dimension == 2 {
            let [half, high] = BLOCK.map(|times| times * radius);
            let [c, s, _] = direction;
            let corner =
                |(a, b): (f64, f64)| [slider[0] + a * c - b * s, slider[1] + a * s + b * c, 0.0];
            let corners = [(half, high), (-half, high), (-half, -high), (half, -high)];
            tags.polyline(layer, true, false, corners.into_iter().map(corner));
        }
    }
}

/// Two concentric arcs with round ends; two circles for a ring.
fn arc_outline(tags: &mut Tags, layer: Layer, slot: &ArcSlot, half: f64) {
    let [x, y] = slot.centre;
    let sides = [slot.radius - half, slot.radius + half];
    if slot.is_ring() {
        for radius in sides {
            tags.circle(layer, [x, y, 0.0], radius);
        }
        return;
    }
    let ends = [slot.start, slot.start + slot.span];
    let [from, to] = ends.map(f64::to_degrees);
    for radius in sides {
        tags.arc(layer, [x, y, 0.0], radius, [from, to]);
    }
    for (end, angle, start) in [(ends[0], from, 180.0), (ends[1], to, 0.0)] {
        let [x, y] = slot.point(slot.radius, end);
        tags.arc(
            layer,
            [x, y, 0.0],
            half,
            [angle + start, angle + start + 180.0],
        );
    }
}

/// Centres and radii of pitch circles; none in space.
fn circles(drawing: &Drawing<'_>, row: usize) -> Vec<([f64; 3], f64)> {
    let picture = drawing.shown.picture;
    let gears = picture.gears.iter().filter(|_| picture.dimension == 2);
    let gears = gears.filter_map(|gear| Some((gear, PitchCircles::new(&drawing.shown, gear)?)));
    let circles = gears.flat_map(|(gear, wheels)| {
        let centres = gear
            .centres
            .map(|centre| drawing.shown.point_at(centre, row));
        centres.into_iter().zip(wheels.radii)
    });
    circles.collect()
}

fn axis_lines(drawing: &Drawing<'_>, tags: &mut Tags, row: usize, half: f64) {
    for axis in drawing.shown.picture.axes {
        let point = drawing.shown.point_at(axis.point, row);
        let direction = drawing.shown.way(axis.direction, row);
        if !is_known(direction) {
            continue;
        }
        let [a, b] = [-half, half].map(|way| along(point, direction, way));
        tags.line(Layer::Axes, a, b);
    }
}

/// Paths of points over the whole range, in pieces between gaps.
fn traced_paths(drawing: &Drawing<'_>, tags: &mut Tags) {
    let spatial = drawing.shown.picture.dimension == 3;
    for &point in &drawing.traces {
        let rows = 0..drawing.shown.rows();
        let places: Vec<_> = rows.map(|row| drawing.shown.point_at(point, row)).collect();
        let pieces = places.split(|point| !is_known(*point));
        for piece in pieces.filter(|piece| piece.len() > 1) {
            tags.polyline(Layer::Paths, false, spatial, piece.iter().copied());
        }
    }
}

/// Points with their names; in the plane joints are circles, too.
fn marked_points(drawing: &Drawing<'_>, tags: &mut Tags, row: usize, size: f64) {
    let picture = drawing.shown.picture;
    for (index, point) in picture.points.iter().enumerate() {
        let position = drawing.shown.point_at(index, row);
        let turns = match point.kind {
            PointKind::Construction => continue,
            PointKind::Ground | PointKind::Joint => picture.dimension == 2,
            PointKind::Tip | PointKind::Loose => false,
        };
        let layer = layer(drawing, Layer::Joints, |part| part.points.contains(&index));
        tags.point(layer, position);
        if turns {
            tags.circle(layer, position, size * JOINT);
        }
        if drawing.names {
            let [x, y, z] = position;
            let beside = [x + 1.5 * size * JOINT, y + 1.5 * size * JOINT, z];
            tags.text(Layer::Names, beside, size * LETTER, point.name);
        }
    }
}

/// `phi = 29 deg, lengths in mm`
fn caption_text(drawing: &Drawing<'_>, row: usize) -> String {
    let input = &drawing.report.input;
    let at = drawing.report.positions[row];
    let (at, unit) = match input.unit {
        "rad" => (at.to_degrees(), "deg"),
        unit => (at, unit),
    };
    let lengths = drawing.shown.unit;
    format!(
        "{} = {} {unit}, lengths in {lengths}",
        input.name,
        rounded(at)
    )
}

fn is_known(point: [f64; 3]) -> bool {
    point.iter().all(|x| x.is_finite())
}

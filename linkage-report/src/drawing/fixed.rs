//! Fixed parts: pivots, guides of the frame, axes, paths.

use super::geometry::moved;
use super::options::Drawing;
use super::sheet::Sheet;
use super::sizes::{BEYOND, BLOCK, FOOT};
use linkage_core::{Axis, Guide, GuideOn, GuideShape, PointKind};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Distance and length of hatching.
const HATCH: [f64; 2] = [1.5, 2.0];
/// Half the length of an axis.
const AXIS: f64 = 9.0;
/// A direction is vertical, except for rounding, if it goes less to the side.
const VERTICAL: f64 = 1e-9;

/// A line with hatching beside it, and the slider's way above.
pub(super) fn frame_guide(
    drawing: &Drawing<'_>,
    svg: &mut Svg,
    sheet: &Sheet<'_>,
    guide: &Guide,
    row: usize,
) {
    if guide.on != GuideOn::Frame || guide.shape == GuideShape::Arc {
        return;
    }
    let Some(direction) = rightwards(sheet.direction(guide.direction, row)) else {
        return;
    };
    let ends = drawing.shown.rail(guide);
    let ends = ends.map(|way| sheet.along(guide.origin, guide.direction, way, row));
    let [Some(a), Some(b)] = ends else {
        return;
    };
    let (a, b) = if (b[0] - a[0]) * direction[0] + (b[1] - a[1]) * direction[1] < 0.0 {
        (b, a)
    } else {
        (a, b)
    };
    let (from, to) = (
        moved(a, direction, -BEYOND, -BLOCK[1]),
        moved(b, direction, BEYOND, -BLOCK[1]),
    );
    svg.group(
        Element::new("g")
            .class("guide")
            .set("data-name", guide.name),
        |svg| {
            let middle = Element::line(
                moved(from, direction, 0.0, BLOCK[1]),
                moved(to, direction, 0.0, BLOCK[1]),
            );
            svg.add(
                middle
                    .stroke(Colour::Frame, 0.18)
                    .set("stroke-dasharray", "4 1 0.8 1"),
            );
            hatched(svg, from, to, direction);
        },
    );
}

/// Feet of the pivots that links turn about.
pub(super) fn pivots(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let picture = drawing.shown.picture;
    for (index, point) in picture.points.iter().enumerate() {
        let is_pivot = point.kind == PointKind::Ground;
        let Some(at) = sheet.point(index, row).filter(|_| is_pivot) else {
            continue;
        };
        let [height, half] = FOOT;
        let corner = |side: f64| [at[0] + side * half, at[1] + height];
        svg.group(
            Element::new("g")
                .class("pivot")
                .set("data-name", point.name),
            |svg| {
                let triangle = Element::polygon([at, corner(1.0), corner(-1.0)]);
                svg.add(triangle.fill(Colour::Paper).stroke(Colour::Ink, 0.4));
                hatched(svg, corner(-1.6), corner(1.6), [1.0, 0.0]);
            },
        );
    }
}

/// Axes in space, as lines of long and short strokes.
pub(super) fn axes(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for axis in drawing.shown.picture.axes {
        if let Some([a, b]) = axis_ends(sheet, axis, row) {
            let line = Element::line(a, b).class("axis").stroke(Colour::Muted, 0.3);
            svg.add(line.set("stroke-dasharray", "3 0.8 0.6 0.8"));
        }
    }
}

pub(super) fn axis_ends(sheet: &Sheet<'_>, axis: &Axis, row: usize) -> Option<[[f64; 2]; 2]> {
    let half = AXIS / sheet.factor;
    let end = |way| sheet.along(axis.point, axis.direction, way, row);
    Some([end(-half)?, end(half)?])
}

/// The path of a point, with gaps where the mechanism cannot be assembled.
pub(super) fn path(
    drawing: &Drawing<'_>,
    svg: &mut Svg,
    sheet: &Sheet<'_>,
    point: usize,
    hue: usize,
) {
    let rows = 0..drawing.report.positions.len();
    let places: std::vec::Vec<_> = rows.map(|row| sheet.point(point, row)).collect();
    let name = drawing.shown.picture.points[point].name;
    svg.group(
        Element::new("g").class("path").set("data-name", name),
        |svg| {
            for piece in places
                .split(Option::is_none)
                .filter(|piece| piece.len() > 1)
            {
                let line = Element::polyline(piece.iter().copied().flatten());
                svg.add(line.stroke(Colour::Curve(hue), 0.45));
            }
        },
    );
}

/// A line of the frame with hatching to its right.
fn hatched(svg: &mut Svg, from: [f64; 2], to: [f64; 2], direction: [f64; 2]) {
    svg.add(Element::line(from, to).stroke(Colour::Ink, 0.5));
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let count = (length / HATCH[0]).floor().max(1.0);
    svg.group(Element::new("g").class("hatching"), |svg| {
        for i in 0..count as usize {
            let way = (i as f64 + 1.0) * length / count;
            let start = moved(from, direction, way, 0.0);
            let end = moved(from, direction, way - 0.7 * HATCH[1], -0.7 * HATCH[1]);
            svg.add(Element::line(start, end).stroke(Colour::Frame, 0.3));
        }
    });
}

/// Returns a line's direction, turned so that its right side is below it on paper.
pub(super) fn rightwards(direction: Option<[f64; 2]>) -> Option<[f64; 2]> {
    let [x, y] = direction?;
    let turned = x < -VERTICAL || (x.abs() <= VERTICAL && y > 0.0);
    Some(if turned { [-x, -y] } else { [x, y] })
}

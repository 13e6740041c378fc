//! Areas that names keep clear of.

use std::vec::Vec;

use super::caption::{SIGN, sign_at};
use super::fixed::rightwards;
use super::geometry::moved;
use super::options::Drawing;
use super::room::Taken;
use super::sheet::Sheet;
use super::sizes::{BEYOND, BLOCK, FOOT, JOINT, OUTLINE};
use super::{arc_slots, arrows, marks, parts, signs};
use linkage_core::{Guide, GuideOn, GuideShape, PointKind};

/// Distance from the middle of a frame's guide to that of its hatching, and half the width of the
/// hatching.
const HATCHED: [f64; 2] = [BLOCK[1] + 0.7, 0.9];
/// Half the width of thin lines, and of lines with heads of arrows.
const THIN: f64 = 0.25;
const HEADED: f64 = 0.9;
/// Rows of a stretch of a path: on paper it is straight.
const STRETCH: usize = 6;

pub(super) fn covered(drawing: &Drawing<'_>, sheet: &Sheet<'_>, row: usize) -> Vec<Taken> {
    let picture = drawing.shown.picture;
    let bodies = parts::bodies(drawing, sheet, row, row, false).into_iter();
    let mut all: Vec<Taken> = bodies
        .map(|body| Taken::new(&body.corners, 0.5 * body.width + OUTLINE))
        .collect();
    for guide in picture.guides {
        all.extend(match (guide.on, guide.shape) {
            (_, GuideShape::Arc) => arc_slots::covers(drawing, sheet, guide, row),
            (GuideOn::Frame, _) => rail_cover(drawing, sheet, guide, row),
            (_, GuideShape::Cylinder) => signs::cylinder_cover(drawing, sheet, guide, row),
            (_, GuideShape::Slot) => Vec::new(),
        });
        if guide.shape == GuideShape::Slot {
            all.extend(block_cover(sheet, guide, row));
        }
    }
    for (index, point) in picture.points.iter().enumerate() {
        let is_drawn = point.kind != PointKind::Construction;
        if let Some([x, y]) = sheet.point(index, row).filter(|_| is_drawn) {
            all.push(Taken::new(&[[x, y]], JOINT + THIN));
            if point.kind == PointKind::Ground {
                let [height, half] = FOOT;
                all.push(Taken::from_area([
                    x - 1.6 * half - THIN,
                    y,
                    x + 1.6 * half,
                    y + height + 1.6,
                ]));
            }
        }
    }
    for line in arrows::drive_lines(drawing, sheet, row) {
        all.extend(line.windows(2).map(|ends| Taken::new(ends, HEADED)));
    }
    let marks = marks::marks(drawing, sheet, row).into_iter();
    all.extend(marks.map(|ends| Taken::new(&ends, HEADED)));
    all.extend(signs::sign_covers(drawing, sheet, row));
    let signs = sheet.axes().map(|_| sign_at(sheet.size[0]));
    // Beyond its arrows are their letters.
    all.extend(signs.map(|at| Taken::new(&[at], 1.5 * SIGN)));
    all.extend(path_covers(drawing, sheet));
    all
}

/// The thin line of a guide of the frame, and its hatching.
fn rail_cover(drawing: &Drawing<'_>, sheet: &Sheet<'_>, guide: &Guide, row: usize) -> Vec<Taken> {
    let ends = drawing.shown.rail(guide);
    let ends = ends.map(|way| sheet.along(guide.origin, guide.direction, way, row));
    let ([Some(a), Some(b)], Some(way)) = (ends, rightwards(sheet.direction(guide.direction, row)))
    else {
        return Vec::new();
    };
    let forth = (b[0] - a[0]) * way[0] + (b[1] - a[1]) * way[1] >= 0.0;
    let (a, b) = if forth { (a, b) } else { (b, a) };
    let line = |left| [moved(a, way, -BEYOND, left), moved(b, way, BEYOND, left)];
    let [aside, half] = HATCHED;
    Vec::from([
        Taken::new(&line(0.0), THIN),
        Taken::new(&line(-aside), half),
    ])
}

fn path_covers(drawing: &Drawing<'_>, sheet: &Sheet<'_>) -> Vec<Taken> {
    let mut all = Vec::new();
    let last = drawing.shown.rows() - 1;
    for &point in &drawing.traces {
        for row in (0..last).step_by(STRETCH) {
            let ends = [row, (row + STRETCH).min(last)].map(|row| sheet.point(point, row));
            if let [Some(a), Some(b)] = ends {
                all.push(Taken::new(&[a, b], THIN));
            }
        }
    }
    all
}

fn block_cover(sheet: &Sheet<'_>, guide: &Guide, row: usize) -> Option<Taken> {
    let at = sheet.point(guide.slider, row)?;
    let way = sheet.direction(guide.direction, row)?;
    let [half, high] = BLOCK;
    let corners = [(half, high), (half, -high), (-half, -high), (-half, high)];
    let corners = corners.map(|(along, left)| moved(at, way, along, left));
    Some(Taken::new(&corners, THIN))
}

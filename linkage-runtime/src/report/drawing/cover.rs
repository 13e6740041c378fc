//! What names keep clear of.

use std::vec::Vec;

use super::Drawing;
use super::caption::{SIGN, sign_at};
use super::fixed::{FOOT, rightwards};
use super::geometry::moved;
use super::parts::{BLOCK, JOINT, OUTLINE};
use super::room::Taken;
use super::sheet::{BEYOND, Sheet};
use crate::{Guide, GuideOn, GuideShape, PointKind};

/// From the middle of a frame's guide to that of its hatching, and half the width of that.
const HATCHED: [f64; 2] = [BLOCK[1] + 0.7, 0.9];
/// Half the width of thin lines, and of lines with heads of arrows.
const THIN: f64 = 0.25;
const HEADED: f64 = 0.9;
/// Rows of a stretch of a path: on paper it is straight.
const STRETCH: usize = 6;

impl Drawing<'_> {
    pub(super) fn taken(&self, sheet: &Sheet<'_>, row: usize) -> Vec<Taken> {
        let picture = self.shown.picture;
        let bodies = self.bodies(sheet, row, row, false).into_iter();
        let mut all: Vec<Taken> = bodies
            .map(|body| Taken::new(&body.corners, 0.5 * body.width + OUTLINE))
            .collect();
        for guide in picture.guides {
            all.extend(match (guide.on, guide.shape) {
                (GuideOn::Frame, _) => self.rail_cover(sheet, guide, row),
                (_, GuideShape::Cylinder) => self.cylinder_cover(sheet, guide, row),
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
                    all.push(Taken::of([
                        x - 1.6 * half - THIN,
                        y,
                        x + 1.6 * half,
                        y + height + 1.6,
                    ]));
                }
            }
        }
        for line in self.drive_lines(sheet, row) {
            all.extend(line.windows(2).map(|ends| Taken::new(ends, HEADED)));
        }
        let marks = self.marks(sheet, row).into_iter();
        all.extend(marks.map(|ends| Taken::new(&ends, HEADED)));
        all.extend(self.sign_covers(sheet, row));
        let signs = sheet.axes().map(|_| sign_at(sheet.size[0]));
        // Beyond its arrows are their letters.
        all.extend(signs.map(|at| Taken::new(&[at], 1.5 * SIGN)));
        all.extend(self.path_covers(sheet));
        all
    }

    /// The thin line of a guide of the frame, and its hatching.
    fn rail_cover(&self, sheet: &Sheet<'_>, guide: &Guide, row: usize) -> Vec<Taken> {
        let ends = self.shown.rail(guide);
        let ends = ends.map(|way| sheet.along(guide.origin, guide.direction, way, row));
        let ([Some(a), Some(b)], Some(way)) =
            (ends, rightwards(sheet.direction(guide.direction, row)))
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

    fn path_covers(&self, sheet: &Sheet<'_>) -> Vec<Taken> {
        let mut all = Vec::new();
        let last = self.shown.rows() - 1;
        for &point in &self.traces {
            for row in (0..last).step_by(STRETCH) {
                let ends = [row, (row + STRETCH).min(last)].map(|row| sheet.point(point, row));
                if let [Some(a), Some(b)] = ends {
                    all.push(Taken::new(&[a, b], THIN));
                }
            }
        }
        all
    }
}

fn block_cover(sheet: &Sheet<'_>, guide: &Guide, row: usize) -> Option<Taken> {
    let at = sheet.point(guide.slider, row)?;
    let way = sheet.direction(guide.direction, row)?;
    let [half, high] = BLOCK;
    let corners = [(half, high), (half, -high), (-half, -high), (-half, high)];
    let corners = corners.map(|(along, left)| moved(at, way, along, left));
    Some(Taken::new(&corners, THIN))
}

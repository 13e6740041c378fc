//! The map from the mechanism to the paper.

use std::vec::Vec;

use super::geometry::along;
use super::legend_layout;
use super::options::Drawing;
use super::pitch_circles::PitchCircles;
use super::sizes::LETTER_WIDTH;
use super::view::View;
use crate::arc_slot::{self, ArcSlot};
use crate::positioned_picture::PositionedPicture;
use linkage_core::{GuideShape, PointKind};

/// Around the mechanism, in millimetres: place for symbols; to the left and right also for names up
/// to a length.
const MARGIN: f64 = 13.0;
const LONGEST: f64 = 34.0;
/// Above and below: title and caption.
const HEAD: f64 = 11.0;
const FOOT: f64 = 12.0;
/// The least width, for the caption, and the width of a letter of the title.
const NARROWEST: f64 = 110.0;
const LETTER: f64 = 2.8;
/// The mechanism is not drawn larger than this without being asked for.
const LARGEST: [f64; 2] = [160.0, 180.0];
/// A direction that is shorter on paper points at the reader except for rounding.
const VISIBLE: f64 = 1e-6;

/// The paper, in millimetres, and where the mechanism is on it.
pub(super) struct Sheet<'a> {
    shown: PositionedPicture<'a>,
    view: View,
    /// Millimetres on paper for a unit of the mechanism.
    pub(super) factor: f64,
    /// The scale that the caption tells.
    pub(super) scale: f64,
    pub(super) size: [f64; 2],
    corner: [f64; 2],
    /// The free width at the left that centres a narrow drawing.
    shift: f64,
    /// Above the mechanism.
    top: f64,
}

impl<'a> Sheet<'a> {
    pub(super) fn new(drawing: &Drawing<'a>) -> Self {
        let (shown, view) = (drawing.shown, drawing.view);
        let unit = millimetres(shown.unit);
        let limits = limits(drawing, &view);
        let [wide, high] = limits.map(|[low, high]| (high - low).max(0.0));
        let scale = drawing.scale.unwrap_or_else(|| {
            let room = (LARGEST[0] / (wide * unit)).min(LARGEST[1] / (high * unit));
            round_scale(room)
        });
        let factor = scale * unit;
        let title = 12.0 + LETTER * drawing.report.title.chars().count() as f64;
        let beside = 2.0 * (MARGIN + names_width(drawing).min(LONGEST));
        let width = (wide * factor + beside).max(NARROWEST).max(title);
        let top = MARGIN + HEAD + legend_layout::height(drawing, width);
        Self {
            shown,
            view,
            factor,
            scale,
            size: [width, high * factor + top + MARGIN + FOOT],
            corner: [limits[0][0], limits[1][1]],
            shift: 0.5 * (width - wide * factor),
            top,
        }
    }

    /// A point on paper; `None` where it is not finite.
    pub(super) fn point(&self, index: usize, row: usize) -> Option<[f64; 2]> {
        self.on_paper(self.shown.point_at(index, row))
    }

    /// A point and the point that lies by `distance` along a direction from it.
    pub(super) fn along(
        &self,
        origin: usize,
        direction: usize,
        distance: f64,
        row: usize,
    ) -> Option<[f64; 2]> {
        let (origin, direction) = (
            self.shown.point_at(origin, row),
            self.shown.way(direction, row),
        );
        self.on_paper(along(origin, direction, distance))
    }

    /// A direction on paper, of length one; `None` if it points at the reader.
    pub(super) fn direction(&self, index: usize, row: usize) -> Option<[f64; 2]> {
        let [x, y] = self.view.project(self.shown.way(index, row));
        let length = x.hypot(y);
        (length > VISIBLE).then_some([x / length, -y / length])
    }

    /// The end of a step from a point.
    pub(super) fn beside(&self, point: usize, step: [f64; 3], row: usize) -> Option<[f64; 2]> {
        self.on_paper(along(self.shown.point_at(point, row), step, 1.0))
    }

    /// A step on paper.
    pub(super) fn step(&self, step: [f64; 3]) -> [f64; 2] {
        let [x, y] = self.view.project(step);
        [self.factor * x, -self.factor * y]
    }

    /// The axes of space on paper, of length one where they lie in it; `None` in the plane.
    pub(super) fn axes(&self) -> Option<[[f64; 2]; 3]> {
        let axis = |k: usize| {
            let mut axis = [0.0; 3];
            axis[k] = 1.0;
            let [x, y] = self.view.project(axis);
            [x, -y]
        };
        self.view.in_space.then(|| [0, 1, 2].map(axis))
    }

    pub(super) fn nearness(&self, index: usize, row: usize) -> f64 {
        self.view.nearness(self.shown.point_at(index, row))
    }

    pub(super) fn on_paper(&self, v: [f64; 3]) -> Option<[f64; 2]> {
        let [x, y] = self.view.project(v);
        let (x, y) = (
            (x - self.corner[0]) * self.factor,
            (self.corner[1] - y) * self.factor,
        );
        (x.is_finite() && y.is_finite()).then_some([x + self.shift, y + self.top])
    }
}

/// The ends of everything that moves or stands, to the right and up, over the whole range: the
/// drawing of any position has the same frame.
fn limits(drawing: &Drawing<'_>, view: &View) -> [[f64; 2]; 2] {
    let shown = &drawing.shown;
    let mut limits = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut take = |v: [f64; 3]| {
        for (limit, x) in limits.iter_mut().zip(view.project(v)) {
            if x.is_finite() {
                *limit = [limit[0].min(x), limit[1].max(x)];
            }
        }
    };
    let guides = shown.picture.guides.iter();
    let (arcs, guides): (Vec<_>, Vec<_>) = guides.partition(|guide| guide.shape == GuideShape::Arc);
    let guides = guides.into_iter();
    let rails: Vec<_> = guides.map(|guide| (guide, shown.rail(guide))).collect();
    let arcs = arcs.into_iter();
    let arcs = arcs.filter_map(|guide| Some((guide, arc_slot::swing(shown, guide)?)));
    let arcs: Vec<_> = arcs.collect();
    let gears = shown.picture.gears.iter();
    let gears = gears.filter_map(|gear| Some((gear, PitchCircles::new(shown, gear)?)));
    let gears: Vec<_> = gears.collect();
    for row in 0..shown.rows() {
        for (index, point) in shown.picture.points.iter().enumerate() {
            if point.kind != PointKind::Construction {
                take(shown.point_at(index, row));
            }
        }
        for vector in &drawing.vectors {
            take(along(
                shown.point_at(vector.point, row),
                vector.step(row),
                1.0,
            ));
        }
        for (gear, wheels) in &gears {
            for (centre, radius) in gear.centres.iter().zip(wheels.radii) {
                let [x, y, z] = shown.point_at(*centre, row);
                take([x - radius, y - radius, z]);
                take([x + radius, y + radius, z]);
            }
        }
        for (guide, rail) in &rails {
            let origin = shown.point_at(guide.origin, row);
            let way = shown.way(guide.direction, row);
            for end in *rail {
                take(along(origin, way, end));
            }
        }
        for (guide, swing) in &arcs {
            let slot = ArcSlot::with_swing(shown, guide, *swing, row);
            let line = slot.into_iter().flat_map(|slot| slot.middle_line());
            line.for_each(|[x, y]| take([x, y, 0.0]));
        }
    }
    limits.map(|[low, high]| if low > high { [0.0; 2] } else { [low, high] })
}

/// Millimetres in a length unit of mechanisms.
fn millimetres(unit: &str) -> f64 {
    match unit {
        "um" => 1e-3,
        "cm" => 10.0,
        "m" => 1e3,
        "inch" => 25.4,
        _ => 1.0,
    }
}

/// The largest of 1, 2, 5 times a power of ten that is not above a limit.
fn round_scale(limit: f64) -> f64 {
    if !limit.is_finite() {
        return 1.0;
    }
    let power = limit.log10().floor() as i32;
    let of = |factor: f64| {
        // Division for scales below one: 1/5 and not 2 * 0.1.
        if power < 0 {
            factor / 10f64.powi(-power)
        } else {
            factor * 10f64.powi(power)
        }
    };
    let factors = [5.0, 2.0, 1.0];
    factors
        .map(of)
        .into_iter()
        .find(|s| *s <= limit)
        .unwrap_or_else(|| of(1.0))
}

/// Width of the longest name on paper.
fn names_width(drawing: &Drawing<'_>) -> f64 {
    let points = drawing
        .shown
        .picture
        .points
        .iter()
        .filter(|_| drawing.names);
    let letters = points.map(|point| point.name.chars().count());
    LETTER_WIDTH * letters.max().unwrap_or(0) as f64
}

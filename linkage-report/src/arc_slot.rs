//! Curved slots: the stretch of an arc that its slider needs.

use core::f64::consts::TAU;
use std::vec::Vec;

use crate::positioned_picture::PositionedPicture;
use linkage_core::{Guide, GuideOn, GuideShape, PointKind};

/// The longest step along an arc that is drawn as straight pieces, in radians.
const STEP: f64 = TAU / 90.0;

/// A curved slot at one position, in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ArcSlot {
    /// In the mechanism's length unit, as its radius.
    pub(super) centre: [f64; 2],
    pub(super) radius: f64,
    /// The angle of its first end, and the angle counter-clockwise from there to the other end: a
    /// full turn for a ring. In radians.
    pub(super) start: f64,
    pub(super) span: f64,
}

impl ArcSlot {
    /// Returns `None` for a straight guide, and where the mechanism cannot be assembled.
    pub(super) fn new(shown: &PositionedPicture<'_>, guide: &Guide, row: usize) -> Option<Self> {
        let swing = swing(shown, guide)?;
        Self::with_swing(shown, guide, swing, row)
    }

    /// Returns the slot whose slider has this range of angles.
    pub(super) fn with_swing(
        shown: &PositionedPicture<'_>,
        guide: &Guide,
        swing: [f64; 2],
        row: usize,
    ) -> Option<Self> {
        let [x, y, _] = shown.point_at(guide.origin, row);
        let [u, v, _] = shown.point_at(guide.slider, row);
        let [c, s, _] = shown.way(guide.direction, row);
        let turned = s.atan2(c);
        let slot = Self {
            centre: [x, y],
            radius: (u - x).hypot(v - y),
            start: swing[0] + turned,
            span: swing[1] - swing[0],
        };
        let numbers = [x, y, slot.radius, turned];
        numbers.iter().all(|x| x.is_finite()).then_some(slot)
    }

    /// Returns true if the slider goes all the way round.
    pub(super) fn is_ring(&self) -> bool {
        self.span >= TAU
    }

    /// Returns the point of the circle of a radius at an angle.
    pub(super) fn point(&self, radius: f64, angle: f64) -> [f64; 2] {
        let [x, y] = self.centre;
        [x + radius * angle.cos(), y + radius * angle.sin()]
    }

    /// Returns angles from one end to the other, at steps that are at most so long.
    pub(super) fn angles(&self, step: f64) -> impl Iterator<Item = f64> + use<> {
        let (start, span) = (self.start, self.span);
        let count = (span / step).ceil().max(1.0);
        (0..=count as usize).map(move |k| start + span * k as f64 / count)
    }

    /// Returns points of the middle line from one end to the other, near to each other: as many at
    /// all positions.
    pub(super) fn middle_line(&self) -> Vec<[f64; 2]> {
        let angles = self.angles(STEP);
        angles.map(|angle| self.point(self.radius, angle)).collect()
    }
}

/// Returns places around which a link is drawn: its points, and in place of the centres of its
/// curved slots, unless something turns there, the slots.
pub(super) fn places_of_link(
    shown: &PositionedPicture<'_>,
    link: usize,
    row: usize,
) -> Vec<[f64; 3]> {
    let picture = shown.picture;
    let guides = picture.guides.iter();
    let arcs =
        guides.filter(|guide| guide.shape == GuideShape::Arc && guide.on == GuideOn::Link(link));
    let is_centre = |point: usize| {
        let is_drawn = picture.points[point].kind != PointKind::Construction;
        !is_drawn && arcs.clone().any(|guide| guide.origin == point)
    };
    let points = picture.links[link].points.iter().copied();
    let points = points.filter(|point| !is_centre(*point));
    let slots = arcs.clone();
    let slots = slots.filter_map(|guide| ArcSlot::new(shown, guide, row));
    let lines = slots.flat_map(|slot| slot.middle_line());
    points
        .map(|point| shown.point_at(point, row))
        .chain(lines.map(|[x, y]| [x, y, 0.0]))
        .collect()
}

/// Returns the guides of the picture that are arcs, those of the frame or the others.
pub(super) fn arcs_on<'a>(
    shown: &PositionedPicture<'a>,
    frame: bool,
) -> impl Iterator<Item = (usize, &'static Guide)> + use<'a> {
    let guides = shown.picture.guides.iter().enumerate();
    guides.filter(move |(_, guide)| {
        guide.shape == GuideShape::Arc && (guide.on == GuideOn::Frame) == frame
    })
}

/// Returns the range of the angles from the direction of an arc to its slider over all positions,
/// in radians and at most a full turn; `None` for a straight guide, and without a position.
pub(super) fn swing(shown: &PositionedPicture<'_>, guide: &Guide) -> Option<[f64; 2]> {
    if guide.shape != GuideShape::Arc || shown.picture.dimension != 2 {
        return None;
    }
    let rows = 0..shown.rows();
    let angles = rows.map(|row| {
        let (from, to) = (
            shown.point_at(guide.origin, row),
            shown.point_at(guide.slider, row),
        );
        let [c, s, _] = shown.way(guide.direction, row);
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        (c * y - s * x).atan2(c * x + s * y)
    });
    range_of_angles(angles)
}

/// Returns the range of an angle that changes by less than half a turn from one value to the next.
fn range_of_angles(angles: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let mut angles = angles.filter(|angle| angle.is_finite());
    let mut last = angles.next()?;
    let mut range = [last; 2];
    for angle in angles {
        last = angle + TAU * ((last - angle) / TAU).round();
        range = [range[0].min(last), range[1].max(last)];
    }
    Some([range[0], range[1].min(range[0] + TAU)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    #[test]
    fn angles_run_on_beyond_half_a_turn() {
        let range = |angles: &[f64]| range_of_angles(angles.iter().copied());
        assert_eq!(range(&[3.0, f64::NAN, -3.0, 2.5]), Some([2.5, TAU - 3.0]));
        assert_eq!(range(&[f64::NAN]), None);
        let turn = (0..13).map(|k| f64::from(k) * PI / 3.0);
        assert_eq!(range_of_angles(turn), Some([0.0, TAU]));
    }

    #[test]
    fn the_middle_line_leads_from_end_to_end() {
        let slot = ArcSlot {
            centre: [1.0, 0.0],
            radius: 2.0,
            start: 0.0,
            span: PI,
        };
        let line = slot.middle_line();
        assert_eq!(line[0], [3.0, 0.0]);
        assert!((line[line.len() - 1][0] + 1.0).abs() < 1e-12);
        assert!(line.len() > 40 && !slot.is_ring());
    }
}

//! Guides: rails with blocks, slotted levers, curved slots, cylinders.

use std::f64::consts::PI;
use std::fmt::Write;

use super::paper::{BACKGROUND, Sheet, escaped, number, polyline};
use linkage_compiler::ir::{Guide, GuideOn, GuideShape};

/// Half the length of a rail and half its gauge, in pixels.
const RAIL: [f64; 2] = [32.0, 6.0];
/// Half the length and half the width of a block.
const BLOCK: [f64; 2] = [10.0, 5.0];
/// The largest half of the angle of a curved slot, in radians.
const MOST_OF_TURN: f64 = 0.8 * PI;
/// The share of a cylinder's barrel between its pins.
const BARREL: f64 = 0.6;

/// A unit vector that is shorter on the paper points at the reader.
const SHORTEST: f64 = 0.1;

/// Rails with a block on them, a slotted lever, or a cylinder.
pub(super) fn guide(sheet: &Sheet, guide: &Guide) -> String {
    if guide.shape == GuideShape::Arc {
        return arc(sheet, guide);
    }
    let [origin, position] = [guide.origin, guide.slider].map(|point| sheet.points[point]);
    let [x, y] = sheet.directions[guide.direction];
    let length = x.hypot(y);
    // Seen along its line.
    if length < SHORTEST || length.is_nan() {
        return String::new();
    }
    let along = [x / length, y / length];
    let corner = |way: f64, side: f64| {
        [
            position[0] + way * along[0] - side * along[1],
            position[1] + way * along[1] + side * along[0],
        ]
    };
    let name = escaped(&guide.name);
    let mut svg = format!("<g stroke-width=\"1.5\"><title>{name}</title>");
    let mut draw = |points: &[[f64; 2]], more: &str| {
        // Writing into a string does not fail.
        let _ = write!(svg, "<path d=\"{}{more}/>", polyline(points));
    };
    let [half, gauge] = RAIL;
    let [long, wide] = BLOCK;
    if guide.shape == GuideShape::Cylinder {
        let end = [0, 1].map(|axis| origin[axis] + BARREL * (position[axis] - origin[axis]));
        draw(
            &[origin, end],
            "\" stroke-width=\"11\" stroke-opacity=\".4\" stroke-linecap=\"butt\"",
        );
        draw(&[origin, position], "\" stroke-width=\"3\"");
    } else {
        if guide.on == GuideOn::Itself {
            draw(
                &[origin, corner(half, 0.0), corner(-half, 0.0)],
                "\" stroke-width=\"3\"",
            );
        } else {
            for side in [gauge, -gauge] {
                draw(&[corner(-half, side), corner(half, side)], "\"");
            }
        }
        let corners = [(-long, -wide), (long, -wide), (long, wide), (-long, wide)];
        let block = corners.map(|(way, side)| corner(way, side));
        draw(&block, &format!("Z\" fill=\"{BACKGROUND}\""));
    }
    svg.push_str("</g>");
    svg
}

/// A curved slot about the point in it, on the paper.
pub(super) struct ArcSlot {
    centre: [f64; 2],
    radius: f64,
    /// The angle of the point, and the angle from there to each end.
    middle: f64,
    reach: f64,
}

impl ArcSlot {
    pub(super) fn new(sheet: &Sheet, guide: &Guide) -> Self {
        let [centre, position] = [guide.origin, guide.slider].map(|point| sheet.points[point]);
        let [x, y] = [0, 1].map(|axis| position[axis] - centre[axis]);
        let radius = x.hypot(y);
        Self {
            centre,
            radius,
            middle: y.atan2(x),
            reach: (RAIL[0] / radius).min(MOST_OF_TURN),
        }
    }

    /// Points of the middle line: both ends, and the point in the slot.
    pub(super) fn middle_line(&self) -> [[f64; 2]; 3] {
        [-1.0, 0.0, 1.0].map(|end| self.point(self.radius, end))
    }

    /// The point at this radius, from -1 at one end of the slot to 1 at the other.
    fn point(&self, radius: f64, end: f64) -> [f64; 2] {
        let (sin, cos) = (self.middle + end * self.reach).sin_cos();
        [self.centre[0] + radius * cos, self.centre[1] + radius * sin]
    }
}

/// Two concentric arcs with round ends.
fn arc(sheet: &Sheet, guide: &Guide) -> String {
    let arc = ArcSlot::new(sheet, guide);
    let [_, gauge] = RAIL;
    let [inner, outer] = [(arc.radius - gauge).max(0.0), arc.radius + gauge];
    let corner = |radius: f64, end: f64| arc.point(radius, end).map(number).join(" ");
    let large = u8::from(2.0 * arc.reach > PI);
    let [r, big, cap] = [inner, outer, gauge].map(number);
    format!(
        "<path d=\"M{0}A{big} {big} 0 {large} 1 {1}A{cap} {cap} 0 0 1 {2}A{r} {r} 0 {large} 0 {3}\
         A{cap} {cap} 0 0 1 {0}Z\" stroke-width=\"1.5\" fill=\"{BACKGROUND}\"><title>{4}</title></path>",
        corner(outer, -1.0),
        corner(outer, 1.0),
        corner(inner, 1.0),
        corner(inner, -1.0),
        escaped(&guide.name),
    )
}

//! Signs of joints in space, and cylinders.

use std::vec::Vec;

use super::geometry::moved;
use super::options::Drawing;
use super::room::Taken;
use super::sheet::Sheet;
use super::{fixed, wheels};
use crate::joint_signs::{Bar, Directions, sign};
use linkage_core::{Guide, GuideShape};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Half the length and half the height of a hinge's sleeve, and of one that slides, too.
const SLEEVE: [f64; 2] = [2.6, 1.2];
const LONG_SLEEVE: [f64; 2] = [4.4, 1.2];
/// Radius of the socket of a ball, and of the ring of a universal joint.
const SOCKET: f64 = 1.75;
/// Half the length of an arm of a cross.
const CROSS: f64 = 1.9 * SOCKET;
/// Half the height of a barrel, and the width of a piston rod.
const BARREL: f64 = 2.4;
const ROD: f64 = 1.7;
/// The length of the barrel as a share of the cylinder's shortest length, and at least this share
/// of the longest.
const SHARE: [f64; 2] = [0.8, 0.3];
/// Width of outlines.
const OUTLINE: f64 = 0.35;

/// Draws the signs of joints in space, below the circles of their points.
pub(super) fn joint_signs(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let picture = drawing.shown.picture;
    for joint in picture.joints.iter().filter(|_| picture.dimension == 3) {
        let sign = sign(joint.shape);
        let (Some(at), Some(class)) = (sheet.point(joint.point, row), sign.class) else {
            continue;
        };
        let group = Element::new("g").class("joint").class(class);
        let name = picture.points[joint.point].name;
        svg.group(group.set("data-name", name), |svg| {
            if sign.ring {
                svg.add(ring(at));
            }
            for way in bar_directions(drawing, sheet, joint.point, sign.directions, row) {
                match sign.bar {
                    Bar::Sleeve => sleeve(svg, at, way, SLEEVE),
                    Bar::LongSleeve => sleeve(svg, at, way, LONG_SLEEVE),
                    Bar::Line => {
                        let [a, b] = [-1.0, 1.0].map(|end| moved(at, way, CROSS * end, 0.0));
                        svg.add(Element::line(a, b).stroke(Colour::Ink, 0.6));
                    }
                }
            }
        });
    }
}

/// Returns the areas of joints in space, axes and the numbers of gears.
pub(super) fn sign_covers(drawing: &Drawing<'_>, sheet: &Sheet<'_>, row: usize) -> Vec<Taken> {
    let picture = drawing.shown.picture;
    let mut all = Vec::new();
    for axis in picture.axes {
        all.extend(fixed::axis_ends(sheet, axis, row).map(|ends| Taken::new(&ends, 0.5 * OUTLINE)));
    }
    for joint in picture.joints.iter().filter(|_| picture.dimension == 3) {
        let Some(at) = sheet.point(joint.point, row) else {
            continue;
        };
        let sign = sign(joint.shape);
        let [half, high] = match sign.bar {
            Bar::Sleeve => SLEEVE,
            Bar::LongSleeve => LONG_SLEEVE,
            Bar::Line => [CROSS, OUTLINE],
        };
        let ways = bar_directions(drawing, sheet, joint.point, sign.directions, row);
        all.extend(ways.into_iter().map(|way| {
            let ends = [-half, half].map(|end| moved(at, way, end, 0.0));
            Taken::new(&ends, high + OUTLINE)
        }));
        all.push(Taken::new(&[at], SOCKET + OUTLINE));
    }
    for (at, words) in wheels::ratios(drawing, sheet, row) {
        let half = 0.5 * 1.9 * words.chars().count() as f64;
        all.push(Taken::from_area([
            at[0] - half,
            at[1] - 2.4,
            at[0] + half,
            at[1] + 0.6,
        ]));
    }
    all
}

/// The directions of the bars of a sign, on paper.
fn bar_directions(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    point: usize,
    directions: Directions,
    row: usize,
) -> Vec<[f64; 2]> {
    let picture = drawing.shown.picture;
    let axes = picture.axes.iter().filter(|axis| axis.point == point);
    let mut axes = axes.filter_map(|axis| sheet.direction(axis.direction, row));
    match directions {
        Directions::None => Vec::new(),
        Directions::FirstAxis => axes.next().into_iter().collect(),
        Directions::AllAxes => axes.collect(),
        Directions::Guide => {
            let mut guides = picture.guides.iter().filter(|guide| guide.slider == point);
            let along = guides.find_map(|guide| sheet.direction(guide.direction, row));
            along.or_else(|| axes.next()).into_iter().collect()
        }
    }
}

pub(super) fn cylinder_cover(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    guide: &Guide,
    row: usize,
) -> Vec<Taken> {
    let foot = sheet.point(guide.origin, row);
    let mouth = sheet.along(guide.origin, guide.direction, barrel(drawing, guide), row);
    let eye = sheet.point(guide.slider, row);
    let (Some(foot), Some(mouth), Some(eye)) = (foot, mouth, eye) else {
        return Vec::new();
    };
    let rod = Taken::new(&[foot, eye], 0.5 * ROD + OUTLINE);
    Vec::from([rod, Taken::new(&[foot, mouth], BARREL + OUTLINE)])
}

/// Returns true for a filled mark of a point, as a ball in its socket.
pub(super) fn is_filled(drawing: &Drawing<'_>, point: usize) -> bool {
    let picture = drawing.shown.picture;
    let mut joints = picture.joints.iter();
    picture.dimension == 3 && joints.any(|joint| joint.point == point && sign(joint.shape).filled)
}

/// Returns true if all joints in a point slide and none turns.
pub(super) fn only_slides(drawing: &Drawing<'_>, point: usize) -> bool {
    let joints = drawing.shown.picture.joints.iter();
    let mut here = joints.filter(|joint| joint.point == point).peekable();
    here.peek().is_some() && here.all(|here| !sign(here.shape).turns)
}

/// Cylinders: a barrel from the one end, a piston rod from the other.
pub(super) fn cylinders(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let guides = drawing.shown.picture.guides.iter().enumerate();
    for (index, guide) in guides.filter(|(_, guide)| guide.shape == GuideShape::Cylinder) {
        let barrel = barrel(drawing, guide);
        let foot = sheet.point(guide.origin, row);
        let mouth = sheet.along(guide.origin, guide.direction, barrel, row);
        let eye = sheet.point(guide.slider, row);
        let way = sheet.direction(guide.direction, row);
        let (Some(foot), Some(mouth), Some(eye), Some(way)) = (foot, mouth, eye, way) else {
            continue;
        };
        let colour = Colour::Link(drawing.shown.guide_hue(index));
        let group = Element::new("g")
            .class("cylinder")
            .set("data-name", guide.name);
        svg.group(group, |svg| {
            for (colour, width) in [(Colour::Ink, ROD + 2.0 * OUTLINE), (Colour::Paper, ROD)] {
                let rod = Element::line(foot, eye).class("rod");
                svg.add(rod.stroke(colour, width).set("stroke-linecap", "round"));
            }
            let corners: Vec<[f64; 2]> = [(foot, 1.0), (mouth, 1.0), (mouth, -1.0), (foot, -1.0)]
                .into_iter()
                .map(|(at, side)| moved(at, way, 0.0, side * BARREL))
                .collect();
            let tube = Element::polygon(corners).class("barrel");
            svg.add(tube.fill(colour).stroke(Colour::Ink, 0.45));
        });
    }
}

/// The length of a barrel: the piston rod shows at every position.
fn barrel(drawing: &Drawing<'_>, guide: &Guide) -> f64 {
    let [low, high] = drawing.shown.travel(guide);
    (SHARE[0] * low).max(SHARE[1] * high)
}

fn ring(at: [f64; 2]) -> Element {
    let ring = Element::circle(at, SOCKET).class("socket");
    ring.fill(Colour::Paper).stroke(Colour::Ink, 0.45)
}

/// A piece of a tube along a direction.
fn sleeve(svg: &mut Svg, at: [f64; 2], way: [f64; 2], [half, high]: [f64; 2]) {
    let corners = [(half, high), (half, -high), (-half, -high), (-half, high)];
    let corners = corners.map(|(along, left)| moved(at, way, along, left));
    let tube = Element::polygon(corners).class("sleeve");
    svg.add(tube.fill(Colour::Paper).stroke(Colour::Ink, 0.45));
}

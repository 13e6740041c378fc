//! Names of points: each where nothing is below it, beside its point if there is room, otherwise at
//! the end of a thin line. The page places them by the same rule.

use core::f64::consts::{FRAC_PI_4, TAU};

use std::vec::Vec;

use super::options::Drawing;
use super::room::{Area, Taken};
use super::sheet::Sheet;
use super::sizes::{JOINT, LETTER_SIZE, LETTER_WIDTH};
use super::{caption, cover, legend_layout};
use linkage_core::PointKind;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Distance between a name and other shapes, and between a joint and its name.
const CLEAR: f64 = 0.5;
const APART: f64 = 0.8;
/// Up to here a name seems to belong to its point without a line.
const BESIDE: f64 = 2.2;
/// Distances of names from their points.
const RINGS: [f64; 11] = [0.0, 1.1, 2.2, 5.3, 8.8, 12.8, 17.6, 23.5, 30.0, 38.0, 48.0];
/// Ways from the point, evenly spread; names are to the upper right unless something is there.
const WAYS: usize = 16;
const FIRST_WAY: f64 = -FRAC_PI_4;
/// The price of the next direction in millimetres of distance, and the price of a line to a name
/// that crosses a joint or another line.
const TURNED: f64 = 0.27;
const CROSSING: f64 = 8.0;
/// Around all words.
const EDGE: f64 = 1.0;

/// A candidate area for a name.
struct Placement {
    area: Area,
    /// The line from the rim of its joint to the name, if that is farther away.
    leader: Option<[[f64; 2]; 2]>,
    price: f64,
}

/// The shapes and the names that have been placed so far.
struct Scene {
    taken: Vec<Taken>,
    names: Vec<Taken>,
    leaders: Vec<Taken>,
    joints: Vec<[f64; 2]>,
    /// The part of the sheet between caption and title.
    limits: Area,
}

pub(super) fn point_names(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let points = drawing.shown.picture.points.iter().enumerate();
    let points = points.filter(|(_, point)| point.kind != PointKind::Construction);
    let points = points.filter_map(|(index, point)| Some((sheet.point(index, row)?, point)));
    let points: Vec<_> = points.collect();
    let mut scene = Scene {
        taken: cover::covered(drawing, sheet, row),
        names: Vec::new(),
        leaders: Vec::new(),
        joints: points.iter().map(|(at, _)| *at).collect(),
        limits: limits(drawing, sheet),
    };
    for (at, point) in points {
        let half = [
            0.5 * LETTER_WIDTH * point.name.chars().count() as f64,
            0.5 * LETTER_SIZE,
        ];
        let placement = scene.best(at, half);
        scene.names.push(Taken::from_area(placement.area));
        if let Some([from, to]) = placement.leader {
            scene.leaders.push(Taken::new(&[from, to], 0.0));
            let line = Element::line(from, to).class("leader");
            svg.add(line.stroke(Colour::Muted, 0.2));
        }
        let [left, top, right, bottom] = placement.area;
        // Letters stand on a line a good third of their size below the middle.
        let middle = [
            0.5 * (left + right),
            0.5 * (top + bottom) + 0.35 * LETTER_SIZE,
        ];
        let words = Element::text(middle, LETTER_SIZE)
            .anchor("middle")
            .class("name");
        // Legible over ghosts.
        let words = words
            .stroke(Colour::Paper, 0.9)
            .set("paint-order", "stroke");
        svg.words(
            words.fill(Colour::Ink).set("stroke-linejoin", "round"),
            point.name,
        );
    }
}

fn limits(drawing: &Drawing<'_>, sheet: &Sheet<'_>) -> Area {
    let [width, height] = sheet.size;
    [
        EDGE,
        caption::title_end(drawing) + legend_layout::height(drawing, width) + EDGE,
        width - EDGE,
        height - super::caption::FOOT - EDGE,
    ]
}

impl Scene {
    /// The cheapest of the places that are free; if none is, the one with the most room.
    fn best(&self, at: [f64; 2], half: [f64; 2]) -> Placement {
        let mut best: Option<Placement> = None;
        let mut widest: Option<(f64, Placement)> = None;
        for ring in RINGS {
            if best.as_ref().is_some_and(|best| best.price <= ring) {
                break;
            }
            for way in 0..WAYS {
                let placement = self.candidate(at, half, ring, way);
                let is_useless = |room: f64| {
                    room < CLEAR && widest.as_ref().is_some_and(|(most, _)| room <= *most)
                };
                let room = self.room(&placement, is_useless);
                if room >= CLEAR
                    && best
                        .as_ref()
                        .is_none_or(|best| placement.price < best.price)
                {
                    best = Some(placement);
                } else if widest.as_ref().is_none_or(|(most, _)| room > *most) {
                    widest = Some((room, placement));
                }
            }
        }
        best.or(widest.map(|(_, placement)| placement))
            .unwrap_or_else(|| self.candidate(at, half, 0.0, 0))
    }

    fn candidate(&self, at: [f64; 2], half: [f64; 2], ring: f64, way: usize) -> Placement {
        // To both sides in turn, so that earlier ways are nearer to the first.
        let side = if way.is_multiple_of(2) { -1.0 } else { 1.0 };
        let steps = side * way.div_ceil(2) as f64;
        let (s, c) = (FIRST_WAY + steps * TAU / WAYS as f64).sin_cos();
        let away = away(JOINT + APART + ring, half, [c, s]);
        let [x, y] = [at[0] + away * c, at[1] + away * s];
        let area = [x - half[0], y - half[1], x + half[0], y + half[1]];
        let leader = (ring > BESIDE).then(|| leader(at, area));
        let price =
            ring + TURNED * way as f64 + leader.map_or(0.0, |line| self.crossings(at, line));
        Placement {
            area,
            leader,
            price,
        }
    }

    /// Returns the distance of a name from everything else, negative beyond the edges of the sheet,
    /// or any distance from a part of this that is of no use.
    fn room(&self, placement: &Placement, is_useless: impl Fn(f64) -> bool) -> f64 {
        let Placement { area, leader, .. } = placement;
        let inside = [
            area[0] - self.limits[0],
            area[1] - self.limits[1],
            self.limits[2] - area[2],
            self.limits[3] - area[3],
        ];
        let inside = inside.into_iter().fold(f64::INFINITY, f64::min);
        // A name just inside is as good as one far inside.
        let mut least = if inside < 0.0 { inside } else { f64::INFINITY };
        let mut shapes = self.taken.iter().chain(&self.leaders).chain(&self.names);
        while let Some(shape) = shapes.next().filter(|_| !is_useless(least)) {
            least = shape.least_room(*area, least);
        }
        let Some([from, to]) = *leader else {
            return least;
        };
        let line = Taken::new(&[from, to], 0.0);
        let names = self.names.iter().map(|name| line.room(name.bounds()));
        names.fold(least, f64::min)
    }

    fn crossings(&self, joint: [f64; 2], line: [[f64; 2]; 2]) -> f64 {
        let others = self.joints.iter().filter(|at| **at != joint);
        let joints = others.filter(|at| super::geometry::distance(**at, line) < JOINT);
        let lines = self.leaders.iter().filter(|other| other.crosses(line));
        CROSSING * (joints.count() + lines.count()) as f64
    }
}

/// Returns the distance along a direction at which the middle of a box is this far from its start.
fn away(apart: f64, [wide, high]: [f64; 2], way: [f64; 2]) -> f64 {
    let [c, s] = way.map(f64::abs);
    // Beside, above or below, otherwise with a corner.
    if s * (apart + wide) <= c * high {
        return (apart + wide) / c;
    }
    if c * (apart + high) <= s * wide {
        return (apart + high) / s;
    }
    let middle = c * wide + s * high;
    middle + (middle * middle - wide * wide - high * high + apart * apart).sqrt()
}

/// Returns the line from the rim of a joint to the nearest place of a box.
fn leader(at: [f64; 2], [left, top, right, bottom]: Area) -> [[f64; 2]; 2] {
    let end = [at[0].clamp(left, right), at[1].clamp(top, bottom)];
    let length = (end[0] - at[0]).hypot(end[1] - at[1]);
    let rim = [0, 1].map(|k| at[k] + JOINT * (end[k] - at[k]) / length);
    [rim, end]
}

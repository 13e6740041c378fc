//! Names beside points.

use std::vec::Vec;

use super::Drawing;
use super::fixed::{FOOT, rightwards};
use super::geometry::{distance, moved};
use super::parts::BLOCK;
use super::sheet::{BEYOND, Sheet};
use crate::report::colour::Colour;
use crate::report::svg::{Element, Svg};
use crate::{GuideOn, PointKind};

/// Size of the letters and average width of one.
const SIZE: f64 = 3.2;
const LETTER: f64 = 1.9;
/// Distance of a name from its point.
const APART: f64 = 2.7;
/// A name this far from everything is as good as one farther away.
const ENOUGH: f64 = 3.6;

/// From the middle of a frame's guide to that of its hatching.
const HATCHED: f64 = BLOCK[1] + 0.7;

/// Where the middle of a name may be, as directions from its point; the first ones are preferred.
const SIDES: [[f64; 2]; 12] = [
    [1.0, -0.8],
    [-1.0, -0.8],
    [1.0, 0.8],
    [-1.0, 0.8],
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [1.0, -1.6],
    [-1.0, -1.6],
    [1.0, 1.6],
    [-1.0, 1.6],
];

type Stretch = [[f64; 2]; 2];

impl Drawing<'_> {
    /// Width of the longest name on paper.
    pub(super) fn names_width(&self) -> f64 {
        let points = self.shown.picture.points.iter().filter(|_| self.names);
        let letters = points.map(|point| point.name.chars().count());
        LETTER * letters.max().unwrap_or(0) as f64
    }

    pub(super) fn point_names(&self, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
        let mut taken = self.stretches(sheet, row);
        for (index, point) in self.shown.picture.points.iter().enumerate() {
            let is_drawn = point.kind != PointKind::Construction;
            let Some(at) = sheet.point(index, row).filter(|_| is_drawn) else {
                continue;
            };
            let half = [
                0.5 * LETTER * point.name.chars().count() as f64,
                0.35 * SIZE,
            ];
            let candidates = SIDES.map(|side| {
                let [x, y] = [0, 1].map(|k| at[k] + side[k] * (APART + half[k]));
                [[x - half[0], y], [x + half[0], y]]
            });
            let Some(place) = freest(&candidates, &taken, sheet.size) else {
                continue;
            };
            taken.push(place);
            let [left, right] = place;
            let middle = [0.5 * (left[0] + right[0]), left[1] + half[1]];
            let words = Element::text(middle, SIZE).anchor("middle").class("name");
            // Legible over paths and ghosts.
            let words = words
                .stroke(Colour::Paper, 0.9)
                .set("paint-order", "stroke");
            svg.words(
                words.fill(Colour::Ink).set("stroke-linejoin", "round"),
                point.name,
            );
        }
    }

    /// What names should keep away from.
    fn stretches(&self, sheet: &Sheet<'_>, row: usize) -> Vec<Stretch> {
        let picture = self.shown.picture;
        let mut stretches = Vec::new();
        for link in picture.links {
            let points: Vec<_> = link
                .points
                .iter()
                .filter_map(|p| sheet.point(*p, row))
                .collect();
            for (i, a) in points.iter().enumerate() {
                stretches.extend(points[i + 1..].iter().map(|b| [*a, *b]));
            }
        }
        stretches.extend(self.marks(sheet, row));
        for line in self.drive_lines(sheet, row) {
            stretches.extend(line.windows(2).map(|ends| [ends[0], ends[1]]));
        }
        for guide in picture.guides {
            let ends = self.shown.rail(guide);
            let ends = ends.map(|way| sheet.along(guide.origin, guide.direction, way, row));
            if let [Some(a), Some(b)] = ends {
                stretches.push([a, b]);
                if guide.on == GuideOn::Frame {
                    let way = rightwards(sheet.direction(guide.direction, row));
                    let beside = |at, along| moved(at, way.unwrap_or_default(), along, -HATCHED);
                    // The hatched line goes on beyond both ends.
                    stretches.extend(
                        [a, b].map(|end| [-BEYOND, BEYOND].map(|along| beside(end, along))),
                    );
                    stretches.push([beside(a, 0.0), beside(b, 0.0)]);
                }
            }
            let block = sheet
                .point(guide.slider, row)
                .zip(sheet.direction(guide.direction, row));
            stretches.extend(block.into_iter().flat_map(|(at, way)| {
                let [half, high] = BLOCK;
                let edge = |left| [moved(at, way, -half, left), moved(at, way, half, left)];
                [edge(high), edge(-high)]
            }));
        }
        for (index, point) in picture.points.iter().enumerate() {
            if let Some([x, y]) = sheet.point(index, row) {
                stretches.push([[x, y]; 2]);
                if point.kind == PointKind::Ground {
                    let [height, half] = FOOT;
                    let below = y + height + 0.5;
                    stretches.push([[x - 1.6 * half, below], [x + 1.6 * half, below]]);
                }
            }
        }
        stretches
    }
}

/// Millimetres: what is less is rounding, and the place before stays the best.
const BETTER: f64 = 1e-6;

/// The first of the places with the most room around it.
fn freest(candidates: &[Stretch], taken: &[Stretch], size: [f64; 2]) -> Option<Stretch> {
    let room = |[left, right]: &Stretch| {
        let outside = left[0] < 1.0 || right[0] > size[0] - 1.0;
        let samples =
            [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| [left[0] + t * (right[0] - left[0]), left[1]]);
        let distances = taken
            .iter()
            .flat_map(|stretch| samples.map(|sample| distance(sample, *stretch)));
        let nearest = distances.fold(ENOUGH, f64::min);
        if outside { nearest - ENOUGH } else { nearest }
    };
    let rooms = candidates
        .iter()
        .map(|candidate| (room(candidate), candidate));
    let best = rooms.reduce(|best, next| if next.0 > best.0 + BETTER { next } else { best });
    best.map(|(_, place)| *place)
}

//! The points at several positions: what coincides, what stays, what keeps its distance.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Nominal};
use crate::close::{Reference, places};

use super::chains::Spot;

/// Lengths that differ by a smaller share of the picture's size are equal.
const EQUAL: f64 = 1e-9;

/// Unit vectors that differ by less are one direction. They are quotients of differences of points, so they are known less well than
/// these.
const STEADY: f64 = 1e3 * EQUAL;

pub(super) struct Seen<'a> {
    reference: &'a Reference,
    /// Inputs at which the mechanism closes.
    pub(super) places: Vec<Vec<f64>>,
    /// By point: its coordinates at each place.
    tracks: Vec<Vec<Vec<f64>>>,
    /// By point: the first that is always at the same place.
    pub(super) same: Vec<usize>,
    /// Whether a point stays where it is.
    fixed: Vec<bool>,
    /// The extent of the picture.
    pub(super) size: f64,
}

impl<'a> Seen<'a> {
    pub(super) fn new<'m>(
        algebra: &Algebra<'m>,
        points: &[Spot<'m>],
        reference: &'a Reference,
        nominal: &Nominal,
    ) -> Self {
        let mut seen = Self {
            reference,
            places: places(nominal, algebra.mechanism, reference.longest),
            tracks: Vec::new(),
            same: Vec::new(),
            fixed: Vec::new(),
            size: 0.0,
        };
        let unknowns = 0..algebra.names.bound.len();
        let all: Vec<Ex> = unknowns
            .flat_map(|own| algebra.names.numbers_of(own))
            .collect();
        let closes = |inputs: &Vec<f64>| {
            let values = reference.machine.evaluate(&all, inputs);
            values.iter().all(|x| x.is_finite())
        };
        seen.places.retain(closes);
        seen.add(algebra, points);
        seen
    }

    /// Looks at further points.
    pub(super) fn add<'m>(&mut self, algebra: &Algebra<'m>, points: &[Spot<'m>]) {
        let structure = algebra.mechanism.inputs.is_empty();
        for point in points {
            let track = self.track(point.at);
            self.size = track
                .iter()
                .flatten()
                .fold(self.size, |size, x| size.max(x.abs()));
            self.tracks.push(track);
            // Nothing moves in a structure: what its loops tell is not fixed.
            let found =
                structure && algebra.depends_on_unknowns(&point.at.iter().collect::<Vec<_>>());
            self.fixed.push(!found);
        }
        for index in self.same.len()..self.tracks.len() {
            let first = (0..index).find(|&other| self.coincide(other, index));
            self.same.push(first.unwrap_or(index));
            let track = &self.tracks[index];
            let stays = track.iter().all(|at| self.near(distance(at, &track[0])));
            self.fixed[index] &= stays;
        }
    }

    /// A vector at each place.
    pub(super) fn track(&self, vector: Vn) -> Vec<Vec<f64>> {
        let components: Vec<Ex> = vector.iter().collect();
        let machine = &self.reference.machine;
        let places = self.places.iter();
        places
            .map(|inputs| machine.evaluate(&components, inputs))
            .collect()
    }

    /// Whether a point has a place wherever the mechanism closes.
    pub(super) fn is_known(&self, point: usize) -> bool {
        self.tracks[point].iter().flatten().all(|x| x.is_finite())
    }

    pub(super) fn is_fixed(&self, point: usize) -> bool {
        self.fixed[point]
    }

    /// The distance of two points at each place.
    pub(super) fn distances(&self, a: usize, b: usize) -> Vec<f64> {
        let pairs = self.tracks[a].iter().zip(&self.tracks[b]);
        pairs.map(|(a, b)| distance(a, b)).collect()
    }

    /// Whether two points keep their distance.
    pub(super) fn keep_distance(&self, a: usize, b: usize) -> bool {
        self.steady(&self.distances(a, b))
    }

    /// Whether a direction never changes.
    pub(super) fn is_steady(&self, directions: &[Vec<f64>]) -> bool {
        directions
            .iter()
            .all(|at| distance(at, &directions[0]) < STEADY)
    }

    /// Whether the end of a vector that begins in a point keeps its distance from another point.
    pub(super) fn carries(&self, point: usize, origin: usize, along: &[Vec<f64>]) -> bool {
        let size = self.size;
        let ends = self.tracks[origin].iter().zip(along);
        let ends = ends.map(|(at, way)| -> Vec<f64> {
            at.iter().zip(way).map(|(x, d)| x + size * d).collect()
        });
        let distances = ends
            .zip(&self.tracks[point])
            .map(|(end, at)| distance(&end, at));
        self.steady(&distances.collect::<Vec<_>>())
    }

    fn coincide(&self, a: usize, b: usize) -> bool {
        self.distances(a, b)
            .into_iter()
            .all(|apart| self.near(apart))
    }

    fn steady(&self, lengths: &[f64]) -> bool {
        lengths.iter().all(|length| self.near(length - lengths[0]))
    }

    fn near(&self, difference: f64) -> bool {
        difference.abs() <= EQUAL * self.size
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(x, y)| (x - y) * (x - y));
    squares.sum::<f64>().sqrt()
}

//! The points at several positions and with other dimensions: what coincides, what stays, what keeps its distance.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Nominal};
use crate::machine::{Machine, Reference};

use super::cells::Cells;
use super::marks::Spot;
use super::open_loop::{Free, Rate, Track};
use super::views::{View, views};

/// Lengths that differ by a smaller share of the picture's size are equal.
const EQUAL: f64 = 1e-9;

/// Unit vectors that differ by less are one direction. They are quotients of differences of points, so they are known less well than
/// these.
const STEADY: f64 = 1e3 * EQUAL;

pub(super) struct Seen<'a> {
    free: Free<'a>,
    views: Vec<View>,
    /// By point: its coordinates, view by view.
    tracks: Vec<Track>,
    /// Other dimensions, where the mechanism closes with none of them: what no loop leads to stands somewhere nevertheless.
    open: Vec<Machine>,
    /// By point: its coordinates with these dimensions, no numbers where loops lead to it.
    without_loops: Vec<Track>,
    /// By point: where it is and how it moves where nothing closes the loops.
    courses: Vec<Track>,
    /// By point: the first that is always at the same place.
    pub(super) same: Vec<usize>,
    /// By point that is the first: all that are always at its place.
    alike: Vec<Vec<usize>>,
    /// By point: whether it says of itself that it does not move.
    fixed: Vec<bool>,
    /// The extent of the picture.
    pub(super) size: f64,
}

impl<'a> Seen<'a> {
    pub(super) fn new<'m>(
        algebra: &mut Algebra<'m>,
        points: &[Spot<'m>],
        reference: &'a Reference,
        nominal: &Nominal,
    ) -> Self {
        let (views, open) = views(algebra, reference, nominal);
        let mut seen = Self {
            views,
            open,
            without_loops: Vec::new(),
            free: Free::new(algebra, reference, nominal),
            tracks: Vec::new(),
            courses: Vec::new(),
            same: Vec::new(),
            alike: Vec::new(),
            fixed: Vec::new(),
            size: 0.0,
        };
        seen.add(points);
        seen
    }

    /// At how many inputs the mechanism closes as it is written.
    pub(super) fn places(&self) -> usize {
        self.views[0].places.len()
    }

    /// Looks at further points.
    pub(super) fn add(&mut self, points: &[Spot]) {
        // All at once: points at the end of a chain have most of it in common.
        let vectors: Vec<Vn> = points.iter().map(|point| point.at).collect();
        let tracks = self.tracks_of(&vectors);
        let courses = self.free.courses(&vectors);
        self.without_loops.extend(self.without_loops_of(&vectors));
        for (track, course) in tracks.into_iter().zip(courses) {
            self.size = track
                .iter()
                .flatten()
                .fold(self.size, |size, x| size.max(x.abs()));
            self.tracks.push(track);
            let size = self.size;
            self.fixed.push(self.free.rests(&course, size));
            self.courses.push(course);
        }
        let mut cells = Cells::new(EQUAL * self.size);
        for index in 0..self.tracks.len() {
            if index >= self.same.len() {
                let mut near = cells.near(&self.tracks[index]).into_iter();
                let first = near.find(|&other| self.coincide(other, index));
                let first = first.unwrap_or(index);
                self.same.push(first);
                self.alike.push(Vec::new());
                self.alike[first].push(index);
                self.fixed[first] |= self.fixed[index];
            }
            cells.add(index, &self.tracks[index]);
        }
    }

    /// Vectors at each place of each view.
    pub(super) fn tracks_of(&self, vectors: &[Vn]) -> Vec<Track> {
        let components: Vec<Ex> = vectors.iter().flat_map(|own| own.iter()).collect();
        let look = |view: &View| -> Track {
            let places = view.places.iter();
            places
                .map(|inputs| view.machine.evaluate(&components, inputs))
                .collect()
        };
        divided(&self.views.iter().flat_map(look).collect(), vectors)
    }

    /// Vectors at one place with each of the dimensions that the mechanism does not close with.
    fn without_loops_of(&self, vectors: &[Vn]) -> Vec<Track> {
        let components: Vec<Ex> = vectors.iter().flat_map(|own| own.iter()).collect();
        let look = |machine: &Machine| {
            let place = self.views[0].places.first();
            place.map(|inputs| machine.evaluate(&components, inputs))
        };
        divided(&self.open.iter().filter_map(look).collect(), vectors)
    }

    /// Where a point is at the places that are looked at with the dimensions as they are written.
    pub(super) fn places_of(&self, point: usize) -> &[Vec<f64>] {
        &self.tracks[point][self.views[0].own.clone()]
    }

    /// Where a point is and how it moves where nothing closes the loops.
    pub(super) fn course(&self, point: usize) -> &Track {
        &self.courses[point]
    }

    /// The rate at which the distance of two points changes, as they are written.
    pub(super) fn stretching(&self, a: usize, b: usize) -> Rate {
        self.free.stretching([self.course(a), self.course(b)])
    }

    pub(super) fn free(&self) -> &Free<'a> {
        &self.free
    }

    /// All points that are always where this one is.
    pub(super) fn aliases(&self, point: usize) -> impl Iterator<Item = usize> {
        self.alike[self.same[point]].iter().copied()
    }

    /// Whether a point has a place wherever the mechanism closes.
    pub(super) fn is_known(&self, point: usize) -> bool {
        self.tracks[point].iter().flatten().all(|x| x.is_finite())
    }

    /// Whether a point belongs to the frame: it is written so, or is always where one is that is. A link that does not move with
    /// these inputs, as between cylinders that are held, does not make its points fixed.
    pub(super) fn is_fixed(&self, point: usize) -> bool {
        self.fixed[self.same[point]]
    }

    /// The distance of two points at each place, with the dimensions as they are written.
    pub(super) fn distances(&self, a: usize, b: usize) -> Vec<f64> {
        let pairs = self.places_of(a).iter().zip(self.places_of(b));
        pairs.map(|(a, b)| distance(a, b)).collect()
    }

    /// Whether two points keep their distance, with the dimensions as they are written.
    pub(super) fn keep_distance_as_written(&self, a: usize, b: usize) -> bool {
        let lengths = self.distances(a, b);
        lengths.iter().all(|length| self.near(length - lengths[0]))
    }

    /// Whether two points keep their distance, with other dimensions, too.
    pub(super) fn keep_distance(&self, a: usize, b: usize) -> bool {
        let [a, b] = [&self.tracks[a], &self.tracks[b]];
        // Most pairs that are asked for do not, which the first places show.
        self.views.iter().all(|view| {
            let mut own = view.own.clone().map(|place| distance(&a[place], &b[place]));
            let first = own.next();
            first.is_none_or(|first| {
                let mut all = std::iter::once(first).chain(own);
                all.all(|length| self.near(length - first))
            })
        })
    }

    /// Whether two steps of the plane turn by the same angle from place to place.
    pub(super) fn turn_alike(&self, a: (usize, usize), b: (usize, usize)) -> bool {
        let [a, b] = [a, b].map(|(from, to)| difference(self.places_of(to), self.places_of(from)));
        let ratios = a.iter().zip(&b).map(|(a, b)| {
            let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
            vec![dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()]
        });
        let ratios: Track = ratios.collect();
        ratios.iter().all(|at| distance(at, &ratios[0]) < STEADY)
    }

    /// Whether a direction never changes.
    pub(super) fn is_steady(&self, directions: &Track) -> bool {
        self.views.iter().all(|view| {
            let own = &directions[view.own.clone()];
            own.iter().all(|at| distance(at, &own[0]) < STEADY)
        })
    }

    /// Whether the end of a vector that begins in a point keeps its distance from another point.
    pub(super) fn carries(&self, point: usize, origin: usize, along: &Track) -> bool {
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
        let apart = self.tracks[a].iter().zip(&self.tracks[b]);
        let mut apart = apart.map(|(a, b)| distance(a, b));
        let open = self.without_loops[a].iter().zip(&self.without_loops[b]);
        let mut open = open.map(|(a, b)| distance(a, b));
        apart.all(|apart| self.near(apart)) && open.all(|apart| apart.is_nan() || self.near(apart))
    }

    fn steady(&self, lengths: &[f64]) -> bool {
        self.views.iter().all(|view| {
            let own = &lengths[view.own.clone()];
            own.iter().all(|length| self.near(length - own[0]))
        })
    }

    fn near(&self, difference: f64) -> bool {
        difference.abs() <= EQUAL * self.size
    }
}

/// The parts that belong to vectors of lists of all their components.
pub(super) fn divided(all: &Track, vectors: &[Vn]) -> Vec<Track> {
    let mut start = 0;
    let part = vectors.iter().map(|vector| {
        let own = start..start + vector.len();
        start = own.end;
        all.iter().map(|list| list[own.clone()].to_vec()).collect()
    });
    part.collect()
}

pub(super) fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> Track {
    let rows = a.iter().zip(b);
    rows.map(|(a, b)| a.iter().zip(b).map(|(x, y)| x - y).collect())
        .collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(x, y)| (x - y) * (x - y));
    squares.sum::<f64>().sqrt()
}

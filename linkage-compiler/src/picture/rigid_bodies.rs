//! True if two links are written to turn together: where one of them turns as it is written to,
//! nothing closing the loops, the other one turns with it.

use linkage_core::numeric::vector::dot;
use linkage_symbolic::{Ex, Vn};

use crate::picture::marks::Spot;
use crate::picture::raw_link::Frame;
use crate::picture::samples::Samples;
use crate::picture::track::{self, Track};

/// A point lies on the line through two others if it is nearer to it than this share of their
/// distance.
const ON_LINE: f64 = 1e-9;

pub(super) struct Welds<'a, 's, 'm> {
    dimension: usize,
    points: &'s [Spot<'m>],
    samples: &'s Samples<'a>,
}

impl<'a, 's, 'm> Welds<'a, 's, 'm> {
    pub(super) fn new(dimension: usize, points: &'s [Spot<'m>], samples: &'s Samples<'a>) -> Self {
        Self {
            dimension,
            points,
            samples,
        }
    }

    /// True if a pair of points of the second link is carried by a pair of points of the first one,
    /// which has these points.
    pub(super) fn join(&self, first: &[Frame], second: &[Frame], points: &[usize]) -> bool {
        first.iter().any(|carrier| {
            second.iter().any(|carried| {
                let ends = [(carried.from, carried.to), (carried.to, carried.from)];
                let mut ends = ends
                    .into_iter()
                    .filter(|(shared, _)| points.contains(&self.samples.same[*shared]));
                ends.any(|(shared, other)| self.is_carried(carrier, shared, other, carried.step))
            })
        })
    }

    /// True if a link by a pair of points also carries a point that is written beside another one
    /// of the link, a step away.
    fn is_carried(&self, carrier: &Frame, shared: usize, other: usize, step: Vn) -> bool {
        // A point may be written in several ways, each of which says what turns it.
        self.samples.aliases(carrier.from).any(|from| {
            let mut ends = self.samples.aliases(carrier.to);
            ends.any(|to| self.carries([from, to], shared, other, step))
        })
    }

    fn carries(&self, ends: [usize; 2], shared: usize, other: usize, step: Vn) -> bool {
        let samples = self.samples;
        let Some(base) = self.moved_with(ends, shared) else {
            return false;
        };
        let [from, to] = ends;
        let carrier_rate = samples.stretching(from, to);
        // What only loops hold together carries nothing but what is written with both of its ends.
        let is_rigid = samples.free().follows(&carrier_rate, &[]);
        if !is_rigid && !self.is_written_with(step, ends) {
            return false;
        }
        let moved = sum(
            &base,
            &track::difference(samples.course(other), samples.course(shared)),
        );
        let holds = |rate| samples.free().follows(&rate, &[&carrier_rate]);
        holds(samples.stretching(shared, other))
            && ends
                .into_iter()
                .all(|end| holds(samples.free().stretching([&moved, samples.course(end)])))
    }

    /// True if a step is computed from the difference of two points.
    fn is_written_with(&self, step: Vn, ends: [usize; 2]) -> bool {
        let [from, to] = ends.map(|end| &self.points[end]);
        let within = |part: Ex| {
            let graph = part.graph();
            let is_number = graph.constant_value(part.id()).is_some();
            is_number
                || step
                    .iter()
                    .any(|component| graph.contains(component.id(), part.id()))
        };
        let both = [from.step_to(to), to.step_to(from)];
        both.into_iter().any(|vector| vector.iter().all(within))
    }

    /// The course of a point of a link that moves as two of its points say; `None` if they do not
    /// tell.
    fn moved_with(&self, [from, to]: [usize; 2], point: usize) -> Option<Track> {
        let samples = self.samples;
        if let Some(end) = [from, to]
            .into_iter()
            .find(|end| samples.same[*end] == samples.same[point])
        {
            return Some(samples.course(end).clone());
        }
        let [a, b, p] = [from, to, point].map(|index| samples.places_of(index));
        // A link keeps its shape: one place tells it.
        let (axis, arm) = (minus(&b[0], &a[0]), minus(&p[0], &a[0]));
        let square = dot(&axis, &axis);
        let share = dot(&arm, &axis) / square;
        let left = match self.dimension {
            2 => (axis[0] * arm[1] - axis[1] * arm[0]) / square,
            _ => {
                let across: Vec<f64> = arm.iter().zip(&axis).map(|(x, d)| x - share * d).collect();
                let is_on_line = dot(&across, &across) <= ON_LINE * ON_LINE * square;
                is_on_line.then_some(0.0)?
            }
        };
        let courses = samples.course(from).iter().zip(samples.course(to));
        let moved = courses.map(|(a, b)| {
            let turn = minus(b, a);
            let each = a.iter().enumerate();
            let each = each.map(|(k, start)| {
                let side = if left == 0.0 {
                    0.0
                } else {
                    [-turn[1], turn[0]][k]
                };
                start + share * turn[k] + left * side
            });
            each.collect()
        });
        Some(moved.collect())
    }
}

fn sum(a: &Track, b: &Track) -> Track {
    let rows = a.iter().zip(b);
    rows.map(|(a, b)| a.iter().zip(b).map(|(x, y)| x + y).collect())
        .collect()
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(x, y)| x - y).collect()
}

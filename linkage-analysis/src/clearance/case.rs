//! One way in which two shapes can be nearest to each other: from end to end, from an end to the
//! inside of an edge, or from inside to inside.
//!
//! `E` is the vector between two points of the shapes, and `s`, `t` are their positions along the
//! edges. Half the square of the distance is `q = E.E/2`, smooth in angle, positions and
//! parameters. A free position satisfies `dq/ds = 0`. Second derivatives are those of `q` less the
//! part of the free positions: `q_xy - q_xf (q_ff)^-1 q_fy`.

use super::shape::{Feature, Jet, Pair, difference, edge};
use crate::components::norm;
use linkage_core::numeric::vector::dot;

/// The distance of two parts at one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Case<const K: usize> {
    parts: [Feature; 2],
    /// Places along the edges, 0 to 1 within them.
    pub(super) feet: [f64; 2],
    /// The vector from the second point to the first one, with its derivatives for fixed positions.
    pub(super) gap: Jet<K>,
    /// The edges with their first derivatives; zeros for points.
    edges: [[[f64; K]; 2]; 2],
    /// Up to which length the gap may be rounding.
    rounding: f64,
}

/// Roundoffs of coordinates, edges and velocities that a gap may have where two shapes touch.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The effect of a variable on a case with fixed positions along the edges: derivatives of the gap,
/// of its derivative with respect to the angle, and of both edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Variation<const K: usize> {
    pub(super) gap: [f64; K],
    pub(super) rate: [f64; K],
    pub(super) edges: [[f64; K]; 2],
}

/// The rounding error of a position beyond an end, as a share of the edge, and a distance along the
/// edge that counts as none. Both neighbouring cases are then taken for nearest, and one is
/// dropped.
const BESIDE: f64 = 1e-12;

/// An edge with no greater share across another one is parallel to it, except for rounding.
const PARALLEL: f64 = 16.0 * f64::EPSILON;

/// A vector as a multiple of an edge, and its part across the edge. The part of one edge across
/// another is exact to rounding over their angle; the difference `u.u w.w - (u.w)^2` would be exact
/// to rounding over its square.
fn split<const K: usize>(edge: &[f64; K], vector: &[f64; K]) -> (f64, [f64; K]) {
    let ratio = dot(edge, vector) / dot(edge, edge);
    let across: [f64; K] = core::array::from_fn(|k| vector[k] - ratio * edge[k]);
    (ratio, across)
}

impl<const K: usize> Case<K> {
    pub(super) fn new<const A: usize, const B: usize>(
        parts: [Feature; 2],
        pair: &Pair<K, A, B>,
    ) -> Self {
        let [u, w] = [edge(&pair.first), edge(&pair.second)];
        let start = |part: Feature| match part {
            Feature::Vertex(index) => index,
            Feature::Edge => 0,
        };
        let (a, b) = (&pair.first[start(parts[0])], &pair.second[start(parts[1])]);
        let base: Jet<K> = core::array::from_fn(|k| difference(&a[k], &b[k]));
        let [s, t] = match parts {
            [Feature::Vertex(_), Feature::Vertex(_)] => [0.0; 2],
            [Feature::Edge, Feature::Vertex(_)] => [-dot(&base[0], &u[0]) / dot(&u[0], &u[0]), 0.0],
            [Feature::Vertex(_), Feature::Edge] => [0.0, dot(&base[0], &w[0]) / dot(&w[0], &w[0])],
            [Feature::Edge, Feature::Edge] => {
                let uu = dot(&u[0], &u[0]);
                let [(_, across), (_, beside)] = [&w[0], &base[0]].map(|v| split(&u[0], v));
                // An end of parallel edges is as near as any point between: there is no such case.
                let parallel = norm(&across) <= PARALLEL * norm(&w[0]);
                let t = if parallel {
                    f64::NAN
                } else {
                    dot(&beside, &across) / dot(&across, &across)
                };
                // The point follows from `t`: the gap stays across the first edge, wherever
                // rounding put the place on the second one.
                let left: [f64; K] = core::array::from_fn(|k| base[0][k] - t * w[0][k]);
                [-dot(&left, &u[0]) / uu, t]
            }
        };
        let gap = core::array::from_fn(|k| {
            core::array::from_fn(|i| base[k][i] + s * u[k][i] - t * w[k][i])
        });
        let gap: Jet<K> = gap;
        let sizes = [&a[0], &b[0], &u[0], &w[0], &gap[1]];
        let sizes = sizes.into_iter().flatten();
        Self {
            parts,
            feet: [start(parts[0]) as f64 + s, start(parts[1]) as f64 + t],
            gap,
            edges: [[u[0], u[1]], [w[0], w[1]]],
            rounding: ROUNDING * sizes.fold(0.0, |size: f64, x| size.max(x.abs())),
        }
    }

    /// The distance; 0 if it is nothing but rounding.
    pub(super) fn distance(&self) -> f64 {
        match norm(&self.gap[0]) {
            distance if distance <= self.rounding => 0.0,
            distance => distance,
        }
    }

    /// Half the square of the distance with its derivatives by the angle.
    pub(super) fn jet(&self) -> [f64; 3] {
        let [gap, rate, _] = &self.gap;
        [0.5 * dot(gap, gap), dot(gap, rate), self.bend()]
    }

    /// The second derivative of that by the angle.
    pub(super) fn bend(&self) -> f64 {
        let angle = self.gradient(&self.angle());
        angle[0] - self.taken_up(&angle, &angle)
    }

    /// Returns true if no point of the shapes is nearer: the distance does not decrease along an
    /// edge.
    pub(super) fn is_nearest(&self) -> bool {
        let [gap, ..] = &self.gap;
        (0..2).all(|side| {
            let edge = &self.edges[side][0];
            let along = if side == 0 {
                dot(gap, edge)
            } else {
                -dot(gap, edge)
            };
            let size = dot(edge, edge);
            match self.parts[side] {
                Feature::Vertex(0) => along >= -BESIDE * size,
                Feature::Vertex(_) => along <= BESIDE * size,
                Feature::Edge => self.feet[side] >= -BESIDE && self.feet[side] <= 1.0 + BESIDE,
            }
        })
    }

    /// The variation of the angle.
    fn angle(&self) -> Variation<K> {
        let [_, rate, second] = self.gap;
        Variation {
            gap: rate,
            rate: second,
            edges: [self.edges[0][1], self.edges[1][1]],
        }
    }

    /// The derivatives of `q` by a variable and by the angle and both places.
    fn gradient(&self, by: &Variation<K>) -> [f64; 3] {
        let [gap, rate, _] = &self.gap;
        let along = |side: usize| dot(&by.gap, &self.edges[side][0]) + dot(gap, &by.edges[side]);
        [dot(&by.gap, rate) + dot(gap, &by.rate), along(0), -along(1)]
    }

    /// The part of the free positions in the second derivative with respect to two variables.
    fn taken_up(&self, x: &[f64; 3], y: &[f64; 3]) -> f64 {
        let [u, w] = [&self.edges[0][0], &self.edges[1][0]];
        match self.parts {
            [Feature::Vertex(_), Feature::Vertex(_)] => 0.0,
            [Feature::Edge, Feature::Vertex(_)] => x[1] * y[1] / dot(u, u),
            [Feature::Vertex(_), Feature::Edge] => x[2] * y[2] / dot(w, w),
            // The matrix of both places, the first one eliminated.
            [Feature::Edge, Feature::Edge] => {
                let (ratio, across) = split(u, w);
                let rest = |x: &[f64; 3]| x[2] + ratio * x[1];
                x[1] * y[1] / dot(u, u) + rest(x) * rest(y) / dot(&across, &across)
            }
        }
    }

    /// The second derivative of `q` by the angle and a variable.
    pub(super) fn mixed(&self, by: &Variation<K>) -> f64 {
        let (angle, gradient) = (self.gradient(&self.angle()), self.gradient(by));
        gradient[0] - self.taken_up(&angle, &gradient)
    }

    /// Slope and second derivative of `q` by the phase of the second shape, whose derivatives by it
    /// are those by the angle, where the angle follows so that `q` stays least.
    pub(super) fn by_phase(&self, second: &Jet<K>) -> [f64; 2] {
        let [gap, ..] = &self.gap;
        let by = Variation {
            gap: second[1].map(|v| -v),
            rate: second[2].map(|a| -a),
            edges: [[0.0; K], self.edges[1][1]],
        };
        let gradient = self.gradient(&by);
        let held = dot(&by.gap, &by.gap) + dot(gap, &by.rate) - self.taken_up(&gradient, &gradient);
        let mixed = self.mixed(&by);
        [dot(gap, &by.gap), held - mixed * mixed / self.bend()]
    }
}

#[cfg(test)]
mod tests {
    use super::{Case, Feature, Pair};
    use crate::clearance::shape::Jet;
    use linkage_random::Random;

    /// A vector with whole components, turned by a matrix of whole numbers that is three times a
    /// rotation: exact.
    fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
        [
            2.0 * x - y + 2.0 * z,
            2.0 * x + 2.0 * y - z,
            2.0 * y + 2.0 * z - x,
        ]
    }

    fn fixed(point: [f64; 3]) -> Jet<3> {
        [point, [0.0; 3], [0.0; 3]]
    }

    /// Edges whose feet and distance are known without rounding, down to angles of 1e-7.
    #[test]
    fn nearly_parallel_edges_keep_their_distance() {
        let mut random = Random::new(22);
        let mut whole = |low: f64, high: f64| 8.0 * random.between(low, high).round();
        for angle in [1.0, 1e-2, 1e-4, 1e-5, 1e-6, 1e-7] {
            for _ in 0..200 {
                let (long, height) = (whole(1e6, 4e6), whole(1e2, 1e5));
                let other = whole(1e6, 4e6);
                let sideways = 8.0 * (angle * other / 8.0).round().max(1.0);
                let (u, w) = ([long, 0.0, 0.0], [other, sideways, 0.0]);
                let feet = [0.125 * whole(1.0, 7.0) / 8.0, 0.125 * whole(1.0, 7.0) / 8.0];
                // The first point of the second edge, if both places are one above the other.
                let start: [f64; 3] = core::array::from_fn(|k| feet[0] * u[k] - feet[1] * w[k]);
                let start = [start[0], start[1], -height];
                let end = core::array::from_fn(|k| start[k] + w[k]);
                let pair = Pair {
                    first: [fixed([0.0; 3]), fixed(turned(u))],
                    second: [fixed(turned(start)), fixed(turned(end))],
                };
                let case = Case::new([Feature::Edge; 2], &pair);
                let distance = 3.0 * height;
                let error = (case.distance() - distance).abs() / distance;
                assert!(error < 1e-14, "{angle}: {error} of the distance");
                let angle = sideways / other;
                let bound = 1e-14 * (1.0 + height / (angle * other)) / angle;
                for (foot, known) in case.feet.iter().zip(feet) {
                    let error = (foot - known).abs();
                    assert!(error < bound, "{angle}: {error} of an edge, not {bound}");
                }
            }
        }
    }

    #[test]
    fn parallel_edges_are_nearest_at_an_end() {
        let [a, b, c] = [[0.1, 0.2, 0.3], [0.7, 1.4, 2.1], [0.4, 1.0, 1.8]];
        let d = core::array::from_fn(|k| c[k] + 0.7 * (b[k] - a[k]));
        let pair = Pair {
            first: [fixed(a), fixed(b)],
            second: [fixed(c), fixed(d)],
        };
        assert!(!Case::new([Feature::Edge; 2], &pair).is_nearest());
        assert!(Case::new([Feature::Edge, Feature::Vertex(0)], &pair).is_nearest());
    }
}

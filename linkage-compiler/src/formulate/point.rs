//! A point at given distances from known points and on known planes, a direction at given angles to known directions.

mod differentiate;

use linkage_symbolic::program::Unary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::structure::{Plane, Sphere};

use super::space::Space;
use super::{Closed, GapIn, Solver};

/// About what a vector's length is of the sum of its components, which needs no root: it is 0.58 to 1.
const SUM_OF_COMPONENTS: f64 = 0.625;

/// A sphere `|f (p - centre)| = radius`, with its own numbers.
struct Ball {
    centre: Space,
    /// As a distance from the centre, and scaled.
    radius: NodeId,
    scaled: NodeId,
    /// From the first sphere's centre, scaled.
    apart: Space,
}

/// A plane `normal . (p - centre of the first sphere) = offset`, scaled; the normal is that of the user of length 1, or the
/// distance of two centres.
struct Level {
    normal: Space,
    offset: NodeId,
    /// What the offset's rounding is measured by.
    size: NodeId,
    /// What the normal's length is measured by in the margin.
    largest: NodeId,
}

/// Where a point lies.
struct Place {
    /// From the first sphere's centre, scaled.
    arm: Space,
    /// What lengths are multiplied by.
    scale: NodeId,
    /// Scaled, 0 at the dead point.
    h: NodeId,
}

impl Solver<'_, '_> {
    /// The difference of two spheres is a plane, so there are two planes `u.y = a`, `v.y = b` and a sphere. Their line goes along
    /// `n = u x v`; its foot is `t x n / n.n` with `t = a v - b u`, at the distance `|t|/|n|`, and the root is
    /// `h = sqrt(r^2 - t.t/n.n)`. Lengths are scaled by a power of two, so that products of many do not
    /// overflow.
    pub(super) fn point(
        &mut self,
        coordinates: &[(SymbolId, usize)],
        spheres: &[Sphere],
        planes: &[Plane],
    ) -> Closed {
        let mut coordinates = coordinates.to_vec();
        coordinates.sort_by_key(|(_, component)| *component);
        let missing = (0..3).find(|k| coordinates.iter().all(|(_, component)| component != k));

        let (scale, balls) = self.balls(spheres);
        let base = &balls[0];
        let mut levels = Vec::new();
        for ball in &balls[1..] {
            levels.push(self.radical_plane(base, ball));
        }
        for plane in planes {
            levels.push(self.level(base, plane, scale));
        }
        if let Some(component) = missing {
            let graph = &mut self.algebra.graph;
            let (zero, one) = (graph.zero(), graph.one());
            let mut normal = [zero; 3];
            normal[component] = one;
            let plane = Plane {
                normal,
                offset: zero,
            };
            levels.push(self.level(base, &plane, scale));
        }
        let [first, second] = &levels[..] else {
            unreachable!("three conditions: a sphere and two planes");
        };

        let w = self.mode_sign();
        let normal = self.algebra.cross3(first.normal, second.normal);
        let sine2 = self.algebra.dot(&normal, &normal);
        let sine = self.algebra.length(&normal);
        let graph = &mut self.algebra.graph;
        let (one, minus) = (graph.one(), graph.neg(second.offset));
        let inverse = graph.div(one, sine2);
        let between = self.combine(first.offset, second.normal, minus, first.normal);
        let radius = base.scaled;
        let radius2 = self.algebra.graph.square(radius);
        let between2 = self.algebra.dot(&between, &between);
        let graph = &mut self.algebra.graph;
        let distance2 = graph.mul(between2, inverse);
        let q = graph.sub(radius2, distance2);
        let reach = self.lengths_of(first, second);
        let graph = &mut self.algebra.graph;
        let shallow = graph.mul(sine, inverse);
        let sizes = graph.mul(reach, shallow);
        let share = graph.constant(SUM_OF_COMPONENTS);
        let share = graph.mul(share, radius);
        let far = graph.mul(share, sizes);
        let noise = graph.add(far, radius2);
        let h = self.root(q, noise);
        let graph = &mut self.algebra.graph;
        let hw = graph.mul(w, h);
        let volume = graph.mul(hw, sine);
        let rise = graph.mul(hw, shallow);
        let foot = self.algebra.cross3(between, normal);
        let arm = self.combine(inverse, foot, rise, normal);

        for (position, &(symbol, component)) in coordinates.iter().enumerate() {
            let graph = &mut self.algebra.graph;
            let offset = graph.div(arm[component], scale);
            let value = graph.add(base.centre[component], offset);
            let value = self.guarded(value, h);
            self.define_length(symbol, value, position);
        }
        let place = Place { arm, scale, h };
        self.push_point(&coordinates, planes, &balls, &place, volume);

        let graph = &mut self.algebra.graph;
        let share = graph.div(h, radius);
        let mut margin = graph.mul(share, sine);
        for level in &levels {
            margin = self.algebra.graph.div(margin, level.largest);
        }
        let graph = &mut self.algebra.graph;
        let distance = graph.sqrt(distance2);
        let distance = graph.div(distance, scale);
        let miss = graph.sub(distance, base.radius);
        let gap = self.gap(q, noise, miss);
        let gap = self.defined_gap(gap, sine2);
        let (words, method) = words(spheres.len());
        Closed {
            kind: words.into(),
            class: 0,
            order: 0,
            method,
            two_modes: true,
            margin,
            slack: self.algebra.graph.div(q, radius2),
            slack_scale: self.algebra.graph.one(),
            gap,
            gap_in: GapIn::Unknown,
        }
    }

    /// What the line's distance from the first centre consists of, times `|n|`; lengths as sums of components.
    fn lengths_of(&mut self, first: &Level, second: &Level) -> NodeId {
        let [u, v] = [first, second].map(|level| {
            let [x, y, z] = level.normal.map(|x| self.abs(x));
            let graph = &mut self.algebra.graph;
            let sum = graph.add(x, y);
            graph.add(sum, z)
        });
        let graph = &mut self.algebra.graph;
        let forth = graph.mul(first.size, v);
        let back = graph.mul(second.size, u);
        graph.add(forth, back)
    }

    /// The spheres, and the power of two by which lengths are scaled.
    fn balls(&mut self, spheres: &[Sphere]) -> (NodeId, Vec<Ball>) {
        let own: Vec<(Space, NodeId)> = spheres
            .iter()
            .map(|sphere| {
                let graph = &mut self.algebra.graph;
                let centre = sphere.known.map(|x| {
                    let quotient = graph.div(x, sphere.factor);
                    graph.neg(quotient)
                });
                let stretch = graph.abs(sphere.factor);
                (centre, graph.div(sphere.radius, stretch))
            })
            .collect();
        let graph = &mut self.algebra.graph;
        let (_, first) = own[0];
        let sum = own[1..]
            .iter()
            .fold(first, |sum, (_, r)| graph.add(sum, *r));
        let scale = graph.unary(Unary::InverseScale, sum);
        let (base, _) = own[0];
        let balls = own.into_iter().map(|(centre, radius)| {
            let apart = [0, 1, 2].map(|k| {
                let apart = graph.sub(centre[k], base[k]);
                graph.mul(scale, apart)
            });
            Ball {
                centre,
                radius,
                scaled: graph.mul(scale, radius),
                apart,
            }
        });
        let balls = balls.collect();
        (scale, balls)
    }

    /// The plane of the circle in which two spheres meet: `a . y = (a.a + (r0 - r)(r0 + r))/2` for the distance `a` of the centres.
    fn radical_plane(&mut self, base: &Ball, ball: &Ball) -> Level {
        let square = self.algebra.dot(&ball.apart, &ball.apart);
        let imbalance = self.difference_of_squares(base.scaled, ball.scaled);
        let sum = self.algebra.graph.add(square, imbalance);
        let offset = self.half(sum);
        let imbalance = self.abs(imbalance);
        Level {
            normal: ball.apart,
            offset,
            size: self.algebra.graph.add(square, imbalance),
            largest: ball.scaled,
        }
    }

    fn level(&mut self, base: &Ball, plane: &Plane, scale: NodeId) -> Level {
        let (length, normal) = self.algebra.length_and_unit(plane.normal);
        let offset = self.algebra.graph.div(plane.offset, length);
        let here = self.algebra.dot(&normal, &base.centre);
        let sum = self.algebra.graph.add(offset, here);
        let sizes = [offset, here].map(|x| self.abs(x));
        let graph = &mut self.algebra.graph;
        let offset = graph.neg(sum);
        let size = graph.add(sizes[0], sizes[1]);
        let [offset, size] = [offset, size].map(|x| graph.mul(scale, x));
        Level {
            normal,
            offset,
            size,
            largest: graph.one(),
        }
    }
}

fn words(spheres: usize) -> (&'static str, &'static str) {
    match spheres {
        1 => (
            "one distance, two planes",
            "intersection of a sphere and a line",
        ),
        2 => (
            "two distances, one plane",
            "intersection of a sphere and two planes",
        ),
        _ => (
            "three distances",
            "trilateration, root along the normal of the centres",
        ),
    }
}

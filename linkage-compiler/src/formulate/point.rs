//! A point at given distances from known points and on known planes, a direction at given angles to known directions.

mod differentiate;

use linkage_symbolic::{NodeId, SymbolId};

use crate::structure::{Plane, Sphere};

use super::space::Space;
use super::{Closed, GapIn, Solver};

/// A sphere `|f (p - centre)| = radius`, with its own numbers.
struct Ball {
    centre: Space,
    /// As a distance from the centre.
    radius: NodeId,
}

/// A plane `normal . (p - centre of the first sphere) = offset`, its normal of length 1.
struct Level {
    normal: Space,
    offset: NodeId,
    /// What the offset's rounding is measured by.
    size: NodeId,
    /// The normal's length before.
    length: NodeId,
}

impl Solver<'_, '_> {
    /// The difference of two spheres is a plane, so there are two planes and a sphere: the foot `(a (v x n) + b (n x u))/n.n` on both
    /// planes, `n = u x v`, and from there `h = sqrt((r - f)(r + f))` along `n`. Squares are taken of lengths only.
    pub(super) fn point(
        &mut self,
        coordinates: &[(SymbolId, usize)],
        spheres: &[Sphere],
        planes: &[Plane],
    ) -> Closed {
        let mut coordinates = coordinates.to_vec();
        coordinates.sort_by_key(|(_, component)| *component);
        let missing = (0..3).find(|k| coordinates.iter().all(|(_, component)| component != k));

        let balls: Vec<Ball> = spheres.iter().map(|sphere| self.ball(sphere)).collect();
        let base = &balls[0];
        let mut levels = Vec::new();
        for ball in &balls[1..] {
            levels.push(self.radical_plane(base, ball));
        }
        for plane in planes {
            levels.push(self.level(base, plane));
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
            levels.push(self.level(base, &plane));
        }
        let [first, second] = &levels[..] else {
            unreachable!("three conditions: a sphere and two planes");
        };

        let w = self.mode_sign();
        let normal = self.algebra.cross3(first.normal, second.normal);
        let sine2 = self.algebra.dot(&normal, &normal);
        let sine = self.algebra.length(&normal);
        let arms = [
            self.algebra.cross3(second.normal, normal),
            self.algebra.cross3(normal, first.normal),
        ];
        let shares = [first.offset, second.offset].map(|x| self.algebra.graph.div(x, sine2));
        let foot = self.combine_space(shares[0], arms[0], shares[1], arms[1]);
        let distance = self.algebra.length(&foot);
        let radius = base.radius;
        let q = self.difference_of_squares(radius, distance);
        let graph = &mut self.algebra.graph;
        let sizes = graph.add(first.size, second.size);
        let sizes = graph.div(sizes, sine);
        let far = graph.mul(radius, sizes);
        let near = graph.square(radius);
        let noise = graph.add(far, near);
        let h = self.root(q, noise);
        let graph = &mut self.algebra.graph;
        let hw = graph.mul(w, h);
        let rise = graph.div(hw, sine);
        let one = graph.one();
        let arm = self.combine_space(one, foot, rise, normal);

        for (position, &(symbol, component)) in coordinates.iter().enumerate() {
            let value = self
                .algebra
                .graph
                .add(base.centre[component], arm[component]);
            let value = self.guarded(value, h);
            self.define_length(symbol, value, position);
        }
        let scales = self.push_point(&coordinates, planes, &balls, arm, h);

        // The determinant is that of the first sphere's arm and the planes' normals; each length meets its scale at once, so
        // that nothing overflows.
        let (others, planes_and_axes) = levels.split_at(balls.len() - 1);
        let graph = &mut self.algebra.graph;
        let own = graph.mul(scales[0], hw);
        let mut determinant = graph.mul(own, sine);
        let share = graph.div(h, radius);
        let mut margin = graph.mul(share, sine);
        for ((level, ball), &scale) in others.iter().zip(&balls[1..]).zip(&scales[1..]) {
            let graph = &mut self.algebra.graph;
            let scaled = graph.mul(scale, level.length);
            determinant = graph.mul(scaled, determinant);
            let share = graph.div(level.length, ball.radius);
            margin = graph.mul(share, margin);
        }
        for (level, &scale) in planes_and_axes.iter().zip(&scales[balls.len()..]) {
            let graph = &mut self.algebra.graph;
            let scaled = graph.mul(scale, level.length);
            determinant = graph.mul(scaled, determinant);
        }
        if missing == Some(1) {
            determinant = self.algebra.graph.neg(determinant);
        }
        self.set_determinant(determinant);

        let graph = &mut self.algebra.graph;
        let miss = graph.sub(distance, radius);
        let gap = self.gap(q, noise, miss);
        let gap = self.defined_gap(gap, sine2);
        let graph = &mut self.algebra.graph;
        let radius2 = graph.square(radius);
        let (words, method) = words(spheres.len());
        Closed {
            kind: words.into(),
            class: 0,
            order: 0,
            method,
            two_modes: true,
            margin,
            slack: graph.div(q, radius2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Unknown,
        }
    }

    fn ball(&mut self, sphere: &Sphere) -> Ball {
        let graph = &mut self.algebra.graph;
        let centre = sphere.known.map(|x| {
            let quotient = graph.div(x, sphere.factor);
            graph.neg(quotient)
        });
        let stretch = graph.abs(sphere.factor);
        Ball {
            centre,
            radius: graph.div(sphere.radius, stretch),
        }
    }

    /// From one centre to the other.
    fn apart(&mut self, base: &Ball, ball: &Ball) -> Space {
        [0, 1, 2].map(|k| self.algebra.graph.sub(ball.centre[k], base.centre[k]))
    }

    /// The plane of the circle in which two spheres meet: `a . y = (a.a + (r0 - r)(r0 + r))/2` for the distance `a` of the centres.
    fn radical_plane(&mut self, base: &Ball, ball: &Ball) -> Level {
        let apart = self.apart(base, ball);
        let square = self.algebra.dot(&apart, &apart);
        let imbalance = self.difference_of_squares(base.radius, ball.radius);
        let sum = self.algebra.graph.add(square, imbalance);
        let sum = self.half(sum);
        let (length, normal) = self.algebra.length_and_unit(apart);
        let offset = self.algebra.graph.div(sum, length);
        let imbalance = self.abs(imbalance);
        let graph = &mut self.algebra.graph;
        let size = graph.add(square, imbalance);
        Level {
            normal,
            offset,
            size: graph.div(size, length),
            length,
        }
    }

    fn level(&mut self, base: &Ball, plane: &Plane) -> Level {
        let (length, normal) = self.algebra.length_and_unit(plane.normal);
        let offset = self.algebra.graph.div(plane.offset, length);
        let here = self.algebra.dot(&normal, &base.centre);
        let sum = self.algebra.graph.add(offset, here);
        let sizes = [offset, here].map(|x| self.abs(x));
        let graph = &mut self.algebra.graph;
        Level {
            normal,
            offset: graph.neg(sum),
            size: graph.add(sizes[0], sizes[1]),
            length,
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

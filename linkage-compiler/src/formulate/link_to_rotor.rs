//! RSSR: a link with ball joints between a known point and a point that turns about an axis in space.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::Binary;

use crate::algebra::{Solution, Term};

use super::circles::Squares;
use super::space::Space;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `|K + A cos + B sin| = l`, `A` and `B` perpendicular and of length `r`.
    ///
    /// In the rocker's frame `K = (x, y, z)`, z along its axis. The link spans `z` along the axis; seen along it there remain two
    /// links of lengths `r` and `sqrt(l^2 - z^2)` in the plane of the circle, solved as RRR, which needs the second one's square only.
    /// So parallel axes give the planar mechanism, and needle triangles stay accurate. The link's vector is put together
    /// from both parts, never `K + A cos + B sin`. Derivatives are taken in fixed coordinates, where they have the velocity of
    /// the rocker's point in common with what users ask for.
    pub(super) fn link_to_rotor(
        &mut self,
        angle: usize,
        [cosine, sine]: [Space; 2],
        known: Space,
        l: NodeId,
    ) -> Closed {
        let (r, along) = self.algebra.length_and_unit(cosine);
        let beside = sine.map(|x| self.algebra.graph.div(x, r));
        let axis = self.algebra.cross3(along, beside);
        let [x, y, z] = [along, beside, axis].map(|e| self.projection(e, known));
        let seen = self.negative([x, y]);
        let squares = self.shadow(r, l, z);
        let circles = self.circles(seen, &squares);
        let h = circles.h;

        let [turned, shadow_vector] = circles.vectors;
        let unit = turned.map(|x| {
            let component = self.algebra.graph.div(x, r);
            self.guarded(component, h)
        });
        self.define_angle(angle, 1.0, unit, 0);
        let symbols = self.algebra.angles[angle].clone();
        let (cos, sin) = (symbols.cos_node, symbols.sin_node);
        let back = self.negative(shadow_vector);
        let turned = [0, 1, 2].map(|k| {
            let graph = &mut self.algebra.graph;
            let parts = [graph.mul(cosine[k], cos), graph.mul(sine[k], sin)];
            graph.add(parts[0], parts[1])
        });
        let link = [0, 1, 2].map(|k| {
            let parts = [(back[0], along), (back[1], beside), (z, axis)];
            let zero = self.algebra.graph.zero();
            let value = parts.into_iter().fold(zero, |sum, (factor, direction)| {
                let part = self.algebra.graph.mul(factor, direction[k]);
                self.algebra.graph.add(sum, part)
            });
            let value = self.guarded(value, h);
            let equal = self.algebra.graph.add(known[k], turned[k]);
            self.alias("coupler", value, equal)
        });
        let slope = [0, 1, 2].map(|k| {
            let graph = &mut self.algebra.graph;
            let (forth, back) = (graph.mul(sine[k], cos), graph.mul(cosine[k], sin));
            graph.sub(forth, back)
        });
        let slope = self.algebra.dot(&link, &slope);
        let determinant = self.algebra.graph.neg(circles.product);
        let determinant = self.alias("det", determinant, slope);
        let mut terms = self.distance_terms(link, known, l);
        for (vector, factor) in [(cosine, cos), (sine, sin)] {
            terms.extend((0..3).map(|k| Term {
                coefficient: vec![vector[k]],
                factor: self.algebra.graph.mul(link[k], factor),
            }));
        }
        self.push_solution(Solution {
            terms,
            jacobian: vec![vec![determinant]],
            determinant,
            elimination: None,
        });

        let distance = self.algebra.length(&seen);
        let graph = &mut self.algebra.graph;
        let (far, near) = (graph.add(distance, r), graph.sub(distance, r));
        let farthest = self.algebra.length(&[far, z]);
        let nearest = self.algebra.length(&[near, z]);
        let graph = &mut self.algebra.graph;
        let (short, long) = (graph.sub(nearest, l), graph.sub(l, farthest));
        let miss = graph.binary(Binary::Max, short, long);
        let gap = self.gap(circles.q, circles.noise, miss);
        let gap = self.defined_gap(gap, circles.m);
        let graph = &mut self.algebra.graph;
        let [r_scaled, l_scaled] = [r, l].map(|x| graph.mul(squares.scale, x));
        let largest = graph.mul(r_scaled, l_scaled);
        let largest2 = graph.square(largest);
        Closed {
            kind: "SSR".into(),
            class: 0,
            order: 0,
            method: "intersection of two circles in the rocker's plane",
            two_modes: true,
            margin: graph.div(h, largest),
            slack: graph.div(circles.q, largest2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Link,
        }
    }

    /// The circles of radii `r` and `sqrt(l^2 - z^2)`.
    fn shadow(&mut self, r: NodeId, l: NodeId, z: NodeId) -> Squares {
        let reach = self.algebra.graph.add(r, l);
        let (mut squares, [r_scaled, l_scaled]) = self.squares([r, l], reach);
        if self.algebra.graph.is_zero(z) {
            return squares;
        }
        let graph = &mut self.algebra.graph;
        let z2 = graph.square(z);
        let half = graph.mul(squares.half_scale2, z2);
        squares.imbalance = graph.add(squares.imbalance, half);
        let four = graph.constant(4.0);
        let z2 = graph.mul(four, half);
        let [r2, l2] = [r_scaled, l_scaled].map(|x| {
            let two = graph.constant(2.0);
            let square = graph.square(x);
            graph.mul(two, square)
        });
        let seen2 = graph.sub(l2, z2);
        squares.twice = graph.binary(Binary::Min, r2, seen2);
        let reach_scaled = graph.add(r_scaled, l_scaled);
        squares.noise2 = Some(graph.mul(l_scaled, reach_scaled));
        squares
    }
}

//! RSSR: a link with ball joints between a known point and a point that turns about an axis in space.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::{Binary, Ternary};

use crate::algebra::{Solution, Term};

use super::space::Space;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `|K + A cos + B sin| = l`, `A` and `B` perpendicular and of length `r`.
    ///
    /// Along the axis the link spans `z = K.(A x B)/r^2`; seen along it there remain two links of lengths `r` and `sqrt((l - z)(l + z))`
    /// in the plane of the circle, solved as RRR. So parallel axes give the planar mechanism to the last digit, and needle
    /// triangles stay accurate. The link's vector is put together from both parts, never `K + A cos + B sin`.
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
        let [x, y, z] = [along, beside, axis].map(|e| self.algebra.dot(&e, &known));
        let seen = self.negative([x, y]);
        let reach = self.algebra.graph.add(r, l);
        let shadow2 = self.difference_of_squares(l, z);
        let shadow = match self.algebra.graph.is_zero(z) {
            true => l,
            false => {
                let size = self.algebra.graph.mul(l, reach);
                self.root(shadow2, size)
            }
        };
        let circles = self.circles(seen, [r, shadow], reach);
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
        let link = [0, 1, 2].map(|k| {
            let parts = [(back[0], along), (back[1], beside), (z, axis)];
            let zero = self.algebra.graph.zero();
            let value = parts.into_iter().fold(zero, |sum, (factor, direction)| {
                let part = self.algebra.graph.mul(factor, direction[k]);
                self.algebra.graph.add(sum, part)
            });
            let value = self.guarded(value, h);
            let graph = &mut self.algebra.graph;
            let terms = [graph.mul(cosine[k], cos), graph.mul(sine[k], sin)];
            let sum = graph.add(terms[0], terms[1]);
            let equal = graph.add(known[k], sum);
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

        // Beyond the link's length along the axis there is nothing to see of it.
        let graph = &mut self.algebra.graph;
        let q = graph.ternary(Ternary::Select, shadow2, circles.q, shadow2);
        let noise = graph.ternary(Ternary::Select, shadow2, circles.noise, shadow2);
        let distance = self.algebra.length(&seen);
        let graph = &mut self.algebra.graph;
        let (far, near) = (graph.add(distance, r), graph.sub(distance, r));
        let farthest = self.algebra.length(&[far, z]);
        let nearest = self.algebra.length(&[near, z]);
        let graph = &mut self.algebra.graph;
        let (short, long) = (graph.sub(nearest, l), graph.sub(l, farthest));
        let miss = graph.binary(Binary::Max, short, long);
        let gap = self.gap(q, noise, miss);
        let gap = self.defined_gap(gap, circles.m);
        let graph = &mut self.algebra.graph;
        let scaled = graph.mul(circles.scale, l);
        let largest = graph.mul(circles.radii[0], scaled);
        let largest2 = graph.square(largest);
        Closed {
            kind: "SSR".into(),
            class: 0,
            order: 0,
            method: "intersection of two circles in the rocker's plane",
            two_modes: true,
            margin: graph.div(h, largest),
            slack: graph.div(q, largest2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Link,
        }
    }
}

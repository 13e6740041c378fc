//! RRR: two links of given lengths between two known points.

use linkage_symbolic::program::{Binary, Unary};

use crate::structure::Rotor;

use super::vector::Vector;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `Z1 u1 + Z2 u2 = C` by the intersection of two circles.
    ///
    /// With `L2 = C.C` the links' vectors are `(n1 C + w h C_perp)/L2` and `(n2 C - w h C_perp)/L2`, where
    /// `n1,2 = (L2 +- (r1 - r2)(r1 + r2))/2`. The root `h = sqrt(r^2 L2 - n^2)` is taken for the smaller circle, which
    /// keeps it accurate in needle triangles; `|r1^2 - r2^2|` selects that one without a choice. All squares
    /// are scaled by a power of two near the links' lengths, so that extreme units neither overflow nor underflow.
    pub(super) fn two_rotors(&mut self, first: &Rotor, second: &Rotor, known: Vector) -> Closed {
        let c = self.negative(known);
        let [r1, r2] = [first.z, second.z].map(|z| self.algebra.length(&z));
        let w = self.mode_sign();
        let graph = &mut self.algebra.graph;

        let reach = graph.add(r1, r2);
        let scale = graph.unary(Unary::InverseScale, reach);
        let [r1s, r2s] = [graph.mul(scale, r1), graph.mul(scale, r2)];
        let smaller = graph.binary(Binary::Min, r1s, r2s);
        let scale2 = graph.square(scale);
        let half_scale2 = self.half(scale2);
        let imbalance = self.difference_of_squares(r1s, r2s);
        let imbalance = self.half(imbalance);
        let size = self.abs(imbalance);

        let distance2 = self.square(c);
        let graph = &mut self.algebra.graph;
        let m = graph.mul(half_scale2, distance2);
        let n1 = graph.add(m, imbalance);
        let n2 = graph.sub(m, imbalance);
        let n = graph.sub(m, size);
        let reach2 = graph.square(smaller);
        let two = graph.constant(2.0);
        let twice = graph.mul(two, reach2);
        let t = graph.mul(twice, m);
        let n_squared = graph.square(n);
        let q = graph.sub(t, n_squared);
        let noise = graph.add(m, size);
        let noise = graph.mul(noise, n);
        let h = self.root(q, noise);

        let graph = &mut self.algebra.graph;
        let half = graph.constant(0.5);
        let inverse = graph.div(half, m);
        let [a1, a2, signed] = [n1, n2, w].map(|x| graph.mul(x, inverse));
        // The root comes last: what does not need it is ready by then.
        let b = graph.mul(signed, h);
        let minus_b = graph.neg(b);
        let across = self.perp(c);
        let vectors = [
            self.combine(a1, c, b, across),
            self.combine(a2, c, minus_b, across),
        ];

        let graph = &mut self.algebra.graph;
        let signed = graph.neg(w);
        let unscaled = graph.div(signed, scale2);
        let determinant = graph.mul(unscaled, h);

        let mut terms = Vec::new();
        let mut columns = Vec::new();
        for (position, (rotor, value)) in [first, second].into_iter().zip(vectors).enumerate() {
            let unit = self.unit_of(rotor);
            let vector = value.map(|x| self.guarded(x, h));
            let vector = self.turning(vector, rotor.z, unit, position);
            let quotient = self.complex_quotient(vector, rotor.z);
            self.define_angle(rotor.angle, rotor.sense, quotient, position);
            terms.extend(self.rotor_terms(rotor.z, unit));
            columns.push(self.perp(vector));
        }
        terms.push(self.known_term(&known));
        self.push_pair(terms, [columns[0], columns[1]], determinant);

        let distance = self.algebra.length(&c);
        let graph = &mut self.algebra.graph;
        let too_far = graph.sub(distance, reach);
        let difference = graph.sub(r1, r2);
        let difference = graph.abs(difference);
        let too_near = graph.sub(difference, distance);
        let miss = graph.binary(Binary::Max, too_far, too_near);
        let gap = self.gap(q, noise, miss);
        let gap = self.defined_gap(gap, m);
        let graph = &mut self.algebra.graph;
        let largest = graph.mul(r1s, r2s);
        let margin = graph.div(h, largest);
        let largest2 = graph.square(largest);
        Closed {
            kind: "RRR".into(),
            class: 2,
            order: 2,
            method: "intersection of two circles, root taken for the smaller one",
            two_modes: true,
            margin,
            slack: graph.div(q, largest2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Loop,
        }
    }
}

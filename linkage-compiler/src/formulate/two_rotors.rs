//! RRR: two links of given lengths between two known points.

use linkage_symbolic::program::Binary;

use crate::structure::Rotor;

use super::vector::Vector;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `Z1 u1 + Z2 u2 = C` by the intersection of two circles.
    pub(super) fn two_rotors(&mut self, first: &Rotor, second: &Rotor, known: Vector) -> Closed {
        let c = self.negative(known);
        let [r1, r2] = [first.z, second.z].map(|z| self.algebra.length(&z));
        let reach = self.algebra.graph.add(r1, r2);
        let (squares, radii) = self.squares([r1, r2], reach);
        let circles = self.circles(c, &squares);
        let h = circles.h;

        let mut terms = Vec::new();
        let mut columns = Vec::new();
        let links = [first, second].into_iter().zip(circles.vectors);
        for (position, (rotor, value)) in links.enumerate() {
            let unit = self.unit_of(rotor);
            let vector = value.map(|x| self.guarded(x, h));
            let vector = self.turning(vector, rotor.z, unit, position);
            let quotient = self.complex_quotient(vector, rotor.z);
            self.define_angle(rotor.angle, rotor.sense, quotient, position);
            terms.extend(self.rotor_terms(rotor.z, unit));
            columns.push(self.perp(vector));
        }
        terms.push(self.known_term(&known));
        self.push_pair(terms, [columns[0], columns[1]], circles.product);

        let distance = self.algebra.length(&c);
        let graph = &mut self.algebra.graph;
        let too_far = graph.sub(distance, reach);
        let difference = graph.sub(r1, r2);
        let difference = graph.abs(difference);
        let too_near = graph.sub(difference, distance);
        let miss = graph.binary(Binary::Max, too_far, too_near);
        let gap = self.gap(circles.q, circles.noise, miss);
        let gap = self.defined_gap(gap, circles.m);
        let graph = &mut self.algebra.graph;
        let largest = graph.mul(radii[0], radii[1]);
        let margin = graph.div(h, largest);
        let largest2 = graph.square(largest);
        Closed {
            kind: "RRR".into(),
            class: 2,
            order: 2,
            method: "intersection of two circles, root taken for the smaller one",
            two_modes: true,
            margin,
            slack: graph.div(circles.q, largest2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Loop,
        }
    }
}

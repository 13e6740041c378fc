//! RPR: a slider on a line fixed in a turning link.

use linkage_symbolic::SymbolId;

use crate::structure::Rotor;

use super::vector::Vector;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `(Z + s W) u = C`: the line passes the link's pivot at the distance `b = W x Z / |W|`; from its foot the slider is at
    /// `w sqrt(C.C - b^2)`, and the line's direction is `C (s - i b) / C.C`.
    pub(super) fn slide_on_rotor(
        &mut self,
        rotor: &Rotor,
        slide: SymbolId,
        guide: Vector,
        known: Vector,
    ) -> Closed {
        let c = self.negative(known);
        let (stretch, direction) = self.algebra.length_and_unit(guide);
        let w = self.mode_sign();
        let offset = self.algebra.cross(direction, rotor.z);
        let foot = self.algebra.dot(&direction, &rotor.z);

        let distance2 = self.square(c);
        let graph = &mut self.algebra.graph;
        let offset2 = graph.square(offset);
        let q = graph.sub(distance2, offset2);
        let h = self.root(q, distance2);
        let graph = &mut self.algebra.graph;
        let from_foot = graph.mul(w, h);
        let position = graph.sub(from_foot, foot);
        let position = graph.div(position, stretch);
        let [along, across] = [from_foot, offset].map(|x| self.algebra.graph.div(x, distance2));
        let minus_across = self.algebra.graph.neg(across);
        let turned = self.perp(c);
        let value = self.combine(along, c, minus_across, turned);
        let graph = &mut self.algebra.graph;
        let determinant = graph.mul(stretch, from_foot);
        let determinant = graph.neg(determinant);

        let unit = self.unit_of(rotor);
        let line = value.map(|x| self.guarded(x, h));
        let line = self.turning(line, direction, unit, 0);
        let quotient = self.complex_quotient(line, direction);
        self.define_angle(rotor.angle, rotor.sense, quotient, 0);
        self.define_length(slide, position, 1);

        let slide_node = self.algebra.graph.symbol_node(slide);
        let carried = unit.map(|x| self.algebra.graph.mul(slide_node, x));
        let mut terms = self.rotor_terms(rotor.z, unit);
        terms.extend(self.rotor_terms(guide, carried));
        terms.push(self.known_term(&known));
        let moving = line.map(|x| self.algebra.graph.mul(stretch, x));
        self.push_pair(terms, [turned, moving], determinant);

        // The root of the same square as in `h`: the margin of a guide without offset is exactly 1.
        let distance = self.algebra.graph.sqrt(distance2);
        let offset = self.abs(offset);
        let miss = self.algebra.graph.sub(offset, distance);
        let gap = self.gap(q, distance2, miss);
        let graph = &mut self.algebra.graph;
        Closed {
            kind: "RPR".into(),
            class: 2,
            order: 2,
            method: "tangent from a point to the circle of the guide's offset",
            two_modes: true,
            margin: graph.div(h, distance),
            slack: q,
            slack_scale: distance2,
            gap,
            gap_in: GapIn::Loop,
        }
    }
}

//! RPR: a slider on a line fixed in a turning link.

use linkage_symbolic::{SymbolId, V2};

use crate::algebra::AngleReference;
use crate::structure::Rotor;

use super::plane::{gap, guarded, known_term, rotor_terms};
use super::{Closed, GapIn, Solver};

impl<'m> Solver<'_, 'm> {
    /// `(Z + s W) u = C`: the line passes the link's pivot at the distance `b = W x Z / |W|`; from its foot the slider is at
    /// `w sqrt(C.C - b^2)`, and the line's direction is `C (s - i b) / C.C`.
    pub(super) fn slide_on_rotor(
        &mut self,
        rotor: &Rotor<'m>,
        slide: SymbolId,
        guide: V2<'m>,
        known: V2<'m>,
    ) -> Closed<'m> {
        let c = -known;
        let (stretch, direction) = guide.length_and_unit();
        let w = self.mode_sign();
        let offset = direction.cross(rotor.z);
        let foot = direction.dot(rotor.z);

        let distance2 = c.square();
        let q = distance2 - offset.square();
        let h = q.root(distance2);
        let from_foot = w * h;
        let position = (from_foot - foot) / stretch;
        // The division stands beside the root.
        let towards = (1.0 / distance2) * c;
        let turned = c.perp();
        let value = from_foot * towards - offset * towards.perp();
        let determinant = -(stretch * from_foot);

        let unit = self.unit_of(rotor);
        let line = value.map(|x| guarded(x, h));
        let line = self.turning(line, direction, unit, 0);
        self.define_angle(rotor.angle, rotor.sense, line.turned_back(direction), 0);
        // The line leads towards the slider, or away from it.
        let bearing = AngleReference {
            vector: c,
            across: false,
            mode: w,
            opposite: false,
            z: Some(guide),
            sense: rotor.sense,
        };
        self.bear(rotor.angle, bearing);
        self.define_length(slide, position, 1);

        let carried = self.unknown(slide) * unit;
        let mut terms = rotor_terms(rotor.z, unit);
        terms.extend(rotor_terms(guide, carried));
        terms.push(known_term(&known.0));
        self.push_pair(terms, [turned, stretch * line], determinant);

        let distance = distance2.sqrt();
        let margin = self.root_margin(h, c, offset, self.algebra.one());
        let miss = offset.abs() - distance;
        Closed {
            kind: "RPR".into(),
            class: 2,
            order: 2,
            method: "tangent from a point to the circle of the guide's offset",
            two_modes: true,
            gap: gap(q, distance2, miss),
            margin,
            slack: q,
            slack_scale: distance2,
            gap_in: GapIn::Loop,
        }
    }
}

//! RRP and PRR: a link of given length between a known point and a slider on a known line.

use linkage_symbolic::{SymbolId, V2};

use crate::algebra::{Bearing, Term};
use crate::structure::Rotor;

use super::plane::{gap, guarded, known_term, rotor_terms, squarable};
use super::{Closed, GapIn, Solver};

impl<'m> Solver<'_, 'm> {
    /// `Z u + s G = C`: the distance of the point from the line is `X = g x C`, the link reaches `h = sqrt((r - X)(r + X))`
    /// along it. The link's vector is `w h g + X g_perp`, never the difference `C - s G`.
    pub(super) fn rotor_and_slide(
        &mut self,
        rotor: &Rotor<'m>,
        slide: SymbolId,
        guide: V2<'m>,
        known: V2<'m>,
    ) -> Closed<'m> {
        let c = -known;
        let r = squarable(rotor.z.length());
        let (stretch, g) = guide.length_and_unit();
        let w = self.mode_sign();

        let x = g.cross(c);
        let along = g.dot(c);
        let q = r.difference_of_squares(x);
        // Rounding in `X` is that of `|C|`, which near the dead point, where `|X| = r`, is less than this sum.
        let noise = r * along.abs() + r.square();
        let h = q.root(noise);
        let hw = w * h;
        let value = hw * g + x * g.perp();
        let position = (along - hw) / stretch;
        let determinant = -(stretch * hw);

        let unit = self.unit_of(rotor);
        let vector = value.map(|x| guarded(x, h));
        let vector = self.turning(vector, rotor.z, unit, 0);
        let turned = vector.turned_back(rotor.z);
        self.define_angle(rotor.angle, rotor.sense, turned, 0);
        // From the foot on the guide the link leans forward or backward.
        let bearing = Bearing {
            vector: guide,
            across: false,
            mode: w,
            opposite: false,
            z: Some(rotor.z),
            sense: rotor.sense,
        };
        self.bear(rotor.angle, bearing);
        self.define_length(slide, position, 1);

        let mut terms = rotor_terms(rotor.z, unit);
        terms.push(Term {
            coefficient: guide.0.to_vec(),
            factor: self.unknown(slide),
        });
        terms.push(known_term(&known.0));
        self.push_pair(terms, [vector.perp(), guide], determinant);

        let gap = gap(q, noise, x.abs() - r);
        Closed {
            kind: "RRP".into(),
            class: 2,
            order: 2,
            method: "intersection of a circle and a line, by the distance from the line",
            two_modes: true,
            margin: h / r,
            slack: q / r.square(),
            slack_scale: self.algebra.one(),
            gap,
            gap_in: GapIn::Loop,
        }
    }
}

//! RPR: a slider on a line fixed in a turning link.

use crate::solve::longest;
use crate::solve::plane;
use linkage_symbolic::{SymbolId, V2};

use crate::algebra::AngleReference;
use crate::structure::Rotor;

use super::plane::{gap, guarded, known_term, rotor_terms};
use super::{Closed, GapIn, Solver};

/// `(Z + s W) u = C`: the line passes the link's pivot at the distance `b = W x Z / |W|`; from its foot the slider is at
/// `w sqrt(C.C - b^2)`, and the line's direction is `C (s - i b) / C.C`.
pub(super) fn slide_on_rotor<'m>(
    solver: &mut Solver<'_, 'm>,
    rotor: &Rotor<'m>,
    slide: SymbolId,
    guide: V2<'m>,
    known: V2<'m>,
) -> Closed<'m> {
    let c = -known;
    let (stretch, direction) = guide.length_and_unit();
    let w = solver.mode_sign();
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

    let unit = solver.unit_of(rotor);
    let line = value.map(|x| guarded(x, h));
    let line = solver.turning(line, direction, unit, 0);
    solver.define_angle(rotor.angle, rotor.sense, line.turned_back(direction), 0);
    // The line leads towards the slider, or away from it.
    let bearing = AngleReference {
        vector: c,
        across: false,
        mode: w,
        opposite: false,
        z: Some(guide),
        sense: rotor.sense,
    };
    solver.bear(rotor.angle, bearing);
    solver.define_length(slide, position, 1);

    let carried = solver.unknown(slide) * unit;
    let mut terms = rotor_terms(rotor.z, unit);
    terms.extend(rotor_terms(guide, carried));
    terms.push(known_term(&known.0));
    plane::push_pair(solver, terms, [turned, stretch * line], determinant);

    let distance = distance2.sqrt();
    let margin = longest::root_margin(solver, h, c, offset, solver.algebra.one());
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

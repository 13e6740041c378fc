//! RPR: a slider on a line fixed in a turning link.

use linkage_symbolic::{SymbolId, V2};

use crate::algebra::{Algebra, AngleReference};
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::group_context::GroupContext;
use crate::solve::{definitions, longest, plane, unknowns};
use crate::structure::Rotor;

use super::plane::{gap, guarded, known_term, rotor_terms};

/// `(Z + s W) u = C`: the line passes the link's pivot at the distance `b = W x Z / |W|`; from its
/// foot the slider is at `w sqrt(C.C - b^2)`, and the line's direction is `C (s - i b) / C.C`.
pub(super) fn rpr<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    rotor: &Rotor<'m>,
    slide: SymbolId,
    guide: V2<'m>,
    known: V2<'m>,
) -> ClosedForm<'m> {
    let c = -known;
    let (stretch, direction) = guide.length_and_unit();
    let w = definitions::mode_sign(algebra, group);
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

    let unit = unknowns::unit_of(algebra, rotor);
    let line = value.map(|x| guarded(x, h));
    let line = definitions::turning(algebra, group, line, direction, unit, 0);
    definitions::define_angle(
        algebra,
        group,
        rotor.angle,
        rotor.sense,
        line.turned_back(direction),
        0,
    );
    // The line leads towards the slider, or away from it.
    let bearing = AngleReference {
        vector: c,
        across: false,
        mode: w,
        opposite: false,
        z: Some(guide),
        sense: rotor.sense,
    };
    definitions::bear(algebra, rotor.angle, bearing);
    definitions::define_length(algebra, group, slide, position, 1);

    let carried = unknowns::unknown(algebra, slide) * unit;
    let mut terms = rotor_terms(rotor.z, unit);
    terms.extend(rotor_terms(guide, carried));
    terms.push(known_term(&known.0));
    plane::push_pair(algebra, group, terms, [turned, stretch * line], determinant);

    let distance = distance2.sqrt();
    let margin = longest::root_margin(algebra, group, h, c, offset, algebra.one());
    let miss = offset.abs() - distance;
    ClosedForm {
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

//! RRP and PRR: a link of given length between a known point and a slider on a known line.

use linkage_symbolic::{SymbolId, V2, Vector};

use crate::algebra::{Algebra, AngleReference, Term, ViaSlider, rotating_frame};
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::group_context::GroupContext;
use crate::solve::{definitions, plane, unknowns};
use crate::structure::Rotor;

use super::plane::{gap, guarded, known_term, rotor_terms, squarable};

/// `Z u + s G = C`: the distance of the point from the line is `X = g x C`, the link reaches
/// `h = sqrt((r - X)(r + X))` along it. The link's vector is `w h g + X g_perp`, never the
/// difference `C - s G`.
pub(super) fn rrp<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    rotor: &Rotor<'m>,
    slide: SymbolId,
    guide: V2<'m>,
    known: V2<'m>,
) -> ClosedForm<'m> {
    let c = -known;
    let r = squarable(rotor.z.length());
    let (stretch, g) = guide.length_and_unit();
    let w = definitions::mode_sign(algebra, group);

    let carried =
        rotating_frame::in_rotating_frame(&algebra.names, &mut algebra.solutions, guide, g, c);
    // What the guide carries has a size of its own.
    let (from_guide, size) = match &carried {
        Some(carried) => (
            carried.arm
                + rotating_frame::to_frame(
                    algebra.graph,
                    &mut algebra.solutions,
                    carried.link_frame,
                    carried.rest,
                ),
            r + carried.arm.length(),
        ),
        None => (Vector([g.dot(c), g.cross(c)]), r),
    };
    let [along, x] = from_guide.0;
    let q = r.difference_of_squares(x);
    // Rounding in `X` is that of `|C|`, which near the dead point, where `|X| = r`, is less than
    // this sum.
    let noise = r * (along.abs() + size);
    let h = q.root(noise);
    let hw = w * h;
    let position = (along - hw) / stretch;
    let determinant = -(stretch * hw);

    let unit = unknowns::unit_of(algebra, rotor);
    let link_frame = carried.as_ref().map(|carried| carried.link_frame);
    let equation = match link_frame {
        None => {
            let value = (hw * g + x * g.perp()).map(|x| guarded(x, h));
            let vector = definitions::turning(algebra, group, value, rotor.z, unit, 0);
            let turned = vector.turned_back(rotor.z);
            definitions::define_angle(algebra, group, rotor.angle, rotor.sense, turned, 0);
            Equation {
                vector,
                unit,
                guide,
                known,
            }
        }
        Some(_) => {
            let value = Vector([hw, x]);
            let unit =
                definitions::direction_from_carrier(algebra, group, value.turned_back(rotor.z), 0);
            let vector = definitions::turning(algebra, group, value, rotor.z, unit, 0);
            let turned = value.turned(g).map(|x| guarded(x, h)).turned_back(rotor.z);
            definitions::define_angle_from(
                algebra,
                group,
                link_frame,
                rotor.angle,
                rotor.sense,
                turned,
                0,
            );
            let guide = Vector([stretch, algebra.zero()]);
            Equation {
                vector,
                unit,
                guide,
                known: -from_guide,
            }
        }
    };
    // From the foot on the guide the link leans forward or backward.
    let bearing = AngleReference {
        vector: guide,
        across: false,
        mode: w,
        opposite: false,
        z: Some(rotor.z),
        sense: rotor.sense,
    };
    definitions::bear(algebra, rotor.angle, bearing);
    definitions::define_length(algebra, group, slide, position, 1);

    if let Some(carried) = carried {
        let other_side = ViaSlider {
            angle: rotor.angle,
            sense: rotor.sense,
            z: rotor.z,
            slide: stretch * unknowns::unknown(algebra, slide),
            known,
            link_frame: carried.link_frame,
            carried: carried.turns,
        };
        algebra.solutions.via_sliders.push(other_side);
    }

    let mut terms = rotor_terms(rotor.z, equation.unit);
    terms.push(Term {
        coefficient: equation.guide.0.to_vec(),
        factor: unknowns::unknown(algebra, slide),
    });
    terms.push(known_term(&equation.known.0));
    let columns = [equation.vector.perp(), equation.guide];
    plane::push_pair(algebra, group, terms, columns, determinant);
    let across = -(stretch * x);
    plane::links_turn(algebra, 0, rotor.z, equation.unit, equation.vector, across);

    let gap = gap(q, noise, x.abs() - r);
    ClosedForm {
        kind: "RRP".into(),
        class: 2,
        order: 2,
        method: "intersection of a circle and a line, by the distance from the line",
        two_modes: true,
        margin: h / r,
        slack: q / r.square(),
        slack_scale: algebra.one(),
        gap,
        gap_in: GapIn::Loop,
    }
}

/// The loop in the coordinates that it is differentiated in: fixed ones, or those of the link that
/// carries the guide.
struct Equation<'m> {
    vector: V2<'m>,
    unit: V2<'m>,
    guide: V2<'m>,
    known: V2<'m>,
}

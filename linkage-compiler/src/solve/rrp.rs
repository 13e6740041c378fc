//! RRP and PRR: a link of given length between a known point and a slider on a known line.

use crate::algebra::rotating_frame;
use crate::solve::plane;
use linkage_symbolic::{SymbolId, V2, Vector};

use crate::algebra::{AngleReference, Term, ViaSlider};
use crate::structure::Rotor;

use super::plane::{gap, guarded, known_term, rotor_terms, squarable};
use super::{Closed, GapIn, Solver};

/// `Z u + s G = C`: the distance of the point from the line is `X = g x C`, the link reaches `h = sqrt((r - X)(r + X))`
/// along it. The link's vector is `w h g + X g_perp`, never the difference `C - s G`.
pub(super) fn rotor_and_slide<'m>(
    solver: &mut Solver<'_, 'm>,
    rotor: &Rotor<'m>,
    slide: SymbolId,
    guide: V2<'m>,
    known: V2<'m>,
) -> Closed<'m> {
    let c = -known;
    let r = squarable(rotor.z.length());
    let (stretch, g) = guide.length_and_unit();
    let w = solver.mode_sign();

    let carried = rotating_frame::carried(solver.algebra, guide, g, c);
    // What the guide carries has a size of its own.
    let (from_guide, size) = match &carried {
        Some(own) => (
            own.arm + rotating_frame::seen(solver.algebra, own.carrier, own.rest),
            r + own.arm.length(),
        ),
        None => (Vector([g.dot(c), g.cross(c)]), r),
    };
    let [along, x] = from_guide.0;
    let q = r.difference_of_squares(x);
    // Rounding in `X` is that of `|C|`, which near the dead point, where `|X| = r`, is less than this sum.
    let noise = r * (along.abs() + size);
    let h = q.root(noise);
    let hw = w * h;
    let position = (along - hw) / stretch;
    let determinant = -(stretch * hw);

    let unit = solver.unit_of(rotor);
    let carrier = carried.as_ref().map(|own| own.carrier);
    let equation = match carrier {
        None => {
            let value = (hw * g + x * g.perp()).map(|x| guarded(x, h));
            let vector = solver.turning(value, rotor.z, unit, 0);
            let turned = vector.turned_back(rotor.z);
            solver.define_angle(rotor.angle, rotor.sense, turned, 0);
            Equation {
                vector,
                unit,
                guide,
                known,
            }
        }
        Some(_) => {
            let value = Vector([hw, x]);
            let unit = solver.direction_from_carrier(value.turned_back(rotor.z), 0);
            let vector = solver.turning(value, rotor.z, unit, 0);
            let turned = value.turned(g).map(|x| guarded(x, h)).turned_back(rotor.z);
            solver.define_angle_from(carrier, rotor.angle, rotor.sense, turned, 0);
            let guide = Vector([stretch, solver.algebra.zero()]);
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
    solver.bear(rotor.angle, bearing);
    solver.define_length(slide, position, 1);

    if let Some(own) = carried {
        let other_side = ViaSlider {
            angle: rotor.angle,
            sense: rotor.sense,
            z: rotor.z,
            slide: stretch * solver.unknown(slide),
            known,
            carrier: own.carrier,
            carried: own.turns,
        };
        solver.algebra.solutions.other_sides.push(other_side);
    }

    let mut terms = rotor_terms(rotor.z, equation.unit);
    terms.push(Term {
        coefficient: equation.guide.0.to_vec(),
        factor: solver.unknown(slide),
    });
    terms.push(known_term(&equation.known.0));
    let columns = [equation.vector.perp(), equation.guide];
    plane::push_pair(solver, terms, columns, determinant);
    let across = -(stretch * x);
    plane::links_turn(solver, 0, rotor.z, equation.unit, equation.vector, across);

    let gap = gap(q, noise, x.abs() - r);
    Closed {
        kind: "RRP".into(),
        class: 2,
        order: 2,
        method: "intersection of a circle and a line, by the distance from the line",
        two_modes: true,
        margin: h / r,
        slack: q / r.square(),
        slack_scale: solver.algebra.one(),
        gap,
        gap_in: GapIn::Loop,
    }
}

/// The loop in the coordinates that it is differentiated in: fixed ones, or those of the link that carries the guide.
struct Equation<'m> {
    vector: V2<'m>,
    unit: V2<'m>,
    guide: V2<'m>,
    known: V2<'m>,
}

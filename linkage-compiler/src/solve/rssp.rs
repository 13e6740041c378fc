//! RSSP: a link with ball joints between a known point and a slider on a line in space.

use crate::solve::plane;
use crate::solve::space;
use linkage_symbolic::{Ex, SymbolId, V3, Vector};

use crate::algebra::{Rod, Term};

use super::plane::{gap, guarded, squarable};
use super::space::{distance_terms, projection};
use super::{Closed, GapIn, Solver};

/// `|K + s G| = l`: the point is at distance `X = |g x K|` from the line, the link reaches `h = sqrt((l - X)(l + X))` along it. The
/// link's vector is `K - (g.K) g + w h g`, never `K + s G`.
pub(super) fn link_to_slide<'m>(
    solver: &mut Solver<'_, 'm>,
    slide: SymbolId,
    guide: V3<'m>,
    known: V3<'m>,
    l: Ex<'m>,
) -> Closed<'m> {
    let l = squarable(l);
    let w = solver.mode_sign();
    let (stretch, g) = guide.length_and_unit();
    let along = projection(g, known);
    let moment = g.cross(known);
    let x = moment.length();
    let q = l.difference_of_squares(x);
    let noise = l * (along.abs() + l.abs());
    let h = q.root(noise);
    let hw = w * h;
    solver.define_length(slide, (hw - along) / stretch, 0);

    // (g x K) x g is K without its part along the line.
    let across = moment.cross(g);
    let s = solver.unknown(slide);
    let link = Vector([0, 1, 2].map(|k| {
        let value = guarded(across[k] + hw * g[k], h);
        let equal = known[k] + guide[k] * s;
        solver.alias("rod", value, equal)
    }));
    let slope = link.dot(guide);
    let determinant = solver.alias("det", stretch * hw, slope);
    let mut terms = distance_terms(link, known, l);
    terms.extend((0..3).map(|k| Term {
        coefficient: vec![guide[k]],
        factor: link[k] * s,
    }));
    plane::push_single(solver, terms, determinant);
    space::rod(
        solver,
        Rod {
            vector: link,
            known,
            length: l,
            slope: guide,
            arms: [guide; 2],
            across: solver.algebra.zero(),
        },
    );

    Closed {
        kind: "SSP".into(),
        class: 0,
        order: 0,
        method: "intersection of a sphere and a line, by the distance from the line",
        two_modes: true,
        gap: gap(q, noise, x - l),
        margin: h / l,
        slack: q / l.square(),
        slack_scale: solver.algebra.one(),
        gap_in: GapIn::Link,
    }
}

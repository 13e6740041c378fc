//! PRP and RPP: two slides along known directions, a linear group.

use crate::solve::plane;
use linkage_symbolic::{Ex, SymbolId, V2, Vector};

use crate::algebra::Term;

use super::plane::{known_term, linear_gap, where_finite};
use super::{Closed, GapIn, Solver};

/// `s1 G1 + s2 G2 = C` by Cramer's rule.
pub(super) fn two_slides<'m>(
    solver: &mut Solver<'_, 'm>,
    slides: [SymbolId; 2],
    guides: [V2<'m>; 2],
    known: V2<'m>,
) -> Closed<'m> {
    let c = -known;
    let determinant = guides[0].cross(guides[1]);
    let numerators = [c.cross(guides[1]), guides[0].cross(c)];
    let mut terms = Vec::new();
    for position in 0..2 {
        let value = numerators[position] / determinant;
        solver.define_length(slides[position], value, position);
        terms.push(Term {
            coefficient: guides[position].0.to_vec(),
            factor: solver.unknown(slides[position]),
        });
    }
    terms.push(known_term(&known.0));
    plane::push_pair(solver, terms, guides, determinant);

    let slack = determinant / largest_determinant(guides);
    Closed {
        // Guides at a fixed angle to each other belong to one link: the slides are neighbours.
        kind: if determinant.is_fixed() { "RPP" } else { "PRP" }.into(),
        class: 2,
        order: 2,
        method: "intersection of two lines",
        two_modes: false,
        margin: slack.abs(),
        slack: where_finite(slack, &known.0),
        slack_scale: solver.algebra.one(),
        gap: where_finite(linear_gap(determinant), &known.0),
        gap_in: GapIn::Loop,
    }
}

/// The determinant's largest value: 1 for guides along directions, and for lines given by unit normals.
fn largest_determinant(guides: [V2; 2]) -> Ex {
    let rows = [0, 1].map(|k| Vector([guides[0][k], guides[1][k]]));
    let [along, across] = [guides, rows].map(|pair| {
        let [first, second] = pair.map(|v| v.length_and_unit().0);
        first * second
    });
    let one = along.number(1.0);
    match along == one || across == one {
        true => one,
        false => along.max(across),
    }
}

//! Three slides in space: a linear system.

use linkage_symbolic::{SymbolId, V3};

use crate::algebra::{CoreRow, Elimination, Solution, Term};

use super::plane::{known_term, linear_gap, where_finite};
use super::{Closed, GapIn, Solver};

/// `s1 G1 + s2 G2 + s3 G3 + K = 0` by triple products.
pub(super) fn three_slides<'m>(
    solver: &mut Solver<'_, 'm>,
    slides: [SymbolId; 3],
    guides: [V3<'m>; 3],
    known: V3<'m>,
) -> Closed<'m> {
    let one = solver.algebra.one();
    let [a, b, c] = guides;
    let product = b.cross(c);
    let determinant = a.dot(product);
    let crosses = [product, c.cross(a), a.cross(b)];
    for (position, (slide, cross)) in slides.into_iter().zip(crosses).enumerate() {
        let value = -(cross.dot(known) / determinant);
        solver.define_length(slide, value, position);
    }
    let mut terms: Vec<Term> = slides
        .into_iter()
        .zip(guides)
        .map(|(slide, guide)| Term {
            coefficient: guide.0.to_vec(),
            factor: solver.unknown(slide),
        })
        .collect();
    terms.push(known_term(&known.0));
    let rows = (0..3).map(|first| CoreRow {
        first,
        factors: vec![one],
    });
    let elimination = Elimination {
        rows: rows.collect(),
        matrix: (0..3).map(|row| guides.map(|g| g[row]).to_vec()).collect(),
        units: vec![one; 3],
        privates: Vec::new(),
        scheme: None,
    };
    solver.push_solution(Solution {
        terms,
        jacobian: guides.map(|guide| guide.0.to_vec()).to_vec(),
        determinant,
        elimination: Some(elimination),
        links: [None; 2],
        rod: None,
        rows: Vec::new(),
    });

    let largest = guides.into_iter().fold(one, |product, guide| {
        let (length, _) = guide.length_and_unit();
        product * length
    });
    let slack = determinant / largest;
    Closed {
        kind: "PPP".into(),
        class: 0,
        order: 0,
        method: "three linear equations",
        two_modes: false,
        margin: slack.abs(),
        slack: where_finite(slack, &known.0),
        slack_scale: one,
        gap: where_finite(linear_gap(determinant), &known.0),
        gap_in: GapIn::Loop,
    }
}

//! RRR: two links of given lengths between two known points.

use crate::solve::circles;
use crate::solve::plane;
use linkage_symbolic::V2;

use crate::algebra::AngleReference;
use crate::structure::Rotor;

use super::circles::Squares;
use super::plane::{defined_gap, gap, guarded, known_term, rotor_terms};
use super::{Closed, GapIn, Solver};

/// `Z1 u1 + Z2 u2 = C` by the intersection of two circles.
pub(super) fn two_rotors<'m>(
    solver: &mut Solver<'_, 'm>,
    first: &Rotor<'m>,
    second: &Rotor<'m>,
    known: V2<'m>,
) -> Closed<'m> {
    let c = -known;
    let [r1, r2] = [first.z, second.z].map(|z| z.length());
    let reach = r1 + r2;
    let squares = Squares::of([r1, r2], reach);
    let circles = circles::circles(solver, c, &squares);
    let h = circles.h;
    let mode = solver.mode_sign();

    let mut terms = Vec::new();
    let mut columns = Vec::new();
    let mut vectors = Vec::new();
    let links = [first, second].into_iter().zip(circles.vectors);
    for (position, (rotor, value)) in links.enumerate() {
        let unit = solver.unit_of(rotor);
        let vector = value.map(|x| guarded(x, h));
        let vector = solver.turning(vector, rotor.z, unit, position);
        let turned = vector.turned_back(rotor.z);
        solver.define_angle(rotor.angle, rotor.sense, turned, position);
        // The links lie on both sides of the line between their ends.
        let bearing = AngleReference {
            vector: c,
            across: true,
            mode,
            opposite: position == 1,
            z: Some(rotor.z),
            sense: rotor.sense,
        };
        solver.bear(rotor.angle, bearing);
        terms.extend(rotor_terms(rotor.z, unit));
        columns.push(vector.perp());
        vectors.push(vector);
    }
    terms.push(known_term(&known.0));
    plane::push_pair(solver, terms, [columns[0], columns[1]], circles.product);
    let [square1, square2] = [first, second].map(|rotor| rotor.z.square());
    let product = 0.5 * c.square() - 0.5 * (square1 + square2);
    let product = solver.alias("product", product, vectors[0].dot(vectors[1]));
    for (position, rotor) in [first, second].into_iter().enumerate() {
        plane::links_turn(
            solver,
            position,
            rotor.z,
            solver.unit_of(rotor),
            vectors[position],
            product,
        );
    }

    let distance = c.length();
    let too_far = distance - reach;
    let too_near = (r1 - r2).abs() - distance;
    let gap = gap(circles.q, circles.noise, too_far.max(too_near));
    let gap = defined_gap(gap, circles.m);
    let [r1, r2] = squares.radii;
    let largest = r1 * r2;
    Closed {
        kind: "RRR".into(),
        class: 2,
        order: 2,
        method: "intersection of two circles, root taken for the smaller one",
        two_modes: true,
        margin: h / largest,
        slack: circles.q / largest.square(),
        slack_scale: solver.algebra.one(),
        gap,
        gap_in: GapIn::Loop,
    }
}

//! Limits of `linkage-core` in exported C: it has those of core, whatever they are.

use linkage_c::{Real, sources};
use linkage_core::Scalar;
use linkage_core::certificate::{
    ALLOWED_CONTRACTION, COMFORTABLE_STRAY, FIRST_CORRECTION, MOST_STRAY, STEPS_BESIDE,
};
use linkage_core::range_check::{AT_END, DEAD, END, ROUNDING};
use std::f64::consts::PI;

use crate::coupled;
use linkage_corpus::given::{golden, turning};

/// Fails unless the text has all of these pieces.
fn has_all(text: &str, pieces: &[String]) {
    for piece in pieces {
        assert!(text.contains(piece), "`{piece}` is not in:\n{text}");
    }
}

#[test]
fn steps_of_coupled_groups_have_the_limits_of_core() {
    for given in coupled::all() {
        let contraction = ALLOWED_CONTRACTION * ALLOWED_CONTRACTION;
        let c = sources(&given.name, &given.unit, Real::Double).expect("it is printed");
        let limit = f64::CORRECTION_LIMIT;
        has_all(
            &c.source,
            &[
                format!("allowed = {FIRST_CORRECTION:?} * {FIRST_CORRECTION:?};"),
                format!("step < {STEPS_BESIDE}; step++"),
                format!("({contraction:?} * next["),
                format!("least = {limit:?} * {limit:?};"),
            ],
        );
        let c = sources(&given.name, &given.unit, Real::Single).expect("it is printed");
        let [first, contraction, limit] =
            [FIRST_CORRECTION, contraction, f32::CORRECTION_LIMIT].map(|x| x as f32);
        has_all(
            &c.source,
            &[
                format!("allowed = {first:?}f * {first:?}f;"),
                format!("({contraction:?}f * next["),
                format!("least = {limit:?}f * {limit:?}f;"),
            ],
        );
    }
}

#[test]
fn turns_and_ranges_have_the_limits_of_core() {
    for given in turning() {
        let c = sources(&given.name, &given.unit, Real::Double).expect("it is printed");
        let [comfort, stray] = [COMFORTABLE_STRAY * PI, MOST_STRAY * PI];
        has_all(
            &c.source,
            &[
                format!("if (mine < {comfort:?} && its < {comfort:?})"),
                format!("_width(best) < {stray:?};"),
            ],
        );
    }
    for given in golden() {
        if given.unit.checked().is_none() {
            continue;
        }
        let c = sources(&given.name, &given.unit, Real::Double).expect("it is printed");
        for (limit, piece) in [
            (ROUNDING, ".level >= -LIMIT"),
            (DEAD, ".level -= LIMIT;"),
            (END, " > LIMIT * ("),
            (AT_END, ") < LIMIT * ("),
        ] {
            has_all(&c.source, &[piece.replace("LIMIT", &format!("{limit:?}"))]);
        }
    }
}

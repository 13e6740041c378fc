//! Hostile sets: guides all but parallel, a crank and a pivot all but in one place, far inputs.

use super::{FORMS, LIMITS, PLAN, TWO_SLIDES, geometry};
use linkage_reference::{Depth, Random, compare, decade_cases, far_input_cases, wide_scale_cases};

fn parallel(random: &mut Random, angle: f64) -> Vec<f64> {
    geometry(random, 6.0, angle)
}

fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let opening = random.between(0.1, 3.0);
    let mut geometry = geometry(random, 6.0, opening);
    let (crank, phi) = (geometry[0], 30f64.to_radians());
    let near = |random: &mut Random, x: f64| x + ratio * random.length(6.0);
    geometry[1] = near(random, crank * phi.cos());
    geometry[2] = near(random, crank * phi.sin());
    geometry
}

#[test]
fn parallel_guides() {
    let cases = decade_cases(&TWO_SLIDES, parallel, 6, 131);
    let report = compare(&TWO_SLIDES, FORMS, &cases, Depth::Usual);
    report.check("guides to 1e-15 rad parallel", &LIMITS);
}

#[test]
fn coincident_pivots() {
    let cases = decade_cases(&TWO_SLIDES, near_pivots, 6, 132);
    let report = compare(&TWO_SLIDES, FORMS, &cases, Depth::Usual);
    report.check("coincident pivots", &LIMITS.any_proportions());
}

#[test]
fn far_inputs() {
    let cases = far_input_cases(&TWO_SLIDES, &PLAN, 60, 133);
    let report = compare(&TWO_SLIDES, FORMS, &cases, Depth::Usual);
    report.check("inputs to 1e6 rad", &LIMITS);
}

#[test]
fn extreme_scales_and_proportions() {
    let cases = wide_scale_cases(&TWO_SLIDES, &PLAN, 8, 134);
    let report = compare(&TWO_SLIDES, FORMS, &cases, Depth::Usual);
    report.check(
        "sizes 1e-140 to 1e140, ratios to 1e8",
        &LIMITS.any_proportions(),
    );
}

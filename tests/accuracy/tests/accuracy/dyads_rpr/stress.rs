//! Hostile sets: short offsets, coincident pivots, far inputs, both sides of the dead point.

use super::{FORMS, LIMITS, PLAN, SWINGING_BLOCK};
use linkage_reference::{
    Depth, Random, compare, decade_cases, edge, far_input_cases, wide_scale_cases,
};

/// Closed at the reference input; the slide counts from the foot of the offset.
fn closed(random: &mut Random, crank: f64, offset: f64, from_foot: f64) -> Vec<f64> {
    let beta = random.between(0.3, 2.8) * if random.chance(0.5) { 1.0 } else { -1.0 };
    let psi = random.angle();
    let s = from_foot - offset * beta.cos();
    let phi = 40f64.to_radians();
    let x = crank * phi.cos() - s * psi.cos() - offset * (psi + beta).cos();
    let y = crank * phi.sin() - s * psi.sin() - offset * (psi + beta).sin();
    vec![x, y, crank, offset, beta]
}

fn short_offset(random: &mut Random, ratio: f64) -> Vec<f64> {
    let [crank, from_foot] = [0; 2].map(|_| random.length(6.0));
    let offset = ratio * random.length(6.0);
    closed(random, crank, offset, from_foot.abs())
}

/// Offset and slide are short beside the crank, or all three of them beside nothing.
fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let crank = random.length(6.0) * if random.chance(0.5) { ratio } else { 1.0 };
    let [offset, from_foot] = [0; 2].map(|_| ratio * random.length(6.0));
    closed(random, crank, offset, from_foot.abs())
}

#[test]
fn short_offsets() {
    let cases = decade_cases(&SWINGING_BLOCK, short_offset, 6, 121);
    let report = compare(&SWINGING_BLOCK, FORMS, &cases, Depth::Usual);
    report.check("short offsets", &LIMITS.any_proportions());
}

#[test]
fn coincident_pivots() {
    let cases = decade_cases(&SWINGING_BLOCK, near_pivots, 8, 122);
    let report = compare(&SWINGING_BLOCK, FORMS, &cases, Depth::Usual);
    report.check("coincident pivots", &LIMITS.any_proportions());
}

#[test]
fn far_inputs() {
    let cases = far_input_cases(&SWINGING_BLOCK, &PLAN, 40, 123);
    let report = compare(&SWINGING_BLOCK, FORMS, &cases, Depth::Usual);
    report.check("inputs to 1e6 rad", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&SWINGING_BLOCK, FORMS, &PLAN, 5, 124).check("swinging block");
}

#[test]
fn extreme_scales_and_proportions() {
    let cases = wide_scale_cases(&SWINGING_BLOCK, &PLAN, 8, 125);
    let report = compare(&SWINGING_BLOCK, FORMS, &cases, Depth::Usual);
    report.check(
        "sizes 1e-140 to 1e140, ratios to 1e8",
        &LIMITS.any_proportions(),
    );
}

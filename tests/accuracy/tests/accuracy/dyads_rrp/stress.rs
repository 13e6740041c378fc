//! Hostile sets: short rods, rods along the guide, far inputs, both sides of the dead point.

use super::{FITTING, FIXED, FIXED_PLAN, LIMITS, SLIDER_CRANK};
use linkage_reference::{
    Depth, Random, compare, decade_cases, edge, far_input_cases, wide_scale_cases,
};

/// Closed at the reference input with the given angle between rod and guide.
fn closed(random: &mut Random, crank: f64, rod: f64, s: f64, bend: f64) -> Vec<f64> {
    let gamma = random.angle();
    let (theta, phi) = (gamma + bend, 30f64.to_radians());
    let x = crank * phi.cos() + rod * theta.cos() - s * gamma.cos();
    let y = crank * phi.sin() + rod * theta.sin() - s * gamma.sin();
    vec![crank, rod, x, y, gamma, 0.0]
}

fn short_rod(random: &mut Random, ratio: f64) -> Vec<f64> {
    let [crank, s] = [0; 2].map(|_| random.length(6.0));
    let rod = ratio * random.length(6.0).abs();
    let bend = random.between(-1.5, 1.5);
    closed(random, crank, rod, s, bend)
}

/// The crank pin all but on the guide: the distance of which the rod's direction is made vanishes.
fn along_the_guide(random: &mut Random, ratio: f64) -> Vec<f64> {
    let [crank, rod, s] = [0; 3].map(|_| random.length(6.0));
    let bend = ratio * random.between(-1.0, 1.0);
    closed(random, crank, rod.abs(), s, bend)
}

/// Rod, slide and, of every second geometry, crank are short.
fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let crank = random.length(6.0) * if random.chance(0.5) { ratio } else { 1.0 };
    let [rod, s] = [0; 2].map(|_| ratio * random.length(6.0));
    let bend = random.between(-1.5, 1.5);
    closed(random, crank, rod.abs(), s, bend)
}

#[test]
fn short_rods() {
    let cases = decade_cases(&SLIDER_CRANK, short_rod, 6, 111);
    let (fitting, points) = FIXED.split_at(FITTING);
    let limits = LIMITS.any_proportions();
    compare(&SLIDER_CRANK, fitting, &cases, Depth::Usual).check("short rods", &limits);
    let limits = limits.times(25.0);
    compare(&SLIDER_CRANK, points, &cases, Depth::Usual).check("short rods, point", &limits);
}

#[test]
fn rods_along_the_guide() {
    let cases = decade_cases(&SLIDER_CRANK, along_the_guide, 4, 112);
    let report = compare(&SLIDER_CRANK, FIXED, &cases, Depth::Usual);
    report.check("rods along the guide", &LIMITS.any_proportions());
}

#[test]
fn coincident_pivots() {
    let cases = decade_cases(&SLIDER_CRANK, near_pivots, 8, 113);
    let report = compare(&SLIDER_CRANK, FIXED, &cases, Depth::Usual);
    report.check("coincident pivots", &LIMITS.any_proportions());
}

#[test]
fn far_inputs() {
    let cases = far_input_cases(&SLIDER_CRANK, &FIXED_PLAN, 40, 114);
    let report = compare(&SLIDER_CRANK, FIXED, &cases, Depth::Usual);
    report.check("inputs to 1e6 rad", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&SLIDER_CRANK, FIXED, &FIXED_PLAN, 4, 115).check("slider-crank");
}

#[test]
fn extreme_scales_and_proportions() {
    let cases = wide_scale_cases(&SLIDER_CRANK, &FIXED_PLAN, 8, 116);
    let (fitting, _) = FIXED.split_at(FITTING);
    let report = compare(&SLIDER_CRANK, fitting, &cases, Depth::Usual);
    report.check(
        "sizes 1e-140 to 1e140, ratios to 1e8",
        &LIMITS.any_proportions(),
    );
}

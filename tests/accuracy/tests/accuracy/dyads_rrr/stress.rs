//! Hostile sets: needle triangles, coincident pivots, far inputs, both sides of the dead point.

use super::{FITTING, FORMS, FOUR_BAR, FOUR_BAR_PLAN, LIMITS};
use linkage_reference::{
    Depth, Random, compare, decade_cases, edge, far_input_cases, wide_scale_cases,
};

const PHI: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// The geometry with these links, closed at the reference input.
fn closed(random: &mut Random, [coupler, rocker]: [f64; 2], [theta, psi]: [f64; 2]) -> Vec<f64> {
    let [crank, arm] = [0; 2].map(|_| random.length(6.0));
    let x = crank * PHI.cos() + coupler * theta.cos() - rocker * psi.cos();
    let y = crank * PHI.sin() + coupler * theta.sin() - rocker * psi.sin();
    vec![x, y, crank, coupler, rocker, arm, random.angle()]
}

fn bent(random: &mut Random, links: [f64; 2]) -> Vec<f64> {
    let theta = random.angle();
    let psi = theta + random.between(0.05, 3.1);
    closed(random, links, [theta, psi])
}

fn short_coupler(random: &mut Random, ratio: f64) -> Vec<f64> {
    let rocker = random.length(6.0).abs();
    bent(random, [ratio * rocker, rocker])
}

fn short_rocker(random: &mut Random, ratio: f64) -> Vec<f64> {
    let coupler = random.length(6.0).abs();
    bent(random, [coupler, ratio * coupler])
}

/// The crank pin and the rocker's pivot at a distance of `ratio` times the rocker. Of every second
/// geometry the crank is as short as that, so that the distance is known to all digits.
fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let rocker = random.length(6.0).abs();
    let (psi, across) = (random.angle(), -random.between(0.05, 3.09));
    let distance = ratio * rocker;
    let shift = [(psi + across).cos(), (psi + across).sin()].map(|x| distance * x);
    let coupler = rocker + distance * (across.cos() + ratio * across.sin().powi(2) / 2.0);
    let crank = random.length(6.0) * if random.chance(0.5) { ratio } else { 1.0 };
    let x = crank * PHI.cos() + shift[0];
    let y = crank * PHI.sin() + shift[1];
    vec![
        x,
        y,
        crank,
        coupler,
        rocker,
        random.length(6.0),
        random.angle(),
    ]
}

#[test]
fn needle_triangles() {
    let mut cases = decade_cases(&FOUR_BAR, short_coupler, 4, 101);
    cases.extend(decade_cases(&FOUR_BAR, short_rocker, 4, 102));
    let (fitting, points) = FORMS.split_at(FITTING);
    let limits = LIMITS.any_proportions();
    compare(&FOUR_BAR, fitting, &cases, Depth::Usual).check("needle triangles", &limits);
    let limits = limits.times(25.0);
    compare(&FOUR_BAR, points, &cases, Depth::Usual).check("needles, unknown point", &limits);
}

#[test]
fn coincident_pivots() {
    let cases = decade_cases(&FOUR_BAR, near_pivots, 8, 103);
    let limits = LIMITS.any_proportions();
    compare(&FOUR_BAR, FORMS, &cases, Depth::Usual).check("coincident pivots", &limits);
}

#[test]
fn far_inputs() {
    let cases = far_input_cases(&FOUR_BAR, &FOUR_BAR_PLAN, 40, 104);
    compare(&FOUR_BAR, FORMS, &cases, Depth::Usual).check("inputs to 1e6 rad", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&FOUR_BAR, FORMS, &FOUR_BAR_PLAN, 3, 105).check("four-bar");
}

#[test]
fn extreme_scales_and_proportions() {
    let cases = wide_scale_cases(&FOUR_BAR, &FOUR_BAR_PLAN, 8, 106);
    let (fitting, _) = FORMS.split_at(FITTING);
    let report = compare(&FOUR_BAR, fitting, &cases, Depth::Usual);
    report.check(
        "sizes 1e-140 to 1e140, ratios to 1e8",
        &LIMITS.any_proportions(),
    );
}

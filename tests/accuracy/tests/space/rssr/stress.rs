//! Hostile sets: needles, short couplers, far pivots and inputs, both sides of the dead point.

use super::{FORMS, PLAN, RSSR, closed};
use crate::{LIMITS, direction};
use linkage_accuracy::{
    Depth, Random, compare, decade_cases, edge, far_input_cases, wide_scale_cases,
};

fn short_coupler(random: &mut Random, ratio: f64) -> Vec<f64> {
    let rocker = random.length(6.0);
    let [crank, lift] = [0; 2].map(|_| random.length(6.0));
    let coupler = ratio * rocker.abs() * direction(random);
    closed(
        [crank, rocker, lift],
        coupler,
        [0; 3].map(|_| random.angle()),
    )
}

fn short_rocker(random: &mut Random, ratio: f64) -> Vec<f64> {
    let coupler = random.length(6.0).abs() * direction(random);
    let rocker = ratio * coupler.norm();
    let [crank, lift] = [0; 2].map(|_| random.length(6.0));
    closed(
        [crank, rocker, lift],
        coupler,
        [0; 3].map(|_| random.angle()),
    )
}

/// A rocker so far away that the coupler and the crank are short beside the distance.
fn far_pivot(random: &mut Random, ratio: f64) -> Vec<f64> {
    let rocker = random.length(6.0) / ratio;
    let coupler = random.length(6.0).abs() * direction(random);
    let [crank, lift] = [0; 2].map(|_| random.length(6.0));
    closed(
        [crank, rocker, lift],
        coupler,
        [0; 3].map(|_| random.angle()),
    )
}

#[test]
fn needles() {
    let mut cases = decade_cases(&RSSR, short_coupler, 3, 211);
    cases.extend(decade_cases(&RSSR, short_rocker, 3, 212));
    compare(&RSSR, FORMS, &cases, Depth::Usual)
        .at_least(55)
        .check("needles", &LIMITS.any_proportions());
}

#[test]
fn far_pivots() {
    let cases = decade_cases(&RSSR, far_pivot, 3, 213);
    compare(&RSSR, FORMS, &cases, Depth::Usual)
        .at_least(25)
        .check("far pivots", &LIMITS.any_proportions());
}

#[test]
fn far_inputs() {
    let cases = far_input_cases(&RSSR, &PLAN, 30, 214);
    compare(&RSSR, FORMS, &cases, Depth::Usual)
        .at_least(20)
        .check("inputs to 1e6 rad", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&RSSR, FORMS, &PLAN, 3, 215).check("RSSR");
}

#[test]
fn extreme_scales_and_proportions() {
    let cases = wide_scale_cases(&RSSR, &PLAN, 6, 216);
    compare(&RSSR, FORMS, &cases, Depth::Usual)
        .at_least(19)
        .check(
            "sizes 1e-140 to 1e140, ratios to 1e8",
            &LIMITS.any_proportions(),
        );
}

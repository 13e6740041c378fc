//! Hostile sets: needles, short couplers, far pivots and inputs, both sides of the dead point.

use super::{FORMS, PLAN, RSSR, closed, frame_of};
use crate::space::{LIMITS, direction};
use linkage_reference::{Depth, Limits, Measure, Random, compare, decade_cases, edge};
use nalgebra::Vector3;

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

/// Two equal links, long beside the distance of their ends: what decides is the difference of their squares, 0.
fn equal_links(random: &mut Random, ratio: f64) -> Vec<f64> {
    let long = random.length(6.0).abs() / ratio;
    let [crank, lift] = [0; 2].map(|_| random.length(6.0));
    let angles = [0; 3].map(|_| random.angle());
    let near = random.length(6.0).abs() * direction(random);
    let [_, _, axis] = frame_of(angles[0], angles[1]);
    let phi = 60f64.to_radians();
    let pin = Vector3::new(crank * phi.cos(), crank * phi.sin(), 0.0);
    let pivot = pin + near - lift * axis;
    vec![
        crank, long, long, lift, pivot.x, pivot.y, pivot.z, angles[0], angles[1],
    ]
}

/// As exact as the links are long, however small the margin is. Sensitivities are not: they contain the link's component along the rocker's axis, the small
/// sum of large terms.
#[test]
fn equal_long_links() {
    let report = compare(
        &RSSR,
        FORMS,
        &decade_cases(&RSSR, equal_links, 3, 217),
        Depth::Usual,
    )
    .at_least(35);
    // Sensitivities are first derivatives, too: the velocities of these are looked at below.
    let without_sensitivities = Limits {
        first: f64::INFINITY,
        ..LIMITS
    };
    report.check("equal long links", &without_sensitivities);
    for measure in [Measure::Position, Measure::Value, Measure::First] {
        let largest = report.largest_raw(measure);
        assert!(largest < 60.0, "{measure:?}: {largest}");
    }
}

/// As many digits are lost as the links are longer than the distance of their ends, and no more: at 1e13 two or three are left. The link's vector in the
/// rocker's frame would keep them, at the cost of projections in the derivatives of every RSSR.
#[test]
fn sensitivities_of_equal_long_links() {
    let all = decade_cases(&RSSR, equal_links, 8, 218);
    // Of fifteen decades the last two are beside dead points.
    for decade in 1..=13 {
        let cases = all.iter().skip(decade - 1).step_by(15);
        let cases: Vec<_> = cases.cloned().collect();
        let report = compare(&RSSR, FORMS, &cases, Depth::Usual).at_least(1);
        let lost = report.largest_raw(Measure::Sensitivity) / 10f64.powi(decade as i32);
        println!("links 1e{decade} times as long: {lost:.1} roundoffs times that");
        assert!(lost < 30.0, "{lost}");
    }
}

#[test]
fn needles() {
    let mut cases = decade_cases(&RSSR, short_coupler, 3, 211);
    cases.extend(decade_cases(&RSSR, short_rocker, 3, 212));
    compare(&RSSR, FORMS, &cases, Depth::Usual)
        .at_least(55)
        .check("needles", &LIMITS.any_proportions());
}

linkage_reference::sets! { RSSR, FORMS;
    far_pivots "far pivots":
        decade_cases(far_pivot, 3, 213), Usual, LIMITS.any_proportions(), at least 25;
    far_inputs "inputs to 1e6 rad": far_input_cases(&PLAN, 30, 214), Usual, LIMITS, at least 20;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&RSSR, FORMS, &PLAN, 3, 215).check("RSSR");
}

linkage_reference::sets! { RSSR, FORMS;
    extreme_scales_and_proportions "sizes 1e-140 to 1e140, ratios to 1e8":
        wide_scale_cases(&PLAN, 6, 216), Usual, LIMITS.any_proportions(), at least 19;
}

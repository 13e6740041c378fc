//! Dyad RRP on a guide that moves with other links, and the hostile sets of the dyad.

use super::{FITTING, FIXED, FIXED_PLAN, LIMITS, SLIDER_CRANK, geometry};
use linkage_reference::{
    Depth, Form, Plan, Random, System, Unknown, compare, data, dead_point_cases, decade_cases,
    edge, forms, proportion_cases, scale_cases, wide_scale_cases,
};

// Hostile sets: short rods, rods along the guide, far inputs, both sides of the dead point.

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

linkage_reference::sets! { SLIDER_CRANK, FIXED;
    rods_along_the_guide "rods along the guide":
        decade_cases(along_the_guide, 4, 112), Usual, LIMITS.any_proportions();
    coincident_pivots "coincident pivots":
        decade_cases(near_pivots, 8, 113), Usual, LIMITS.any_proportions();
    far_inputs "inputs to 1e6 rad": far_input_cases(&FIXED_PLAN, 40, 114), Usual, LIMITS;
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

// The same with a guide that turns with the input.

const MOVING_GUIDE: System = System {
    name: "moving guide",
    data: data! {
        length "crank" 30.0, "rod" 100.0, "guide.x" 0.0, "guide.y" 10.0;
        degrees "gamma" 5.0;
        ratio "ratio" 0.25;
        degrees "phi" 30.0;
    },
    parameters: 6,
    unknowns: &[Unknown::angle("theta", 3.0), Unknown::slide("s", 126.0)],
    pairs: &[(0, 1), (4, 5)],
    ..SLIDER_CRANK
};

macro_rules! moving_guide {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [theta, s, pin];
            pairs crank rod, gamma ratio;
            fields |g| {
                crank: g[0], rod: g[1], guide: [g[2], g[3]], gamma: g[4], ratio: g[5]
            }
            {
                unit mm;
                param crank = 30mm;
                param rod = 100mm;
                param guide = (0mm, 10mm);
                param gamma = 5deg;
                param ratio = 0.25;
                input phi = 30deg in 0deg..360deg;
                let wheel = gamma + ratio * phi;
                $($items)*
            }
        }
    };
}

moving_guide!(moving_plain {
    unknown theta = 10deg;
    unknown s = 126mm;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop pin = guide + s * dir(wheel);
});

moving_guide!(moving_other_order {
    unknown s = 126mm;
    unknown theta = 10deg;
    let pin = rotate((crank, 0mm), phi) + polar(rod, theta);
    loop -polar(rod, theta) + rotate((s, 0), wheel) + guide = rotate((crank, 0mm), phi);
});

moving_guide!(moving_across {
    unknown theta = 10deg;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop dot(dir(wheel + 90deg), pin) = dot(dir(wheel + 90deg), guide);
    let s = dot(pin - guide, dir(wheel));
});

const MOVING_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let ratio = random.between(-2.0, 2.0);
        geometry(random, spread, ratio)
    },
    dead_points: &[(1, 1e-3)],
};

const MOVING: &[Form] = forms![moving_plain, moving_other_order, moving_across];

linkage_reference::sets! { MOVING_GUIDE, MOVING;
    moving_guide_cycles "cycles": cycle_cases(&MOVING_PLAN, 30, 15), Full, LIMITS;
}

#[test]
fn moving_guide_hard_cases() {
    let mut cases = dead_point_cases(&MOVING_GUIDE, &MOVING_PLAN, 6, 16);
    cases.extend(scale_cases(&MOVING_GUIDE, &MOVING_PLAN, 4, 17));
    cases.extend(proportion_cases(&MOVING_GUIDE, &MOVING_PLAN, 20, 18));
    compare(&MOVING_GUIDE, MOVING, &cases, Depth::Full).check(
        "dead points, proportions, scales",
        &LIMITS.any_proportions(),
    );
}

//! RSSP: a slide on any line, at a given distance from a point.

use super::{LIMITS, direction};
use linkage_reference::{
    Big, Datum, Depth, Form, Output, Plan, Position, Random, Space, System, Unknown, compare,
    cycle_cases, dead_point_cases, decade_cases, edge, forms, line_gap, proportion_cases,
    scale_cases,
};
use nalgebra::Vector3;

fn pin(p: &Position) -> Space {
    let pin = p.polar("crank", "phi");
    Space::new(pin.x, pin.y, 0.0)
}

const RSSP: System = System {
    name: "RSSP",
    data: &[
        Datum::length("crank", 12.0),
        Datum::length("rod", 60.0),
        Datum::length("rail.x", 20.0),
        Datum::length("rail.y", -10.0),
        Datum::length("rail.z", 15.0),
        Datum::ratio("guide.x", 0.9),
        Datum::ratio("guide.y", 0.3),
        Datum::ratio("guide.z", 0.4),
        Datum::degrees("phi", 60.0),
    ],
    parameters: 8,
    unknowns: &[Unknown::slide("s", 40.0)],
    residual: |p| {
        let slider = p.space("rail") + p.space("guide").times(p.slide("s"));
        vec![(slider - pin(p)).norm() - p.value("rod")]
    },
    outputs: |p| {
        let slider = p.space("rail") + p.space("guide").times(p.slide("s"));
        let [x, y, z] = slider.components().map(Output::Value);
        vec![Output::Value(p.slide("s").clone()), x, y, z]
    },
    gap: |p| {
        let rail = (&p.space("rail"), &p.space("guide"));
        line_gap(p.value("rod"), &pin(p), rail)
    },
    turned: |_| Big::one(),
    pairs: &[(1, 1), (0, 1)],
    linear: false,
    margin: None,
};

macro_rules! rssp {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [s, slider];
            $($pairs)*
            fields |g| {
                crank: g[0], rod: g[1], rail: [g[2], g[3], g[4]],
                guide: [g[5], g[6], g[7]]
            }
            {
                unit mm;
                param crank = 12mm;
                param rod = 60mm;
                param rail = (20mm, -10mm, 15mm);
                param guide = (0.9, 0.3, 0.4);
                input phi = 60deg in 0deg..360deg;
                unknown s = 40mm;
                let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
                let slider = rail + s * guide;
                $($items)*
            }
        }
    };
}

rssp!(distances [pairs rod rod, crank rod;] {
    loop distance(pin, slider) = rod;
});

rssp!(square [] {
    loop rod * rod = dot(slider - pin, slider - pin);
});

rssp!(unknown_rod [] {
    unknown bar = (40mm, -10mm, 30mm);
    loop slider - bar = pin;
    loop norm(bar) = rod;
});

/// The geometry whose rod lies along `rod` at the reference input, or against it, as the assembly
/// mode asks.
fn closed([crank, s]: [f64; 2], rod: Vector3<f64>, guide: Vector3<f64>) -> Vec<f64> {
    let phi = 60f64.to_radians();
    let rod = if rod.dot(&guide) < 0.0 { -rod } else { rod };
    let pin = Vector3::new(crank * phi.cos(), crank * phi.sin(), 0.0);
    let rail = pin + rod - s * guide;
    vec![
        crank,
        rod.norm(),
        rail.x,
        rail.y,
        rail.z,
        guide.x,
        guide.y,
        guide.z,
    ]
}

pub(crate) const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let lengths = [0; 2].map(|_| random.length(spread));
        let rod = random.length(spread).abs() * direction(random);
        let guide = random.ratio(0.5, 2.0) * direction(random);
        closed(lengths, rod, guide)
    },
    dead_points: &[(1, 1e-3), (0, 40.0)],
};

/// A rod so much shorter than all other lengths.
fn short_rod(random: &mut Random, ratio: f64) -> Vec<f64> {
    let lengths = [0; 2].map(|_| random.length(6.0));
    let rod = 50.0 * ratio * direction(random);
    closed(lengths, rod, direction(random))
}

pub(crate) const FORMS: &[Form] = forms![distances, square, unknown_rod];

#[test]
fn cycles() {
    let cases = cycle_cases(&RSSP, &PLAN, 20, 221);
    compare(&RSSP, FORMS, &cases, Depth::Full)
        .at_least(35)
        .check("cycles", &LIMITS);
}

#[test]
fn dead_points() {
    let cases = dead_point_cases(&RSSP, &PLAN, 5, 222);
    compare(&RSSP, FORMS, &cases, Depth::Full)
        .at_least(45)
        .check("dead points", &LIMITS);
}

#[test]
fn proportions() {
    let mut cases = proportion_cases(&RSSP, &PLAN, 30, 223);
    cases.extend(decade_cases(&RSSP, short_rod, 3, 224));
    compare(&RSSP, FORMS, &cases, Depth::Usual)
        .at_least(70)
        .check("proportions", &LIMITS.any_proportions());
}

#[test]
fn scales() {
    let cases = scale_cases(&RSSP, &PLAN, 6, 225);
    compare(&RSSP, FORMS, &cases, Depth::Usual)
        .at_least(25)
        .check("scales", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&RSSP, FORMS, &PLAN, 3, 226).check("RSSP");
}

//! Three distances.

use super::{PHI, directions, distance, outputs, pin, pin_of, radical};
use crate::space::{LIMITS, direction};
use linkage_reference::{
    Big, Datum, Depth, Form, Plan, Random, System, Unknown, compare, cycle_cases, dead_point_cases,
    decade_cases, edge, forms, line_gap, planes_line, proportion_cases, scale_cases,
};
use nalgebra::Vector3;

const THREE: System = System {
    name: "three distances",
    data: &[
        Datum::length("crank", 10.0),
        Datum::length("two.x", 60.0),
        Datum::length("two.y", 5.0),
        Datum::length("two.z", 3.0),
        Datum::length("three.x", 20.0),
        Datum::length("three.y", 55.0),
        Datum::length("three.z", -2.0),
        Datum::length("l1", 45.0),
        Datum::length("l2", 57.0),
        Datum::length("l3", 52.0),
        Datum::degrees("phi", 30.0),
    ],
    parameters: 10,
    unknowns: &[
        Unknown::slide("p.x", 26.0),
        Unknown::slide("p.y", 20.0),
        Unknown::slide("p.z", -40.0),
    ],
    residual: |p| {
        vec![
            distance(p, &pin(p), "l1"),
            distance(p, &p.space("two"), "l2"),
            distance(p, &p.space("three"), "l3"),
        ]
    },
    outputs,
    gap: |p| {
        let (one, l1) = (pin(p), p.value("l1"));
        let [(n2, d2), (n3, d3)] = [("two", "l2"), ("three", "l3")]
            .map(|(point, length)| radical([(&one, l1), (&p.space(point), p.value(length))]));
        let (on_line, direction) = planes_line([(&n2, &d2), (&n3, &d3)]);
        line_gap(l1, &one, (&on_line, &direction))
    },
    turned: |_| Big::one(),
    pairs: &[(0, 7), (8, 9)],
    linear: false,
    margin: None,
};

macro_rules! three {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [p];
            $($pairs)*
            fields |g| {
                crank: g[0], two: [g[1], g[2], g[3]], three: [g[4], g[5], g[6]],
                l1: g[7], l2: g[8], l3: g[9]
            }
            {
                unit mm;
                param crank = 10mm;
                param two = (60mm, 5mm, 3mm);
                param three = (20mm, 55mm, -2mm);
                param l1 = 45mm;
                param l2 = 57mm;
                param l3 = 52mm;
                input phi = 30deg in 0deg..360deg;
                unknown p = (26mm, 20mm, -40mm);
                let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
                $($items)*
            }
        }
    };
}

three!(distances [pairs crank l1, l2 l3;] {
    loop distance(p, one) = l1;
    loop distance(p, two) = l2;
    loop distance(p, three) = l3;
});

three!(mixed [] {
    loop norm(three - p) - l3 = 0mm;
    loop dot(p - two, p - two) = l2 * l2;
    loop l1 = norm(p - one);
});

pub(crate) const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let crank = random.length(spread);
        // As in the mechanism as written, the first distance is the shortest: the others refer to it.
        let mut lengths = [0; 3].map(|_| random.length(spread).abs());
        lengths.sort_by(f64::total_cmp);
        let [u1, u2, u3] = directions(random, -1.0);
        let p = pin_of(crank) + lengths[0] * u1;
        closed(crank, [p - lengths[1] * u2, p - lengths[2] * u3], lengths)
    },
    dead_points: &[(7, 1e-3), (8, 30.0), (9, 30.0)],
};

fn closed(crank: f64, [two, three]: [Vector3<f64>; 2], lengths: [f64; 3]) -> Vec<f64> {
    [&[crank][..], two.as_slice(), three.as_slice(), &lengths[..]].concat()
}

/// Three known points so near to each other beside the distances.
fn near_points(random: &mut Random, ratio: f64) -> Vec<f64> {
    let crank = 50.0 * ratio;
    let base = [pin_of(crank), Vector3::zeros(), Vector3::zeros()];
    let [one, two, three] = base.map(|v| v + ratio * random.length(6.0) * direction(random));
    let one = pin_of(crank) + 0.0 * one;
    let normal = (two - one).cross(&(three - one)).normalize();
    let beside = random.length(3.0).abs();
    let p = one + beside * (normal + 0.5 * direction(random)).normalize();
    let sign = (p - one).dot(&(p - two).cross(&(p - three)));
    let p = if sign > 0.0 { one - (p - one) } else { p };
    closed(
        crank,
        [two, three],
        [one, two, three].map(|v| (p - v).norm()),
    )
}

pub(crate) const FORMS: &[Form] = forms![distances, mixed];

#[test]
fn cycles() {
    assert_eq!(THREE.reference_input(), PHI);
    let cases = cycle_cases(&THREE, &PLAN, 8, 231);
    compare(&THREE, FORMS, &cases, Depth::Full)
        .at_least(19)
        .check("cycles", &LIMITS);
}

#[test]
fn dead_points() {
    let cases = dead_point_cases(&THREE, &PLAN, 4, 232);
    compare(&THREE, FORMS, &cases, Depth::Usual)
        .at_least(55)
        .check("dead points", &LIMITS);
}

#[test]
fn proportions() {
    let cases = proportion_cases(&THREE, &PLAN, 20, 233);
    compare(&THREE, FORMS, &cases, Depth::Usual)
        .at_least(25)
        .check("proportions", &LIMITS.any_proportions());
}

#[test]
fn near_each_other() {
    let cases = decade_cases(&THREE, near_points, 3, 234);
    compare(&THREE, FORMS, &cases, Depth::Usual)
        .at_least(30)
        .check("near points", &LIMITS.any_proportions());
}

#[test]
fn scales() {
    let cases = scale_cases(&THREE, &PLAN, 4, 235);
    compare(&THREE, FORMS, &cases, Depth::Usual)
        .at_least(15)
        .check("scales", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&THREE, FORMS, &PLAN, 2, 236).check("three distances");
}

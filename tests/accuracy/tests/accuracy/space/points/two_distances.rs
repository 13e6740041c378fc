//! Two distances and a plane.

use super::{directions, distance, outputs, pin, pin_of, plane, radical};
use crate::space::LIMITS;
use linkage_reference::{
    Big, Datum, Depth, Form, Plan, System, Unknown, compare, cycle_cases, dead_point_cases, edge,
    forms, line_gap, planes_line, proportion_cases, scale_cases,
};

const TWO: System = System {
    name: "two distances and a plane",
    data: &[
        Datum::length("crank", 10.0),
        Datum::length("two.x", 60.0),
        Datum::length("two.y", 5.0),
        Datum::length("two.z", 3.0),
        Datum::length("l1", 45.0),
        Datum::length("l2", 57.0),
        Datum::ratio("normal.x", 0.1),
        Datum::ratio("normal.y", 0.9),
        Datum::ratio("normal.z", 0.2),
        Datum::length("height", 13.0),
        Datum::degrees("phi", 30.0),
    ],
    parameters: 10,
    unknowns: &[
        Unknown::slide("p.x", 25.0),
        Unknown::slide("p.y", 21.0),
        Unknown::slide("p.z", -40.0),
    ],
    residual: |p| {
        vec![
            distance(p, &pin(p), "l1"),
            distance(p, &p.space("two"), "l2"),
            plane(p, "normal", "height"),
        ]
    },
    outputs,
    gap: |p| {
        let (one, l1) = (pin(p), p.value("l1"));
        let (normal, offset) = radical([(&one, l1), (&p.space("two"), p.value("l2"))]);
        let given = (&p.space("normal"), p.value("height"));
        let (on_line, direction) = planes_line([(&normal, &offset), given]);
        line_gap(l1, &one, (&on_line, &direction))
    },
    turned: |_| Big::one(),
    pairs: &[(4, 5), (0, 9)],
    linear: false,
    margin: None,
};

macro_rules! two {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [p];
            $($pairs)*
            fields |g| {
                crank: g[0], two: [g[1], g[2], g[3]], l1: g[4], l2: g[5],
                normal: [g[6], g[7], g[8]], height: g[9]
            }
            {
                unit mm;
                param crank = 10mm;
                param two = (60mm, 5mm, 3mm);
                param l1 = 45mm;
                param l2 = 57mm;
                param normal = (0.1, 0.9, 0.2);
                param height = 13mm;
                input phi = 30deg in 0deg..360deg;
                unknown p = (25mm, 21mm, -40mm);
                let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
                $($items)*
            }
        }
    };
}

two!(height_along_normal [pairs l1 l2, crank height;] {
    loop distance(p, one) = l1;
    loop distance(p, two) = l2;
    loop dot(normal, p) = height;
});

two!(point_in_plane [] {
    loop dot(normal, p - height / dot(normal, normal) * normal) = 0mm;
    loop l2 = norm(two - p);
    loop dot(p - one, p - one) = l1 * l1;
});

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let crank = random.length(spread);
        // As in the mechanism as written, the first distance is the shortest: the others refer to it.
        let mut lengths = [0; 2].map(|_| random.length(spread).abs());
        lengths.sort_by(f64::total_cmp);
        let size = random.ratio(0.5, 2.0);
        let [u1, u2, normal] = directions(random, 1.0);
        let p = pin_of(crank) + lengths[0] * u1;
        let (two, normal) = (p - lengths[1] * u2, size * normal);
        let height = normal.dot(&p);
        vec![
            crank, two.x, two.y, two.z, lengths[0], lengths[1], normal.x, normal.y, normal.z,
            height,
        ]
    },
    dead_points: &[(4, 1e-3), (5, 30.0), (9, 1e3)],
};

const FORMS: &[Form] = forms![height_along_normal, point_in_plane];

#[test]
fn cycles() {
    let cases = cycle_cases(&TWO, &PLAN, 8, 241);
    compare(&TWO, FORMS, &cases, Depth::Full)
        .at_least(20)
        .check("cycles", &LIMITS);
}

#[test]
fn dead_points() {
    let cases = dead_point_cases(&TWO, &PLAN, 4, 242);
    compare(&TWO, FORMS, &cases, Depth::Usual)
        .at_least(55)
        .check("dead points", &LIMITS);
}

#[test]
fn proportions_and_scales() {
    let cases = proportion_cases(&TWO, &PLAN, 20, 243);
    compare(&TWO, FORMS, &cases, Depth::Usual)
        .at_least(25)
        .check("proportions", &LIMITS.any_proportions());
    let cases = scale_cases(&TWO, &PLAN, 4, 244);
    compare(&TWO, FORMS, &cases, Depth::Usual)
        .at_least(16)
        .check("scales", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&TWO, FORMS, &PLAN, 2, 245).check("two distances and a plane");
}

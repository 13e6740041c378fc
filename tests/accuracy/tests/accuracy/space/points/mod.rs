//! An unknown point at given distances from known points, or in known planes.

pub(crate) mod three_distances;

use crate::space::{LIMITS, direction};
use linkage_reference::{
    Big, Depth, Form, Plan, Position, Random, Space, System, compare, data, edge, forms, line_gap,
    planes_line, proportion_cases, scale_cases, unknowns,
};
use nalgebra::{Matrix3, Vector3};

/// The input at the reference, in every mechanism of this module.
const PHI: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// The end of a crank that turns about the y axis.
fn pin(p: &Position) -> Space {
    let pin = p.polar("crank", "phi");
    Space::new(pin.x, 0.0, -pin.y)
}

fn pin_of(crank: f64) -> Vector3<f64> {
    crank * Vector3::new(PHI.cos(), 0.0, -PHI.sin())
}

fn distance(p: &Position, from: &Space, length: &str) -> Big {
    (p.space("p") - from.clone()).norm() - p.value(length)
}

/// By how much the point misses a plane, as a length.
fn plane(p: &Position, normal: &str, height: &str) -> Big {
    p.space("p").dot(&p.space(normal)) - p.value(height)
}

/// The plane of the points whose distances from two known points have the given difference of
/// squares: normal and offset.
fn radical([one, two]: [(&Space, &Big); 2]) -> (Space, Big) {
    let square = |v: &Space, length: &Big| v.dot(v) - length * length;
    let offset = square(two.0, two.1) - square(one.0, one.1);
    ((two.0.clone() - one.0.clone()), offset * 0.5)
}

/// Three random directions (of distances or of normals) from which a point is found in the given
/// assembly mode: the sign of their determinant.
fn directions(random: &mut Random, sign: f64) -> [Vector3<f64>; 3] {
    let all = [0; 3].map(|_| direction(random));
    let determinant = Matrix3::from_columns(&all).determinant();
    if determinant * sign < 0.0 {
        all.map(|v| -v)
    } else {
        all
    }
}

// One distance and two planes.

const ONE: System = System {
    name: "one distance and two planes",
    data: data! {
        length "crank" 10.0, "l1" 45.0;
        ratio "m.x" 0.8, "m.y" -0.3, "m.z" 0.1;
        length "at_m" 10.0;
        ratio "n.x" 0.1, "n.y" 0.9, "n.z" 0.2;
        length "at_n" 13.0;
        degrees "phi" 30.0;
    },
    parameters: 10,
    unknowns: unknowns! {
        slide "p.x" 26.0, "p.y" 21.0, "p.z" -41.0;
    },
    residual: |p| {
        vec![
            distance(p, &pin(p), "l1"),
            plane(p, "m", "at_m"),
            plane(p, "n", "at_n"),
        ]
    },
    gap: |p| {
        let (m, n) = (p.space("m"), p.space("n"));
        let (on_line, direction) = planes_line([(&m, p.value("at_m")), (&n, p.value("at_n"))]);
        line_gap(p.value("l1"), &pin(p), (&on_line, &direction))
    },
    pairs: &[(1, 5), (0, 9)],
    ..System::PLAIN
};

macro_rules! one {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [p];
            $($pairs)*
            fields |g| {
                crank: g[0], l1: g[1], m: [g[2], g[3], g[4]], at_m: g[5],
                n: [g[6], g[7], g[8]], at_n: g[9]
            }
            {
                unit mm;
                param crank = 10mm;
                param l1 = 45mm;
                param m = (0.8, -0.3, 0.1);
                param at_m = 10mm;
                param n = (0.1, 0.9, 0.2);
                param at_n = 13mm;
                input phi = 30deg in 0deg..360deg;
                unknown p = (26mm, 21mm, -41mm);
                let pin = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
                $($items)*
            }
        }
    };
}

one!(distances [pairs l1 at_m, crank at_n;] {
    loop distance(p, pin) = l1;
    loop dot(m, p) = at_m;
    loop dot(n, p) = at_n;
});

one!(moved [] {
    loop dot(p - pin, n) = at_n - dot(n, pin);
    loop dot(p - pin, p - pin) = l1 * l1;
    loop dot(m, pin - p) + at_m = dot(m, pin);
});

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let (crank, l1) = (random.length(spread), random.length(spread).abs());
        let sizes = [0; 2].map(|_| random.ratio(0.5, 2.0));
        let [u, m, n] = directions(random, -1.0);
        let p = pin_of(crank) + l1 * u;
        let (m, n) = (sizes[0] * m, sizes[1] * n);
        vec![
            crank,
            l1,
            m.x,
            m.y,
            m.z,
            m.dot(&p),
            n.x,
            n.y,
            n.z,
            n.dot(&p),
        ]
    },
    dead_points: &[(1, 1e-3), (5, 1e3), (9, -1e3)],
};

const FORMS: &[Form] = forms![distances, moved];

linkage_reference::sets! { ONE, FORMS;
    cycles "cycles": cycle_cases(&PLAN, 8, 251), Full, LIMITS, at least 20;
    dead_points "dead points": dead_point_cases(&PLAN, 4, 252), Usual, LIMITS, at least 55;
}

#[test]
fn proportions_and_scales() {
    let cases = proportion_cases(&ONE, &PLAN, 20, 253);
    compare(&ONE, FORMS, &cases, Depth::Usual)
        .at_least(25)
        .check("proportions", &LIMITS.any_proportions());
    let cases = scale_cases(&ONE, &PLAN, 4, 254);
    compare(&ONE, FORMS, &cases, Depth::Usual)
        .at_least(20)
        .check("scales", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&ONE, FORMS, &PLAN, 2, 255).check("one distance and two planes");
}

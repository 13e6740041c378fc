//! RSSR: a crank and a rocker about any two axes, their ends on a bar with two ball joints.

mod stress;

use super::{LIMITS, direction};
use linkage_reference::{
    Depth, Form, Output, Plan, Position, Space, System, Unknown, circle_gap, compare, cycle_cases,
    data, forms,
};
use nalgebra::Vector3;

/// The directions `x`, `y`, `z` of the rocker's frame: its axis is `z`, and `psi` counts from `x`.
fn frame(p: &Position) -> [Space; 3] {
    let [one, two] = ["gamma1", "gamma2"].map(|name| p.direction(name));
    let x = Space::new(one.x.clone(), 0.0, -&one.y);
    let z = Space::new(one.y, 0.0, one.x);
    let y = Space::new(0.0, 1.0, 0.0);
    let axis = z.times(&two.x) - y.times(&two.y);
    let across = y.times(&two.x) + z.times(&two.y);
    [x, across, axis]
}

fn pin(p: &Position) -> Space {
    let pin = p.polar("crank", "phi");
    Space::new(pin.x, pin.y, 0.0)
}

/// The centre of the circle on which the rocker's end moves.
fn centre(p: &Position) -> Space {
    let [_, _, axis] = frame(p);
    p.space("pivot") + axis.times(p.value("lift"))
}

fn end(p: &Position) -> Space {
    let [x, y, _] = frame(p);
    centre(p) + Space::in_plane(&p.polar("rocker", "psi"), &x, &y)
}

pub(crate) const RSSR: System = System {
    name: "RSSR",
    data: data! {
        length "crank" 10.0, "coupler" 50.0, "rocker" 30.0, "lift" 3.0, "pivot.x" 40.0,
            "pivot.y" 10.0, "pivot.z" 5.0;
        degrees "gamma1" 50.0, "gamma2" 10.0, "phi" 60.0;
    },
    parameters: 9,
    unknowns: &[Unknown::angle("psi", 100.0)],
    residual: |p| vec![(end(p) - pin(p)).norm() - p.value("coupler")],
    further: |p| Output::lengths(end(p).components()),
    gap: |p| {
        let [_, _, axis] = frame(p);
        let circle = (&centre(p), &axis, p.value("rocker"));
        circle_gap(p.value("coupler"), &pin(p), circle)
    },
    pairs: &[(1, 7), (3, 8)],
    ..System::PLAIN
};

macro_rules! rssr {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [psi, end];
            $($pairs)*
            fields |g| {
                crank: g[0], coupler: g[1], rocker: g[2], lift: g[3], pivot: [g[4], g[5], g[6]],
                gamma1: g[7], gamma2: g[8]
            }
            {
                unit mm;
                param crank = 10mm;
                param coupler = 50mm;
                param rocker = 30mm;
                param lift = 3mm;
                param pivot = (40mm, 10mm, 5mm);
                param gamma1 = 50deg;
                param gamma2 = 10deg;
                input phi = 60deg in 0deg..360deg;
                                let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
                let x = turn((1, 0, 0), (0, 1, 0), gamma1);
                let axis = turn(turn((0, 0, 1), (0, 1, 0), gamma1), x, gamma2);
                $($items)*
            }
        }
    };
}

rssr!(distances [pairs coupler gamma1, lift gamma2;] {
    unknown psi = 100deg;
    let end = pivot + turn(rocker * x + lift * axis, axis, psi);
    loop distance(pin, end) = coupler;
});

rssr!(square [pairs coupler gamma1, lift gamma2;] {
    unknown psi = 100deg;
    let end = pivot + turn(rocker * x + lift * axis, axis, psi);
    loop dot(end - pin, end - pin) = coupler * coupler;
});

rssr!(norms [] {
    unknown psi = 100deg;
    let centre = pivot + lift * axis;
    let end = centre + rocker * turn(x, axis, psi);
    loop coupler - norm(pin - end) = 0;
});

rssr!(squares [] {
    unknown psi = 100deg;
    let y = (sin(gamma2) * sin(gamma1), cos(gamma2), sin(gamma2) * cos(gamma1));
    let end = pivot + lift * axis + rocker * (cos(psi) * x + sin(psi) * y);
    let bar = end - pin;
    loop bar.x * bar.x + bar.y * bar.y + bar.z * bar.z = coupler * coupler;
});

// Squares on both sides hide what the loop is: an equation between areas, which loses digits where
// lengths differ much.
rssr!(both_sides [] {
    unknown psi = 100deg;
    let end = pivot + lift * axis + rocker * turn(x, axis, psi);
    let bar = end - pin;
    loop coupler * coupler - bar.y * bar.y = bar.x * bar.x + bar.z * bar.z;
});

rssr!(unknown_coupler [] {
    unknown psi = 100deg;
    unknown bar = (37mm, 30mm, 15mm);
    let end = pivot + turn((rocker * x + lift * axis), -axis, -psi);
    loop pin + bar = end;
    loop norm(bar) = coupler;
});

/// The frame of the rocker as numbers.
pub(crate) fn frame_of(gamma1: f64, gamma2: f64) -> [Vector3<f64>; 3] {
    let x = Vector3::new(gamma1.cos(), 0.0, -gamma1.sin());
    let z = Vector3::new(gamma1.sin(), 0.0, gamma1.cos());
    let axis = gamma2.cos() * z - gamma2.sin() * Vector3::y();
    [x, axis.cross(&x), axis]
}

/// The geometry with these lengths and angles whose coupler lies along `coupler` at the reference
/// input, or against it, as the assembly mode asks.
fn closed(
    [crank, rocker, lift]: [f64; 3],
    coupler: Vector3<f64>,
    [gamma1, gamma2, psi]: [f64; 3],
) -> Vec<f64> {
    let phi = 60f64.to_radians();
    let [x, y, axis] = frame_of(gamma1, gamma2);
    let arm = rocker * (psi.cos() * x + psi.sin() * y);
    let slope = coupler.dot(&axis.cross(&arm));
    let coupler = if slope < 0.0 { -coupler } else { coupler };
    let pin = Vector3::new(crank * phi.cos(), crank * phi.sin(), 0.0);
    let pivot = pin + coupler - arm - lift * axis;
    vec![
        crank,
        coupler.norm(),
        rocker,
        lift,
        pivot.x,
        pivot.y,
        pivot.z,
        gamma1,
        gamma2,
    ]
}

pub(crate) const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let lengths = [0; 3].map(|_| random.length(spread));
        let coupler = random.length(spread).abs() * direction(random);
        closed(lengths, coupler, [0; 3].map(|_| random.angle()))
    },
    dead_points: &[(1, 40.0), (1, 0.01), (2, 40.0), (2, 0.01)],
};

pub(crate) const FORMS: &[Form] = forms![distances, square, norms, squares, unknown_coupler];
const BETWEEN_AREAS: &[Form] = forms![both_sides];

#[test]
fn cycles() {
    let cases = cycle_cases(&RSSR, &PLAN, 12, 201);
    let forms = [FORMS, BETWEEN_AREAS].concat();
    compare(&RSSR, &forms, &cases, Depth::Full)
        .at_least(25)
        .check("cycles", &LIMITS);
}

linkage_reference::sets! { RSSR, FORMS;
    dead_points "dead points": dead_point_cases(&PLAN, 4, 202), Usual, LIMITS, at least 80;
    proportions "proportions":
        proportion_cases(&PLAN, 30, 203), Usual, LIMITS.any_proportions(), at least 40;
    scales "scales": scale_cases(&PLAN, 8, 204), Usual, LIMITS, at least 30;
}

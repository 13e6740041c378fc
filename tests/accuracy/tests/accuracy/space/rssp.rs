//! RSSP, and single equations of one unknown in space.

use super::{LIMITS, direction};
use linkage::Dual;
use linkage_reference::{
    Depth, Form, Output, Plan, Position, ROUNDOFF, Random, Space, System, Unknown, compare, data,
    decade_cases, edge, forms, line_gap, proportion_cases,
};
use nalgebra::Vector3;
use num_dual::{Dual2_64, Dual64};

// RSSP: a slide on any line, at a given distance from a point.

fn pin(p: &Position) -> Space {
    let pin = p.polar("crank", "phi");
    Space::new(pin.x, pin.y, 0.0)
}

const RSSP: System = System {
    name: "RSSP",
    data: data! {
        length "crank" 12.0, "rod" 60.0, "rail.x" 20.0, "rail.y" -10.0, "rail.z" 15.0;
        ratio "guide.x" 0.9, "guide.y" 0.3, "guide.z" 0.4;
        degrees "phi" 60.0;
    },
    parameters: 8,
    unknowns: &[Unknown::slide("s", 40.0)],
    residual: |p| {
        let slider = p.space("rail") + p.space("guide").times(p.slide("s"));
        vec![(slider - pin(p)).norm() - p.value("rod")]
    },
    further: |p| {
        let slider = p.space("rail") + p.space("guide").times(p.slide("s"));
        Output::lengths(slider.components())
    },
    gap: |p| {
        let rail = (&p.space("rail"), &p.space("guide"));
        line_gap(p.value("rod"), &pin(p), rail)
    },
    pairs: &[(1, 1), (0, 1)],
    ..System::PLAIN
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

linkage_reference::sets! { RSSP, FORMS;
    cycles "cycles": cycle_cases(&PLAN, 20, 221), Full, LIMITS, at least 35;
    dead_points "dead points": dead_point_cases(&PLAN, 5, 222), Full, LIMITS, at least 45;
}

#[test]
fn proportions() {
    let mut cases = proportion_cases(&RSSP, &PLAN, 30, 223);
    cases.extend(decade_cases(&RSSP, short_rod, 3, 224));
    compare(&RSSP, FORMS, &cases, Depth::Usual)
        .at_least(70)
        .check("proportions", &LIMITS.any_proportions());
}

linkage_reference::sets! { RSSP, FORMS;
    scales "scales": scale_cases(&PLAN, 6, 225), Usual, LIMITS, at least 25;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&RSSP, FORMS, &PLAN, 3, 226).check("RSSP");
}

// Other numbers than `f64` in space: dual numbers as a second check of the derivatives, single
// precision, sweeps.

linkage::mechanism! {
    /// RSSR, RSSP on the rocker, a point on three spheres and a direction.
    struct Everything {
        unit mm;
        param crank = 10mm;
        param coupler = 50mm;
        param pivot = (40mm, 10mm, 5mm);
        param gamma = 50deg;
        param rod = 90mm;
        param leg = 60mm;
        input phi = 60deg in 0deg..360deg;
        unknown psi = 76deg;
        unknown s = 115mm;
        unknown p = (20mm, 31mm, 53mm);
        unknown n = (-0.3, -0.4, 0.9);
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let axis = turn((0, 0, 1), (0, 1, 0), gamma);
        let end = pivot + turn((0mm, 30mm, 0mm), axis, psi - 90deg);
        loop distance(pin, end) = coupler;
        loop distance(end, (30mm, 0mm, -60mm) + s * (0.9, 0.3, 0.4)) = rod;
        loop distance(p, end) = leg;
        loop distance(p, pin) = leg;
        loop distance(p, (0mm, 50mm, 0mm)) = leg;
        loop norm(n) = 1;
        loop dot(n, axis) = cos(70deg);
        loop dot(n, p) = 30mm;
    }

    impl Everything {
        fn values(phi) -> Values { psi, s, p, n }
        fn first(phi) -> First { psi: velocity(psi), s: velocity(s), p: velocity(p), n: velocity(n) }
        fn second(phi) -> Second {
            psi: acceleration(psi), s: acceleration(s), p: acceleration(p), n: acceleration(n),
        }
        fn by_crank(phi) -> ByCrank {
            psi: d(psi, crank), s: d(s, crank), p: d(p, crank), n: d(n, crank),
        }
    }
}

/// The quantities of a function as one list.
macro_rules! list {
    ($v:expr) => {{
        let v = $v;
        [v.psi, v.s, v.p.x, v.p.y, v.p.z, v.n.x, v.n.y, v.n.z]
    }};
}

const SIZES: [f64; 8] = [1.0, 100.0, 100.0, 100.0, 100.0, 1.0, 1.0, 1.0];

fn inputs() -> Vec<f64> {
    let mut random = Random::new(331);
    (0..100)
        .map(|_| random.between(0.0, core::f64::consts::TAU))
        .collect()
}

/// Asserts that lists agree to so many roundoffs of their sizes.
#[track_caller]
fn close(found: [f64; 8], expected: [f64; 8], roundoffs: f64) {
    for ((found, expected), size) in found.into_iter().zip(expected).zip(SIZES) {
        let allowed = roundoffs * ROUNDOFF * expected.abs().max(size);
        let error = (found - expected).abs();
        assert!(error <= allowed, "{found:e}, expected {expected:e}");
    }
}

#[test]
fn dual_numbers_give_the_same_derivatives() {
    let real = Everything::default().assemble().expect("closes");
    let one = Everything::default().cast::<Dual<Dual64>>();
    let one = one.assemble().expect("closes");
    let two = Everything::default().cast::<Dual<Dual2_64>>();
    let two = two.assemble().expect("closes");
    let mut longer = Everything::default().cast::<Dual<Dual64>>();
    longer.crank.0.eps = 1.0;
    let longer = longer.assemble().expect("closes");
    for phi in inputs() {
        let by_one = list!(one.values(Dual(Dual64::new(phi, 1.0))));
        let by_two = list!(two.values(Dual(Dual2_64::new(phi, 1.0, 0.0))));
        let by_crank = list!(longer.values(Dual(Dual64::new(phi, 0.0))));
        close(by_one.map(|x| x.0.re), list!(real.values(phi)), 20.0);
        close(by_one.map(|x| x.0.eps), list!(real.first(phi)), 100.0);
        close(by_two.map(|x| x.0.v2), list!(real.second(phi)), 1000.0);
        close(by_crank.map(|x| x.0.eps), list!(real.by_crank(phi)), 100.0);
    }
}

#[test]
fn single_precision_has_errors_of_single_roundoffs() {
    let real = Everything::default().assemble().expect("closes");
    let single = Everything::default().cast::<f32>();
    let single = single.assemble().expect("closes");
    let ratio = f64::from(f32::EPSILON) / f64::EPSILON;
    for phi in inputs() {
        let phi = phi as f32;
        let (values, first) = (list!(single.values(phi)), list!(single.first(phi)));
        let expected = f64::from(phi);
        close(
            values.map(f64::from),
            list!(real.values(expected)),
            30.0 * ratio,
        );
        close(
            first.map(f64::from),
            list!(real.first(expected)),
            200.0 * ratio,
        );
    }
}

#[test]
fn sweeps_give_the_same() {
    let real = Everything::default().assemble().expect("closes");
    let rows = real.second_sweep(&inputs());
    assert_eq!(rows.len(), 100);
    for (row, phi) in rows.iter().zip(inputs()) {
        close(list!(row), list!(real.second(phi)), 200.0);
    }
}

//! Vector loops in space: three lengths; two lengths and an angle.

use super::LIMITS;
use linkage_reference::{
    Big, Depth, Form, Output, Plan, Position, Space, System, compare, cycle_cases, data, edge,
    far_input_cases, forms, proportion_cases, reach_gap, scale_cases, unknowns, wide_scale_cases,
};
use nalgebra::Vector3;

fn pin(p: &Position) -> Space {
    let pin = p.polar("crank", "phi");
    Space::new(pin.x, pin.y, 0.0)
}

/// The guides in the planes of x and y, and of y and z.
fn guides(p: &Position) -> [Space; 2] {
    let [one, two] = ["one", "two"].map(|name| p.direction(name));
    [Space::new(one.x, one.y, 0.0), Space::new(0.0, two.x, two.y)]
}

/// The third guide, which turns slowly about the z axis.
fn turning(p: &Position) -> Space {
    let slow = (p.value("phi") * Big::from(0.125)).sin_cos();
    let tilt = p.direction("tilt");
    Space::new(&tilt.y * slow.1, &tilt.y * slow.0, tilt.x)
}

const LENGTHS: System = System {
    name: "three lengths",
    data: data! {
        length "crank" 20.0, "base.x" 30.0, "base.y" -15.0, "base.z" 25.0;
        degrees "one" 10.0, "two" 20.0, "tilt" 15.0, "phi" 30.0;
    },
    parameters: 7,
    unknowns: unknowns! {
        slide "s" 10.0, "t" -20.0, "v" 30.0;
    },
    residual: |p| {
        let [one, two] = guides(p);
        let sum = pin(p)
            + one.times(p.slide("s"))
            + two.times(p.slide("t"))
            + turning(p).times(p.slide("v"));
        (sum - p.space("base")).components().to_vec()
    },
    further: |p| {
        let corner = pin(p) + guides(p)[0].times(p.slide("s"));
        Output::lengths(corner.components())
    },
    pairs: &[(0, 4), (5, 6)],
    linear: true,
    ..System::PLAIN
};

macro_rules! lengths {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [s, t, v, corner];
            $($pairs)*
            fields |g| {
                crank: g[0], base: [g[1], g[2], g[3]], one: g[4], two: g[5], tilt: g[6]
            }
            {
                unit mm;
                param crank = 20mm;
                param base = (30mm, -15mm, 25mm);
                param one = 10deg;
                param two = 20deg;
                param tilt = 15deg;
                input phi = 30deg in 0deg..360deg;
                unknown s = 10mm;
                unknown t = -20mm;
                unknown v = 30mm;
                let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
                let corner = pin + s * (cos(one), sin(one), 0);
                let third = turn((sin(tilt), 0, cos(tilt)), (0, 0, 1), phi / 8);
                $($items)*
            }
        }
    };
}

lengths!(sum_of_lengths [pairs crank one, two tilt;] {
    loop corner + t * (0, cos(two), sin(two)) + v * third = base;
});

lengths!(three_scalar_loops [] {
    let end = base - v * third - corner;
    loop end.x = 0;
    loop end.y = t * cos(two);
    loop end.z = t * sin(two);
});

const LENGTHS_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let lengths = [0; 4].map(|_| random.length(spread));
        let angles = [0.2, 0.4, 0.3].map(|centre| centre + random.between(-0.3, 0.3));
        [&lengths[..], &angles[..]].concat()
    },
    dead_points: &[],
};

/// The end of a link that turns about an axis in the plane of x and z.
fn link(p: &Position) -> Space {
    let tilt = p.direction("tilt");
    let x = Space::new(tilt.x, 0.0, -tilt.y);
    Space::in_plane(&p.polar("link", "psi"), &x, &Space::new(0.0, 1.0, 0.0))
}

const ANGLE: System = System {
    name: "two lengths and an angle",
    data: data! {
        length "crank" 15.0, "link" 60.0, "base.x" 30.0, "base.y" -15.0, "base.z" 25.0;
        degrees "one" 10.0, "two" 60.0, "tilt" 25.0, "phi" 30.0;
    },
    parameters: 8,
    unknowns: unknowns! {
        slide "s" 60.0, "t" 10.0;
        angle "psi" 37.0;
    },
    residual: |p| {
        let [one, two] = guides(p);
        let sum = pin(p) + one.times(p.slide("s")) + two.times(p.slide("t"));
        (sum - p.space("base") - link(p)).components().to_vec()
    },
    further: |p| Output::lengths((p.space("base") + link(p)).components()),
    gap: |p| {
        let [one, two] = guides(p);
        let normal = one.cross(&two);
        let tilt = p.direction("tilt");
        let along = normal.dot(&Space::new(tilt.x, 0.0, -tilt.y));
        let reach = (&along * &along + &normal.y * &normal.y).sqrt() * p.value("link");
        reach_gap(&reach, &normal.dot(&(pin(p) - p.space("base"))))
    },
    pairs: &[(1, 7), (5, 6)],
    ..System::PLAIN
};

macro_rules! angle {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [s, t, psi, end];
            $($pairs)*
            fields |g| {
                crank: g[0], link: g[1], base: [g[2], g[3], g[4]], one: g[5], two: g[6],
                tilt: g[7]
            }
            {
                unit mm;
                param crank = 15mm;
                param link = 60mm;
                param base = (30mm, -15mm, 25mm);
                param one = 10deg;
                param two = 60deg;
                param tilt = 25deg;
                input phi = 30deg in 0deg..360deg;
                unknown s = 60mm;
                unknown t = 10mm;
                unknown psi = 37deg;
                let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
                let g1 = (cos(one), sin(one), 0);
                let g2 = (0, cos(two), sin(two));
                let axis = (sin(tilt), 0, cos(tilt));
                $($items)*
            }
        }
    };
}

angle!(sum [pairs link tilt, one two;] {
    let end = base + turn(link * (cos(tilt), 0, -sin(tilt)), axis, psi);
    loop pin + s * g1 + t * g2 = end;
});

angle!(one_side [] {
    let end = base + link * (cos(tilt) * cos(psi), sin(psi), -sin(tilt) * cos(psi));
    loop end - pin - t * g2 - s * g1 = 0;
});

const ANGLE_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let phi = 30f64.to_radians();
        let [crank, link, s, t] = [0; 4].map(|_| random.length(spread));
        let [one, two, tilt, psi] = [0; 4].map(|_| random.angle());
        let [x, y] = [Vector3::new(tilt.cos(), 0.0, -tilt.sin()), Vector3::y()];
        let (g1, g2) = (
            Vector3::new(one.cos(), one.sin(), 0.0),
            Vector3::new(0.0, two.cos(), two.sin()),
        );
        let slope = |psi: f64| g1.cross(&g2).dot(&(psi.cos() * y - psi.sin() * x)) * link;
        let psi = if slope(psi) > 0.0 {
            psi + core::f64::consts::PI
        } else {
            psi
        };
        let pin = Vector3::new(crank * phi.cos(), crank * phi.sin(), 0.0);
        let base = pin + s * g1 + t * g2 - link * (psi.cos() * x + psi.sin() * y);
        vec![crank, link, base.x, base.y, base.z, one, two, tilt]
    },
    dead_points: &[(1, 1e-3), (4, 1e3), (4, -1e3)],
};

const LENGTHS_FORMS: &[Form] = forms![sum_of_lengths, three_scalar_loops];
const ANGLE_FORMS: &[Form] = forms![sum, one_side];

/// The geometries of a system that grow and shrink, beside those of its cycle.
fn all(system: &System, forms: &[Form], plan: &Plan, seed: u64) {
    let cases = cycle_cases(system, plan, 10, seed);
    compare(system, forms, &cases, Depth::Full)
        .at_least(25)
        .check("cycles", &LIMITS);
    let cases = scale_cases(system, plan, 4, seed + 1);
    compare(system, forms, &cases, Depth::Usual)
        .at_least(20)
        .check("scales", &LIMITS);
    let cases = far_input_cases(system, plan, 20, seed + 2);
    compare(system, forms, &cases, Depth::Usual)
        .at_least(20)
        .check("inputs to 1e6 rad", &LIMITS);
    let mut cases = proportion_cases(system, plan, 20, seed + 3);
    cases.extend(wide_scale_cases(system, plan, 4, seed + 4));
    compare(system, forms, &cases, Depth::Usual)
        .at_least(45)
        .check("proportions", &LIMITS.any_proportions());
}

#[test]
fn three_lengths() {
    all(&LENGTHS, LENGTHS_FORMS, &LENGTHS_PLAN, 281);
}

#[test]
fn two_lengths_and_an_angle() {
    all(&ANGLE, ANGLE_FORMS, &ANGLE_PLAN, 291);
}

linkage_reference::sets! { ANGLE, ANGLE_FORMS;
    two_lengths_and_an_angle_dead_points "dead points":
        dead_point_cases(&ANGLE_PLAN, 3, 301), Full, LIMITS, at least 40;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&ANGLE, ANGLE_FORMS, &ANGLE_PLAN, 3, 302).check("two lengths and an angle");
}

//! PRP and RPP: two slides along known directions, at rest or moving; the loops are linear.

use linkage_reference::{
    Big, Case, Depth, Form, Limits, Output, Plan, Plane, Position, Random, System, Unknown,
    compare, cycle_cases, data, forms, proportion_cases, scale_cases,
};

const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 30.0, 30.0]);

const TWO_SLIDES: System = System {
    name: "two slides",
    data: data! {
        length "crank" 30.0, "pivot.x" 20.0, "pivot.y" -15.0;
        degrees "alpha" 10.0, "beta" 100.0;
        ratio "ratio" 0.1;
        degrees "phi" 30.0;
    },
    parameters: 6,
    unknowns: &[Unknown::slide("s", 10.0), Unknown::slide("t", 10.0)],
    residual: |p| {
        let turned = Plane::direction(&guide_angle(p));
        let closure = p.polar("crank", "phi") + p.direction("alpha").times(p.slide("s"))
            - p.point("pivot")
            - turned.times(p.slide("t"));
        vec![closure.x, closure.y]
    },
    further: |p| {
        let pin = p.polar("crank", "phi") + p.direction("alpha").times(p.slide("s"));
        Output::lengths([pin.x, pin.y])
    },
    turned: guide_angle,
    pairs: &[(0, 3), (4, 5)],
    linear: true,
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

fn guide_angle(p: &Position) -> Big {
    p.value("beta") + p.value("ratio") * p.value("phi")
}

macro_rules! two_slides {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [s, t, pin];
            pairs crank alpha, beta ratio;
            fields |g| {
                crank: g[0], pivot: [g[1], g[2]], alpha: g[3], beta: g[4], ratio: g[5]
            }
            {
                unit mm;
                param crank = 30mm;
                param pivot = (20mm, -15mm);
                param alpha = 10deg;
                param beta = 100deg;
                param ratio = 0.1;
                input phi = 30deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

two_slides!(plain {
    unknown s = -10mm;
    unknown t = 30mm;
    let pin = polar(crank, phi) + s * dir(alpha);
    loop polar(crank, phi) + s * dir(alpha) = pivot + t * dir(beta + ratio * phi);
});

two_slides!(other_order {
    unknown t = 30mm;
    unknown s = -10mm;
    let guide = beta + ratio * phi;
    let pin = pivot + polar(t, guide);
    loop rotate((t, 0), guide) + pivot - rotate((crank, 0), phi) - dir(alpha) * s = 0;
});

two_slides!(negative_slides {
    unknown back = 10mm;
    unknown forth = -30mm;
    let s = -back;
    let t = -forth;
    let guide = beta + ratio * phi;
    let pin = polar(crank, phi) - polar(back, alpha);
    loop pin - pivot = polar(forth, guide + 180deg);
});

two_slides!(components {
    unknown s = -10mm;
    unknown t = 30mm;
    let guide = beta + ratio * phi;
    let pin = polar(crank, phi) + polar(s, alpha);
    loop pin.x - t * cos(guide) = pivot.x;
    loop pivot.y + t * sin(guide) = pin.y;
});

two_slides!(across_each {
    unknown s = -10mm;
    unknown t = 30mm;
    let guide = dir(beta + ratio * phi);
    let a = polar(crank, phi);
    let pin = a + s * dir(alpha);
    loop cross(guide, pin - pivot) = 0;
    loop cross(dir(alpha), pivot + t * guide - a) = 0;
});

two_slides!(unknown_point {
    unknown pin = (15mm, 15mm);
    let guide = dir(beta + ratio * phi);
    let a = polar(crank, phi);
    loop cross(dir(alpha), pin - a) = 0;
    loop cross(guide, pin - pivot) = 0;
    let s = dot(dir(alpha), pin - a);
    let t = dot(guide, pin - pivot);
});

fn geometry(random: &mut Random, spread: f64, opening: f64) -> Vec<f64> {
    let [crank, x, y] = [0; 3].map(|_| random.length(spread));
    let (alpha, ratio) = (random.angle(), random.between(-1.0, 1.0));
    let beta = alpha + opening - ratio * 30f64.to_radians();
    vec![crank, x, y, alpha, beta, ratio]
}

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let opening = random.between(0.1, 3.0);
        geometry(random, spread, opening)
    },
    dead_points: &[],
};

const FORMS: &[Form] = forms![plain, other_order, negative_slides, components, across_each,];

/// The unknown point's coordinates stand for the slides; its margin is one of its own equations.
const TWO_LINES: System = System { ..TWO_SLIDES };

const POINT: &[Form] = forms![unknown_point];

#[test]
fn cycles() {
    let cases = cycle_cases(&TWO_SLIDES, &PLAN, 30, 31);
    compare(&TWO_SLIDES, FORMS, &cases, Depth::Full).check("cycles", &LIMITS);
    compare(&TWO_LINES, POINT, &cases, Depth::Full).check("cycles", &LIMITS);
}

/// Guides that are parallel but for angles down to 1e-12; the uncertainty grows as their inverse.
#[test]
fn nearly_parallel_guides() {
    let mut random = Random::new(32);
    let case = |decade: i32| {
        let geometry = geometry(&mut random, 6.0, 10f64.powi(-decade));
        Case::new(geometry, vec![TWO_SLIDES.reference_input()])
    };
    let cases: Vec<Case> = (1..=12).chain(1..=12).map(case).collect();
    compare(&TWO_SLIDES, FORMS, &cases, Depth::Full).check("nearly parallel guides", &LIMITS);
    compare(&TWO_LINES, POINT, &cases, Depth::Full).check("nearly parallel guides", &LIMITS);
}

#[test]
fn proportions_and_scales() {
    let mut cases = proportion_cases(&TWO_SLIDES, &PLAN, 20, 33);
    cases.extend(scale_cases(&TWO_SLIDES, &PLAN, 6, 34));
    compare(&TWO_SLIDES, FORMS, &cases, Depth::Full)
        .check("proportions and scales", &LIMITS.any_proportions());
    compare(&TWO_LINES, POINT, &cases, Depth::Full)
        .check("proportions and scales", &LIMITS.any_proportions());
}

// Hostile sets: guides all but parallel, a crank and a pivot all but in one place, far inputs.

fn parallel(random: &mut Random, angle: f64) -> Vec<f64> {
    geometry(random, 6.0, angle)
}

fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let opening = random.between(0.1, 3.0);
    let mut geometry = geometry(random, 6.0, opening);
    let (crank, phi) = (geometry[0], 30f64.to_radians());
    let near = |random: &mut Random, x: f64| x + ratio * random.length(6.0);
    geometry[1] = near(random, crank * phi.cos());
    geometry[2] = near(random, crank * phi.sin());
    geometry
}

linkage_reference::sets! { TWO_SLIDES, FORMS;
    parallel_guides "guides to 1e-15 rad parallel": decade_cases(parallel, 6, 131), Usual, LIMITS;
    coincident_pivots "coincident pivots":
        decade_cases(near_pivots, 6, 132), Usual, LIMITS.any_proportions();
    far_inputs "inputs to 1e6 rad": far_input_cases(&PLAN, 60, 133), Usual, LIMITS;
    extreme_scales_and_proportions "sizes 1e-140 to 1e140, ratios to 1e8":
        wide_scale_cases(&PLAN, 8, 134), Usual, LIMITS.any_proportions();
}

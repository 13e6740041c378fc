//! RPR: a slider along a line that is fixed in a turning link.

use linkage_reference::{
    Case, Depth, Form, Limits, Output, Plan, Random, System, Unknown, compare, cycle_cases, data,
    dead_point_cases, edge, forms, proportion_cases, reach_gap, scale_cases,
};

/// The margin is a quotient of two numbers, each as wrong as a value may be.
const LIMITS: Limits = Limits::new([10.0, 10.0, 20.0], [30.0, 100.0, 100.0]);

const SWINGING_BLOCK: System = System {
    name: "swinging block",
    data: data! {
        length "pivot.x" 80.0, "pivot.y" -20.0, "crank" 30.0, "offset" 10.0;
        degrees "beta" 80.0, "phi" 40.0;
    },
    parameters: 5,
    unknowns: &[Unknown::angle("psi", 137.0), Unknown::slide("s", 66.8)],
    residual: |p| {
        let offset = p.polar("offset", "psi").turned(&p.direction("beta"));
        let slide = p.direction("psi").times(p.slide("s"));
        let closure = p.point("pivot") + offset + slide - p.polar("crank", "phi");
        vec![closure.x, closure.y]
    },
    further: |p| {
        let corner = p.point("pivot") + p.polar("offset", "psi").turned(&p.direction("beta"));
        Output::lengths([corner.x, corner.y])
    },
    gap: |p| {
        let known = p.polar("crank", "phi") - p.point("pivot");
        reach_gap(&known.norm(), &p.polar("offset", "beta").y)
    },
    pairs: &[(2, 3), (4, 4)],
    margin: Some(|p| {
        // The angle's column has the length of what the guide spans; the largest distance is that with the crank in line.
        let spanned = (p.polar("crank", "phi") - p.point("pivot")).norm();
        let longest = p.value("crank").abs() + p.point("pivot").norm();
        let offset = p.polar("offset", "beta").y.abs();
        let largest = (&longest - &offset) * (&longest + &offset);
        spanned / largest.sqrt()
    }),
    ..System::PLAIN
};

macro_rules! swinging_block {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [psi, s, corner];
            pairs crank offset, beta beta;
            fields |g| { pivot: [g[0], g[1]], crank: g[2], offset: g[3], beta: g[4] }
            {
                unit mm;
                param pivot = (80mm, -20mm);
                param crank = 30mm;
                param offset = 10mm;
                param beta = 80deg;
                input phi = 40deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

swinging_block!(plain {
    unknown psi = 137deg;
    unknown s = 66.8mm;
    let corner = pivot + polar(offset, psi + beta);
    loop pivot + polar(offset, psi + beta) + s * dir(psi) = polar(crank, phi);
});

swinging_block!(slide_first {
    unknown s = 66.8mm;
    unknown psi = 137deg;
    let corner = pivot + rotate(polar(offset, beta), psi);
    loop rotate((crank, 0), phi) - rotate(polar(offset, beta) + (s, 0), psi) = pivot;
});

swinging_block!(bound_angle {
    unknown link = 217deg;
    unknown s = 66.8mm;
    let psi = link - beta;
    let corner = pivot + polar(offset, link);
    loop corner + polar(s, psi) - polar(crank, phi) = 0;
});

swinging_block!(negative_slide {
    unknown t = -66.8mm;
    unknown psi = 137deg;
    let s = -t;
    let corner = pivot - polar(offset, psi + beta + 180deg);
    loop polar(crank, phi) + t * dir(psi) = corner;
});

swinging_block!(half_turn {
    unknown back = -43deg;
    unknown s = 66.8mm;
    let psi = back + 180deg;
    let square = back + 90deg;
    let corner = pivot - polar(offset, back + beta);
    loop pivot - rotate(polar(offset, beta - 90deg), square) - polar(s, back) = polar(crank, phi);
});

swinging_block!(components {
    unknown psi = 137deg;
    unknown s = 66.8mm;
    let corner = pivot + polar(offset, psi + beta);
    let pin = corner + polar(s, psi);
    loop pin.x = crank * cos(phi);
    loop pin.y - crank * sin(phi) = 0;
});

swinging_block!(one_angle {
    unknown psi = 137deg;
    let corner = pivot + polar(offset, psi + beta);
    let reach = polar(crank, phi) - pivot;
    loop cross(dir(psi), reach) = offset * sin(beta);
    let s = dot(dir(psi), reach) - offset * cos(beta);
});

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let [crank, offset] = [0; 2].map(|_| random.length(spread));
        // An offset along the line is a slide by another name: derivatives by it all but vanish.
        let beta = random.between(0.3, 2.8) * if random.chance(0.5) { 1.0 } else { -1.0 };
        let psi = random.angle();
        // The slide from the foot of the offset is positive in this assembly mode.
        let s = random.length(spread).abs() - offset * beta.cos();
        let phi = 40f64.to_radians();
        let x = crank * phi.cos() - s * psi.cos() - offset * (psi + beta).cos();
        let y = crank * phi.sin() - s * psi.sin() - offset * (psi + beta).sin();
        vec![x, y, crank, offset, beta]
    },
    dead_points: &[(3, 1e3), (3, -1e3)],
};

const FORMS: &[Form] = forms![
    plain,
    slide_first,
    negative_slide,
    half_turn,
    components,
    one_angle
];

/// The unknown is the direction of the offset, which a short one hardly shows: derivatives by the
/// offset and its angle are then small differences.
const BOUND: &[Form] = forms![; where |g| g[3].abs() > 0.3 * g[0].hypot(g[1]) => bound_angle];

fn check(set: &str, cases: &[Case], limits: &Limits) {
    compare(&SWINGING_BLOCK, FORMS, cases, Depth::Full).check(set, limits);
    compare(&SWINGING_BLOCK, BOUND, cases, Depth::Full).check(set, &limits.times(10.0));
}

#[test]
fn swinging_block_cycles() {
    let cases = cycle_cases(&SWINGING_BLOCK, &PLAN, 30, 21);
    check("cycles", &cases, &LIMITS);
}

#[test]
fn swinging_block_dead_points() {
    let cases = dead_point_cases(&SWINGING_BLOCK, &PLAN, 10, 22);
    check("dead points", &cases, &LIMITS);
}

#[test]
fn swinging_block_proportions() {
    let cases = proportion_cases(&SWINGING_BLOCK, &PLAN, 30, 23);
    check("proportions", &cases, &LIMITS.any_proportions());
}

#[test]
fn swinging_block_scales() {
    let cases = scale_cases(&SWINGING_BLOCK, &PLAN, 8, 24);
    check("scales", &cases, &LIMITS);
}

// Hostile sets: short offsets, coincident pivots, far inputs, both sides of the dead point.

/// Closed at the reference input; the slide counts from the foot of the offset.
fn closed(random: &mut Random, crank: f64, offset: f64, from_foot: f64) -> Vec<f64> {
    let beta = random.between(0.3, 2.8) * if random.chance(0.5) { 1.0 } else { -1.0 };
    let psi = random.angle();
    let s = from_foot - offset * beta.cos();
    let phi = 40f64.to_radians();
    let x = crank * phi.cos() - s * psi.cos() - offset * (psi + beta).cos();
    let y = crank * phi.sin() - s * psi.sin() - offset * (psi + beta).sin();
    vec![x, y, crank, offset, beta]
}

fn short_offset(random: &mut Random, ratio: f64) -> Vec<f64> {
    let [crank, from_foot] = [0; 2].map(|_| random.length(6.0));
    let offset = ratio * random.length(6.0);
    closed(random, crank, offset, from_foot.abs())
}

/// Offset and slide are short beside the crank, or all three of them beside nothing.
fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let crank = random.length(6.0) * if random.chance(0.5) { ratio } else { 1.0 };
    let [offset, from_foot] = [0; 2].map(|_| ratio * random.length(6.0));
    closed(random, crank, offset, from_foot.abs())
}

linkage_reference::sets! { SWINGING_BLOCK, FORMS;
    short_offsets "short offsets":
        decade_cases(short_offset, 6, 121), Usual, LIMITS.any_proportions();
    coincident_pivots "coincident pivots":
        decade_cases(near_pivots, 8, 122), Usual, LIMITS.any_proportions();
    far_inputs "inputs to 1e6 rad": far_input_cases(&PLAN, 40, 123), Usual, LIMITS;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&SWINGING_BLOCK, FORMS, &PLAN, 5, 124).check("swinging block");
}

linkage_reference::sets! { SWINGING_BLOCK, FORMS;
    extreme_scales_and_proportions "sizes 1e-140 to 1e140, ratios to 1e8":
        wide_scale_cases(&PLAN, 8, 125), Usual, LIMITS.any_proportions();
}

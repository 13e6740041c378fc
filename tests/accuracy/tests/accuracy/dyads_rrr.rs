//! RRR: two links between two known points.

use linkage_reference::{
    Depth, Form, Limits, Output, Plan, Random, System, Unknown, compare, data, decade_cases, edge,
    forms, proportion_cases, triangle_gap, wide_scale_cases,
};

const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 100.0, 100.0]);

const FOUR_BAR: System = System {
    name: "four-bar",
    data: data! {
        length "pivot_d.x" 140.0, "pivot_d.y" 0.0, "crank" 50.0, "coupler" 120.0, "rocker" 100.0,
            "arm" 70.0;
        degrees "lift" 25.0, "phi" 30.0;
    },
    parameters: 7,
    unknowns: &[Unknown::angle("theta", 40.0), Unknown::angle("psi", 80.0)],
    residual: |p| {
        let closure = p.polar("crank", "phi") + p.polar("coupler", "theta")
            - p.polar("rocker", "psi")
            - p.point("pivot_d");
        vec![closure.x, closure.y]
    },
    further: |p| {
        let arm = p.polar("arm", "theta").turned(&p.direction("lift"));
        let tracer = p.polar("crank", "phi") + arm;
        Output::lengths([tracer.x, tracer.y])
    },
    gap: |p| {
        let known = p.point("pivot_d") - p.polar("crank", "phi");
        triangle_gap(p.value("coupler"), p.value("rocker"), &known.norm())
    },
    pairs: &[(2, 4), (3, 3)],
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

macro_rules! four_bar {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [theta, psi, tracer];
            pairs crank rocker, coupler coupler;
            fields |g| {
                pivot_d: [g[0], g[1]], crank: g[2], coupler: g[3], rocker: g[4],
                arm: g[5], lift: g[6]
            }
            {
                unit mm;
                param pivot_d = (140mm, 0mm);
                param crank = 50mm;
                param coupler = 120mm;
                param rocker = 100mm;
                param arm = 70mm;
                param lift = 25deg;
                input phi = 30deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

four_bar!(plain {
    const pivot_a = (0mm, 0mm);
    unknown theta = 40deg;
    unknown psi = 80deg;
    let a = pivot_a + polar(crank, phi);
    loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
    let tracer = a + polar(arm, theta + lift);
});

four_bar!(one_side {
    unknown psi = 80deg;
    unknown theta = 40deg;
    let crank_pin = rotate((crank, 0), phi);
    loop pivot_d + rotate((rocker, 0mm), psi) - polar(coupler, theta) - crank_pin = 0;
    let tracer = crank_pin + rotate(polar(arm, lift), theta);
});

four_bar!(directions {
    unknown theta = 40deg;
    unknown psi = 80deg;
    let a = dir(phi) * crank;
    loop -(a + dir(theta) * coupler) = dir(psi + 180deg) * rocker - pivot_d;
    let tracer = a + dir(lift + theta) * arm;
});

four_bar!(quarter_turn {
    unknown theta = 40deg;
    unknown psi = 80deg;
    let square = theta + 90deg;
    let a = polar(crank, phi);
    loop a - pivot_d = polar(rocker, psi) + polar(coupler, square + PI / 2);
    let tracer = a + polar(arm, square - 90deg + lift);
});

four_bar!(components {
    unknown theta = 40deg;
    unknown psi = 80deg;
    let a = polar(crank, phi);
    let left = a + polar(coupler, theta);
    let right = pivot_d + polar(rocker, psi);
    loop left.x = right.x;
    loop right.y - left.y = 0;
    let tracer = a + polar(arm, theta + lift);
});

four_bar!(sines_and_cosines {
    unknown theta = 40deg;
    unknown psi = 80deg;
    loop crank * cos(phi) + coupler * cos(theta) - rocker * cos(psi) = pivot_d.x;
    loop crank * sin(phi) + coupler * sin(theta) - rocker * sin(psi) = pivot_d.y;
    let tracer = (
        crank * cos(phi) + arm * cos(theta + lift),
        crank * sin(phi) + arm * sin(theta + lift),
    );
});

four_bar!(unknown_point {
    unknown b = (142mm, 102mm);
    let a = polar(crank, phi);
    loop distance(a, b) = coupler;
    loop distance(b, pivot_d) = rocker;
    let theta = angle(b - a);
    let psi = angle(b - pivot_d);
    let tracer = a + rotate(b - a, lift) * (arm / coupler);
});

four_bar!(one_distance {
    unknown psi = 80deg;
    let a = polar(crank, phi);
    let b = pivot_d + polar(rocker, psi);
    loop distance(a, b) = coupler;
    let theta = angle(b - a);
    let tracer = a + polar(arm, theta + lift);
});

four_bar!(relative_angle {
    unknown theta = 40deg;
    unknown bend = 40deg;
    let psi = theta + bend;
    let a = polar(crank, phi);
    loop a + polar(coupler, theta) = pivot_d + polar(rocker, theta + bend);
    let tracer = a + polar(arm, theta + lift);
});

four_bar!(two_terms {
    unknown theta = 40deg;
    unknown psi = 80deg;
    let a = polar(crank, phi);
    let tracer = a + polar(arm, theta + lift);
    loop tracer + polar(coupler, theta) - polar(arm, theta + lift) = pivot_d + polar(rocker, psi);
});

const FOUR_BAR_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let lengths = [0; 4].map(|_| random.length(spread));
        let [crank, coupler, rocker, arm] = lengths;
        let theta = random.angle();
        let bend = random.between(0.05, 3.1);
        // A negative length turns its link by half a turn, and so the mode.
        let psi = if coupler * rocker < 0.0 {
            theta - bend
        } else {
            theta + bend
        };
        let phi = 30f64.to_radians();
        let x = crank * phi.cos() + coupler * theta.cos() - rocker * psi.cos();
        let y = crank * phi.sin() + coupler * theta.sin() - rocker * psi.sin();
        vec![x, y, crank, coupler, rocker, arm, random.angle()]
    },
    dead_points: &[(3, 40.0), (3, 0.01), (4, 40.0), (4, 0.01)],
};

const FORMS: &[Form] = forms![
    plain, one_side, directions, quarter_turn, components, sines_and_cosines, relative_angle,
    two_terms;
    where |g| g[3] > 0.0 && g[4] > 0.0 => unknown_point, one_distance
];

/// How many of them come before those with an unknown point or a distance.
const FITTING: usize = 8;

linkage_reference::sets! { FOUR_BAR, FORMS;
    four_bar_cycles "cycles": cycle_cases(&FOUR_BAR_PLAN, 30, 1), Full, LIMITS;
    four_bar_dead_points "dead points": dead_point_cases(&FOUR_BAR_PLAN, 8, 2), Full, LIMITS;
}

#[test]
fn four_bar_proportions() {
    let cases = proportion_cases(&FOUR_BAR, &FOUR_BAR_PLAN, 30, 3);
    let (fitting, points) = FORMS.split_at(FITTING);
    compare(&FOUR_BAR, fitting, &cases, Depth::Full)
        .check("proportions", &LIMITS.any_proportions());
    compare(&FOUR_BAR, points, &cases, Depth::Full)
        .check("proportions", &LIMITS.any_proportions().times(25.0));
}

linkage_reference::sets! { FOUR_BAR, FORMS;
    four_bar_scales "scales": scale_cases(&FOUR_BAR_PLAN, 8, 4), Full, LIMITS;
}

// Hostile sets: needle triangles, coincident pivots, far inputs, both sides of the dead point.

const PHI: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// The geometry with these links, closed at the reference input.
fn closed(random: &mut Random, [coupler, rocker]: [f64; 2], [theta, psi]: [f64; 2]) -> Vec<f64> {
    let [crank, arm] = [0; 2].map(|_| random.length(6.0));
    let x = crank * PHI.cos() + coupler * theta.cos() - rocker * psi.cos();
    let y = crank * PHI.sin() + coupler * theta.sin() - rocker * psi.sin();
    vec![x, y, crank, coupler, rocker, arm, random.angle()]
}

fn bent(random: &mut Random, links: [f64; 2]) -> Vec<f64> {
    let theta = random.angle();
    let psi = theta + random.between(0.05, 3.1);
    closed(random, links, [theta, psi])
}

fn short_coupler(random: &mut Random, ratio: f64) -> Vec<f64> {
    let rocker = random.length(6.0).abs();
    bent(random, [ratio * rocker, rocker])
}

fn short_rocker(random: &mut Random, ratio: f64) -> Vec<f64> {
    let coupler = random.length(6.0).abs();
    bent(random, [coupler, ratio * coupler])
}

/// The crank pin and the rocker's pivot at a distance of `ratio` times the rocker. Of every second
/// geometry the crank is as short as that, so that the distance is known to all digits.
fn near_pivots(random: &mut Random, ratio: f64) -> Vec<f64> {
    let rocker = random.length(6.0).abs();
    let (psi, across) = (random.angle(), -random.between(0.05, 3.09));
    let distance = ratio * rocker;
    let shift = [(psi + across).cos(), (psi + across).sin()].map(|x| distance * x);
    let coupler = rocker + distance * (across.cos() + ratio * across.sin().powi(2) / 2.0);
    let crank = random.length(6.0) * if random.chance(0.5) { ratio } else { 1.0 };
    let x = crank * PHI.cos() + shift[0];
    let y = crank * PHI.sin() + shift[1];
    vec![
        x,
        y,
        crank,
        coupler,
        rocker,
        random.length(6.0),
        random.angle(),
    ]
}

#[test]
fn needle_triangles() {
    let mut cases = decade_cases(&FOUR_BAR, short_coupler, 4, 101);
    cases.extend(decade_cases(&FOUR_BAR, short_rocker, 4, 102));
    let (fitting, points) = FORMS.split_at(FITTING);
    let limits = LIMITS.any_proportions();
    compare(&FOUR_BAR, fitting, &cases, Depth::Usual).check("needle triangles", &limits);
    let limits = limits.times(25.0);
    compare(&FOUR_BAR, points, &cases, Depth::Usual).check("needles, unknown point", &limits);
}

#[test]
fn coincident_pivots() {
    let cases = decade_cases(&FOUR_BAR, near_pivots, 8, 103);
    let limits = LIMITS.any_proportions();
    compare(&FOUR_BAR, FORMS, &cases, Depth::Usual).check("coincident pivots", &limits);
}

linkage_reference::sets! { FOUR_BAR, FORMS;
    far_inputs "inputs to 1e6 rad": far_input_cases(&FOUR_BAR_PLAN, 40, 104), Usual, LIMITS;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&FOUR_BAR, FORMS, &FOUR_BAR_PLAN, 3, 105).check("four-bar");
}

#[test]
fn extreme_scales_and_proportions() {
    let cases = wide_scale_cases(&FOUR_BAR, &FOUR_BAR_PLAN, 8, 106);
    let (fitting, _) = FORMS.split_at(FITTING);
    let report = compare(&FOUR_BAR, fitting, &cases, Depth::Usual);
    report.check(
        "sizes 1e-140 to 1e140, ratios to 1e8",
        &LIMITS.any_proportions(),
    );
}

//! The comparison itself: it accepts a good program and notices every kind of bad one.

use linkage_reference::{
    Answers, Depth, Evaluate, Form, Limits, Measure, Output, Plan, Report, System, Unknown,
    Variant, compare, cycle_cases, data, dead_point_cases, proportion_cases, scale_cases,
    triangle_gap,
};

const TRIANGLE: System = System {
    name: "triangle",
    data: data! {
        length "left" 3.0, "right" 4.0, "base" 5.0;
        degrees "phi" 30.0;
    },
    parameters: 3,
    unknowns: &[Unknown::angle("theta", 80.0), Unknown::angle("psi", 350.0)],
    residual: |p| {
        let closure = p.polar("left", "theta") + p.polar("right", "psi") - p.polar("base", "phi");
        vec![closure.x, closure.y]
    },
    further: |p| {
        let tip = p.polar("left", "theta");
        Output::lengths([tip.x, tip.y])
    },
    gap: |p| triangle_gap(p.value("left"), p.value("right"), &p.value("base").abs()),
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let (left, right) = (random.length(spread).abs(), random.length(spread).abs());
        let bend = random.between(0.05, 3.1);
        vec![
            left,
            right,
            f64::hypot(left + right * bend.cos(), right * bend.sin()),
        ]
    },
    dead_points: &[(2, 20.0), (2, 0.001)],
};

/// The triangle from its smaller circle, as far as its orientation by the input, on the side of the
/// base that `side` says; `disturb` spoils it.
fn triangle(g: &[f64], input: f64, side: f64, disturb: fn(&mut Answers)) -> Answers {
    let scale = 2f64.powi(-(g[2].abs().log2().round() as i32));
    let [r1, r2, l] = [g[0], g[1], g[2]].map(|length| length.abs() * scale);
    let (small, large) = (r1.min(r2), r1.max(r2));
    let square = l * l;
    let n = square / 2.0 - (large - small) * (large + small) / 2.0;
    let root = (small * l + n) * (small * l - n);
    let height = if root < 0.0 && root > -1e-14 * small * small * square {
        0.0
    } else {
        root.sqrt()
    };
    // Along and across the base, from the end of the smaller link.
    let (along, across) = (n / l, side * height / l);
    let (tip, slope) = if r1 <= r2 {
        (along, 1.0)
    } else {
        (l - along, 1.0)
    };
    let (sine, cosine) = input.sin_cos();
    let theta = f64::atan2(slope * across, tip) + input;
    let psi = f64::atan2(-across, l - tip) + input;
    let x = (tip * cosine - across * sine) / scale;
    let y = (tip * sine + across * cosine) / scale;
    let nan = if height.is_nan() { f64::NAN } else { 1.0 };
    let mut answers = Answers {
        values: vec![theta * nan, psi * nan, x, y],
        margin: height / (r1 * r2),
        first: vec![nan, nan, -y, x],
        second: vec![0.0 * nan, 0.0 * nan, -x, -y],
        third: vec![0.0 * nan, 0.0 * nan, y, -x],
        ..Answers::default()
    };
    disturb(&mut answers);
    answers
}

fn form(assemble: fn(&[f64], Variant) -> Result<Evaluate, String>) -> Form {
    Form {
        name: "program",
        assemble,
        fits: |_| true,
    }
}

macro_rules! program {
    (|$answers:ident| $disturb:expr) => {
        form(|g, variant| {
            let side = if variant.flipped { -1.0 } else { 1.0 };
            let g = g.to_vec();
            let sound = g[2].abs() * (1.0 - 1e-14) <= g[0].abs() + g[1].abs()
                && g[2].abs() * (1.0 + 1e-14) >= (g[0].abs() - g[1].abs()).abs();
            let evaluate: Evaluate =
                Box::new(move |input| triangle(&g, input, side, |$answers| $disturb));
            if sound {
                Ok(evaluate)
            } else {
                Err("apart".into())
            }
        })
    };
}

const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [10.0, 10.0, 10.0]);

fn run(form: Form) -> Report {
    compare(
        &TRIANGLE,
        &[form],
        &cycle_cases(&TRIANGLE, &PLAN, 10, 7),
        Depth::Full,
    )
}

#[test]
fn accepts_a_good_program() {
    let good = program!(|_answers| {});
    run(good).check("driver", &LIMITS);
    for cases in [
        dead_point_cases(&TRIANGLE, &PLAN, 10, 8),
        proportion_cases(&TRIANGLE, &PLAN, 30, 9),
        scale_cases(&TRIANGLE, &PLAN, 5, 10),
    ] {
        compare(&TRIANGLE, &[good], &cases, Depth::Full).check("accepts a good program", &LIMITS);
    }
}

#[test]
fn notices_errors_of_some_roundoffs() {
    let report = run(program!(|a| a.values[2] += 1e-12));
    assert!(report.largest(Measure::Position) > 10.0);
    let report = run(program!(|a| a.first[3] *= 1.0 + 1e-13));
    assert!(report.largest(Measure::First) > 50.0);
    let report = run(program!(|a| a.margin += 1e-14));
    assert!(report.largest(Measure::Margin) > 10.0);
}

#[test]
#[should_panic(expected = "wrong assembly mode")]
fn notices_the_wrong_mode() {
    run(program!(|a| a.values.swap(0, 1))).check("driver", &LIMITS);
}

#[test]
#[should_panic(expected = "NaN although assembled")]
fn notices_a_needless_nan() {
    run(program!(|a| a.values[1] = f64::NAN)).check("driver", &LIMITS);
}

#[test]
#[should_panic(expected = "Third")]
fn notices_a_missing_derivative() {
    run(program!(|a| a.third[2] = f64::NAN)).check("driver", &LIMITS);
}

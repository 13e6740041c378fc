//! Pieces and splines over a turn.

use std::f64::consts::TAU;

use linkage::Dual;
use linkage_random::Random;
use num_dual::Dual64;

use super::{Courses, LAWS, Reference, courses, laws, radians, references};

/// From which knot to which one, from which value to which one, by which of [`LAWS`]; none where it rests.
const PIECES: [(f64, f64, f64, f64, Option<usize>); 11] = [
    (0.0, 40.0, 2.0, 2.0, None),
    (40.0, 90.0, 2.0, 20.0, Some(6)),
    (90.0, 120.0, 20.0, 20.0, None),
    (120.0, 160.0, 20.0, 9.0, Some(2)),
    (160.0, 200.0, 9.0, 12.0, Some(7)),
    (200.0, 220.0, 12.0, 10.0, Some(5)),
    (220.0, 225.0, 10.0, 10.0, None),
    (225.0, 260.0, 10.0, 6.0, Some(3)),
    (260.0, 300.0, 6.0, 4.0, Some(0)),
    (300.0, 330.0, 4.0, 3.0, Some(4)),
    (330.0, 360.0, 3.0, 2.0, Some(1)),
];

/// Each piece is its law, at its knots from both sides, in its middle, and turns later.
#[test]
fn pieces_are_their_laws() {
    let mut worst: f64 = 0.0;
    for (from, to, before, behind, law) in PIECES {
        let [begin, end]: [f64; 2] = [from, to].map(radians);
        let width = end - begin;
        for part in [0.0, 0.2, 0.5, 0.77, 1.0] {
            let phi: f64 = if part == 1.0 {
                end.next_down()
            } else {
                begin + part * width
            };
            // Where a piece begins within rounding, its law does; it ends with its last number.
            let x = ((phi - begin) / width).max(0.0).min(1.0_f64.next_down());
            let shape = law.map_or([0.0; 4], |law| laws(x).map(|own| own[law]));
            let sizes = law.map_or([0.0; 4], |law| LAWS[law].1);
            for turns in [0.0, 1.0, -3.0, 40.0] {
                let moved = phi + turns * TAU;
                // Where rounding leads across a knot, the next piece counts.
                if turns != 0.0 && (part == 0.0 || part == 1.0) {
                    continue;
                }
                let found = courses(moved).map(|own| own[0]);
                for order in 0..4 {
                    let scale = (behind - before) / width.powi(order as i32);
                    let base = if order == 0 { before } else { 0.0 };
                    let error = (found[order] - (base + scale * shape[order])).abs();
                    let size = if order == 0 { 1.0 } else { sizes[order - 1] };
                    // What rounding of the place does; turns are rounded, too.
                    let wound = if turns == 0.0 {
                        0.0
                    } else {
                        (phi + moved.abs()) / width
                    };
                    let rounding = f64::EPSILON * (2.0 + wound);
                    let of_place = rounding * sizes[order] * scale.abs();
                    let roundoff = f64::EPSILON
                        * (20.0 * f64::from(u8::from(order == 0)) + scale.abs() * size);
                    worst = worst.max(error / (of_place + 2.0 * roundoff));
                    assert!(
                        error <= of_place + 2.0 * roundoff,
                        "order {order} at {moved}: {error:e} {roundoff:e}"
                    );
                }
            }
        }
    }
    println!("pieces: {worst:.2} of what is allowed");
}

#[test]
fn courses_without_a_period_end_and_others_do_not() {
    let at = |degrees: f64| courses(radians(degrees));
    for degrees in [-1000.0, 0.0, 29.0, 181.0, 390.0] {
        assert_eq!(
            at(degrees).map(|own| own[1]),
            [2.0, 0.0, 0.0, 0.0],
            "{degrees}"
        );
    }
    let [before, behind] = [30.0, 250.0].map(at);
    let [natural, clamped] = [3, 4];
    // Straight on, and level.
    assert_eq!(
        (before[2][natural], before[3][natural], before[1][clamped]),
        (0.0, 0.0, 0.0)
    );
    let further = at(300.0);
    let straight = behind[0][natural] + behind[1][natural] * radians(50.0);
    assert!((further[0][natural] - straight).abs() < 1e-13);
    assert_eq!((further[0][clamped], further[1][clamped]), (1.0, 0.0));
    // A period that is no turn.
    for degrees in [15.0, 37.0, 88.0] {
        let [here, later] = [degrees, degrees + 240.0].map(at);
        for order in 0..4 {
            let size = here[order][5].abs().max(1.0);
            assert!(
                (here[order][5] - later[order][5]).abs() < 1e-12 * size,
                "{degrees} {order}"
            );
        }
    }
    assert!(at(f64::NAN)[..2].as_flattened().iter().all(|x| x.is_nan()));
}

#[test]
fn splines_have_fifteen_digits() {
    // Where each stands among the courses, and the largest values of it and its derivatives, by degrees.
    let splines = [
        ("spline", 2, [12.3, 0.21, 0.0056, 2.6e-4, 0.0]),
        ("quintic", 6, [12.3, 0.21, 0.0056, 2.5e-4, 1.5e-5]),
        ("sloped", 7, [12.2, 0.22, 0.0073, 6.5e-4, 1.2e-4]),
    ];
    let mut worst = [[0.0_f64; 4]; 3];
    let mut count = 0;
    for Reference {
        law,
        at,
        side,
        values,
    } in references()
    {
        let Some(spline) = splines.iter().position(|own| own.0 == law) else {
            continue;
        };
        let (_, place_of, sizes) = splines[spline];
        count += 1;
        let place = radians(at);
        let place = if side == "left" {
            if at == 0.0 { -1e-15 } else { place.next_down() }
        } else {
            place
        };
        let found = courses(place).map(|own| own[place_of]);
        let mut per = 1.0;
        for order in 0..4 {
            let error = (found[order] * per - values[order]).abs();
            // Degrees are rounded when they become radians.
            let of_place = 2.0 * f64::EPSILON * at * sizes[order + 1];
            let worst = &mut worst[spline][order];
            *worst = worst.max((error - of_place) / sizes[order]);
            per *= radians(1.0);
        }
    }
    assert_eq!(count, 3 * 18);
    println!("splines, of their largest values: {worst:?}");
    // What rounds slopes that are given is 24 / width^2 times as much in the third derivative.
    let allowed = |spline: usize, order: usize| match (spline, order) {
        (2, 3) => 6e-15,
        _ => 2e-15,
    };
    for (spline, own) in worst.iter().enumerate() {
        for (order, own) in own.iter().enumerate() {
            assert!(*own <= allowed(spline, order), "{spline} {order}: {own:e}");
        }
    }
}

/// Sensitivities to values and places of knots against dual numbers, which follow the whole formula.
#[test]
fn dimensions_of_courses_have_exact_sensitivities() {
    let linkage = Courses::default().assemble().expect("it has no loop");
    let of = |name: &str| {
        let mut moving = Courses::default().cast::<Dual<Dual64>>();
        let field = match name {
            "lift" => &mut moving.lift,
            "start" => &mut moving.start,
            _ => &mut moving.second,
        };
        field.0.eps = 1.0;
        moving.assemble().expect("it has no loop")
    };
    let [lift, start, second] = ["lift", "start", "second"].map(of);
    let mut random = Random::new(62);
    for _ in 0..100 {
        let phi = random.between(-7.0, 14.0);
        let found = linkage.by_dimensions(phi);
        let constant = Dual(Dual64::from(phi));
        let [by_lift, by_start, by_second] =
            [&lift, &start, &second].map(|own| own.values(constant));
        let [rate_lift, rate_start, rate_second] =
            [&lift, &start, &second].map(|own| own.rates(constant));
        let [bent_start, bent_second] = [&start, &second].map(|own| own.quintics(constant));
        let pairs = [
            (found.s, [by_lift.s, by_start.s]),
            (found.s_rate, [rate_lift.s, rate_start.s]),
            (found.natural, [by_second.natural, by_start.natural]),
            (found.clamped, [by_second.clamped, by_start.clamped]),
            (found.again, [rate_second.again, rate_start.again]),
            (found.bent, [bent_second.bent, bent_start.bent]),
            (found.free, [bent_second.free, bent_start.free]),
            (found.led, [bent_second.led, bent_start.led]),
            (found.circle, [bent_second.circle, bent_start.circle]),
            (
                found.bent_slope,
                [bent_second.bent_slope, bent_start.bent_slope],
            ),
            (
                found.led_curvature,
                [bent_second.led_curvature, bent_start.led_curvature],
            ),
        ];
        for (found, expected) in pairs {
            for (found, Dual(expected)) in found.into_iter().zip(expected) {
                let error = (found - expected.eps).abs();
                assert!(
                    error <= 1e-12 * expected.eps.abs().max(10.0),
                    "{phi}: {found} {}",
                    expected.eps
                );
            }
        }
    }
    // Knots that other dimensions put out of order have no course between them.
    let crossed = Courses {
        start: 2.0,
        ..Courses::default()
    }
    .assemble()
    .expect("it has no loop");
    assert!(crossed.values(1.7).s.is_nan() && crossed.rates(5.0).s.is_nan());
    assert!(crossed.values(1.9).natural.is_nan() && crossed.values(1.9).spline.is_finite());
}

/// Rows of sweeps are single calls but for the rounding of sines.
#[test]
fn sweeps_of_courses_are_single_calls() {
    let linkage = Courses::default().assemble().expect("it has no loop");
    let inputs: Vec<f64> = (0..1001).map(|k| -20.0 + 0.04 * f64::from(k)).collect();
    let rows = linkage.values_sweep(&inputs);
    for (k, &phi) in inputs.iter().enumerate() {
        let single = linkage.values(phi);
        let row = [rows.s()[k], rows.spline()[k], rows.again()[k]];
        for (row, single) in row.into_iter().zip([single.s, single.spline, single.again]) {
            let apart = (row - single).abs();
            assert!(
                apart <= 4.0 * f64::EPSILON * 20.0,
                "{phi}: {row}, not {single}"
            );
        }
    }
}

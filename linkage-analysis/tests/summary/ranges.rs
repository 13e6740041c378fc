//! Ends, seams, standstills, constants, errors and scales.

use crate::{PI, TAU, near, turn};
use linkage_analysis::summary::{Curve, Kind, SummaryError};

#[test]
fn limits_at_the_seam_are_there_once() {
    let course = turn(|x: f64| [x.cos(), -x.sin(), -x.cos(), x.sin()]);
    let position = course.position();
    assert_eq!(position.points.len(), 2);
    assert_eq!(position.highest.at, 0.0);
    assert_eq!(position.highest.value, 1.0);
    near(position.lowest.at, PI, 1e-15);
    assert!(!position.highest.end);
    assert_eq!(course.velocity().points.len(), 2);
    assert_eq!(course.acceleration().points.len(), 2);
}

#[test]
fn limits_in_any_cycle() {
    for start in [-7.0, -0.3, 1e-9, 0.1, 2.0, 3.1, 100.0] {
        for positions in [7, 90, 361, 1000] {
            let course = Curve::new((start, start + TAU), positions, |x: f64| {
                [
                    (2.0 * x).sin(),
                    2.0 * (2.0 * x).cos(),
                    -4.0 * (2.0 * x).sin(),
                ]
            });
            let course = course.expect("a course");
            assert!(course.is_cycle());
            assert_eq!(course.position().points.len(), 4, "{start} {positions}");
            assert_eq!(course.velocity().points.len(), 4, "{start} {positions}");
            for point in &course.position().points {
                assert!(point.at >= start && point.at < start + TAU);
                near((2.0 * point.at).cos(), 0.0, 1e-12);
                near(point.value.abs(), 1.0, 1e-15);
            }
        }
    }
}

#[test]
fn ends_of_a_part_of_a_turn_are_limits() {
    let course = Curve::new((0.0, 2.0), 20, |x: f64| [x.cos(), -x.sin()]).expect("a course");
    assert!(!course.is_cycle());
    let points = &course.position().points;
    assert!(points.len() == 2 && points.iter().all(|point| point.end));
    assert_eq!((points[0].at, points[0].kind), (0.0, Kind::High));
    assert_eq!((points[1].at, points[1].kind), (2.0, Kind::Low));
    assert_eq!(course.position().limits().count(), 0);
    assert_eq!(course.time_ratio(), None);
}

#[test]
fn a_momentary_standstill_is_no_limit() {
    let cube = |x: f64| [x * x * x, 3.0 * x * x, 6.0 * x, 6.0];
    let course = Curve::new((-1.0, 1.3), 50, cube).expect("a course");
    let points = &course.position().points;
    assert_eq!(points.len(), 3);
    assert_eq!(points[1].kind, Kind::Pass);
    near(points[1].at, 0.0, 1e-15);
    assert!(course.position().limits().next().is_none());

    let course = turn(|x: f64| [x - x.sin(), 1.0 - x.cos(), x.sin()]);
    assert_eq!(
        course
            .position()
            .points
            .iter()
            .filter(|point| point.kind == Kind::Pass)
            .count(),
        1
    );
}

#[test]
fn pairs_of_limits_near_each_other() {
    // x^3 - 3 a^2 x: limits at -a and a, far below the spacing of 0.02.
    for a in [1e-1_f64, 1e-2, 1e-3, 1e-4, 1e-5] {
        let wave = |x: f64| {
            [
                x * x * x - 3.0 * a * a * x,
                3.0 * (x - a) * (x + a),
                6.0 * x,
            ]
        };
        let course = Curve::new((-1.0, 1.03), 100, wave).expect("a course");
        let limits: Vec<f64> = course.position().limits().map(|limit| limit.at).collect();
        assert_eq!(limits.len(), 2, "{a}");
        near(limits[0], -a, 1e-15);
        near(limits[1], a, 1e-15);

        // Without the second derivative, the mean of the first one shows them.
        let wave = |x: f64| [x * x * x - 3.0 * a * a * x, 3.0 * (x - a) * (x + a)];
        let course = Curve::new((-1.0, 1.03), 100, wave).expect("a course");
        assert_eq!(course.position().limits().count(), 2, "{a}");
    }
}

#[test]
fn constants() {
    let course = turn(|_: f64| [7.0, 0.0, 0.0, 0.0]);
    assert!(course.position().points.is_empty() && course.is_cycle());
    assert_eq!(
        (course.position().stroke(), course.position().lowest.value),
        (0.0, 7.0)
    );
    assert_eq!(course.dwells(0.1).len(), 1);
    near(course.dwells(0.1)[0].interval.range, TAU, 0.0);

    // Nothing but rounding.
    let course = turn(|x: f64| {
        let noise = (1e6 * x).sin() * 1e-15;
        [500.0 * (1.0 + noise), noise, -noise, noise]
    });
    assert!(course.position().points.is_empty());

    // Uniform motion.
    let course = Curve::new((1.0, 3.0), 30, |x: f64| [2.0 * x, 2.0, 0.0, 0.0]).expect("a course");
    assert_eq!(course.velocity().points, []);
    assert_eq!(course.velocity().highest.value, 2.0);
    assert_eq!(course.position().stroke(), 4.0);
}

#[test]
fn a_cam_that_rests_for_most_of_the_turn() {
    // A rise and a return of 10 within a fifth of the turn; elsewhere all derivatives are 0.
    let course = turn(|x: f64| {
        let (sin, cos) = (5.0 * x).sin_cos();
        if (x - 0.5 * TAU).abs() > 0.1 * TAU {
            [0.0; 3]
        } else {
            [5.0 - 5.0 * cos, 25.0 * sin, 125.0 * cos]
        }
    });
    let limits: Vec<Kind> = course.position().limits().map(|limit| limit.kind).collect();
    // The rest begins after the return.
    assert_eq!(limits, [Kind::High, Kind::Low]);
    near(course.position().highest.at, 0.5 * TAU, 1e-14);
    let dwell = course.longest_dwell(5.0).expect("a dwell");
    near(dwell.interval.from, 0.55 * TAU, 1e-14);
    near(dwell.interval.to, 0.45 * TAU, 1e-14);
    near(dwell.interval.range, 0.9 * TAU, 1e-14);
    assert_eq!(dwell.ripple, 0.0);
}

#[test]
fn scales() {
    for value in [1e-150_f64, 1e-20, 1.0, 1e20, 1e150] {
        let course = turn(|x: f64| {
            let (sin, cos) = (x - 0.3).sin_cos();
            [value * cos, -value * sin, -value * cos, value * sin]
        });
        let highest = course.position().highest;
        near(highest.at, 0.3, 1e-14);
        near(highest.value / value, 1.0, 1e-15);
        near(course.velocity().lowest.at, 0.3 + 0.5 * PI, 1e-14);
        let dwell = course
            .longest_dwell(value * (1.0 - 0.6_f64.cos()))
            .expect("a dwell");
        near(dwell.interval.range, 1.2, 1e-13);
    }
    for size in [1e-100_f64, 1e-9, 1e9, 1e100] {
        let course = Curve::new((size, 5.0 * size), 40, |x: f64| {
            let (sin, cos) = (x / size).sin_cos();
            [cos, -sin / size, -cos / size / size]
        });
        let course = course.expect("a course");
        near(course.position().lowest.at / size, PI, 1e-14);
        near(course.velocity().highest.at / size, 1.5 * PI, 1e-14);
    }
}

#[test]
fn errors() {
    let line = |x: f64| [x, 1.0];
    for range in [
        (1.0, 1.0),
        (2.0, 1.0),
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
    ] {
        assert!(matches!(
            Curve::new(range, 9, line),
            Err(SummaryError::Range { .. })
        ));
    }
    assert_eq!(
        Curve::new((0.0, 1.0), 1, line).err(),
        Some(SummaryError::Positions { positions: 1 })
    );
    let nowhere = Curve::new((0.0, 1.0), 9, |_: f64| [f64::NAN; 2]);
    assert_eq!(
        nowhere.err(),
        Some(SummaryError::NotAssembled { positions: 9 })
    );
}

/// An angle that turns backwards and stands still at the seam: the ends of the turn are its limits, in that order.
#[test]
fn a_turn_backwards_from_a_standstill() {
    for (sense, first, last) in [(-1.0, Kind::High, Kind::Low), (1.0, Kind::Low, Kind::High)] {
        let course = turn(|x: f64| {
            [
                sense * (x - x.sin()),
                sense * (1.0 - x.cos()),
                sense * x.sin(),
            ]
        });
        let ends = course.position().points.iter().filter(|point| point.end);
        let ends: Vec<_> = ends.map(|point| (point.at, point.kind)).collect();
        assert_eq!(ends, [(0.0, first), (TAU, last)]);
    }
}

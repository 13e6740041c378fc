//! Motions that end before their time: cause, time and input, and the motion up to there.

use crate::{Cause, Fault, Interrupted, Method, Problem, Reduced};
use std::f64::consts::FRAC_PI_2;

/// A scotch yoke that its slide drives: a crank of 1 kg*m^2 and 1 m has the inertia `1 / (1 - x^2)`
/// over the slide. At a constant speed of the crank the slide is `sin(omega t)`, and its dead point
/// is at 1.
fn yoke([x]: [f64; 1], [v]: [f64; 1]) -> Reduced {
    let inertia = 1.0 / (1.0 - x * x).sqrt().powi(2);
    Reduced::one(inertia, -x * v * v * inertia * inertia)
}

fn assert_dead_point(error: &Interrupted<1>, omega: f64, accuracy: f64) {
    let Cause::DeadPoint { state, input: 0 } = error.cause() else {
        panic!("{error}");
    };
    let time = FRAC_PI_2 / omega;
    assert!((state.time - time).abs() < accuracy * time, "{error}");
    assert!((state.inputs[0] - 1.0).abs() < accuracy, "{error}");
    let motion = error.motion();
    assert!((motion.end().time - state.time).abs() < accuracy.max(2e-4) * time);
    let middle = motion.state(0.5 * time);
    assert!((middle.inputs[0] - 0.5_f64.sqrt()).abs() < accuracy);
}

#[test]
fn a_dead_point_has_its_time_and_input() {
    for (method, tolerance, accuracy) in [
        (Method::Explicit, 1e-10, 1e-6),
        (Method::Explicit, 1e-4, 0.01),
        (Method::Implicit, 1e-8, 1e-4),
    ] {
        for omega in [0.3, 1.0, 50.0] {
            let problem = Problem::reduced(|_, x, v| yoke(x, v))
                .start([0.0], [omega])
                .tolerance(tolerance)
                .method(method);
            let error = problem.until(1e3).expect_err("a dead point");
            assert_dead_point(&error, omega, accuracy);
        }
    }
}

/// A reversal at a spring is no dead point, also where the force is small and the tolerance large.
#[test]
fn a_reversal_is_no_dead_point() {
    for tolerance in [1e-3, 1e-6, 1e-12] {
        for amplitude in [1e-6, 1.0, 1e3] {
            let spring = |_, [x]: [f64; 1], _: [f64; 1]| [-x];
            let problem = Problem::new(spring).start([amplitude], [0.0]);
            let motion = problem.tolerance(tolerance).until(20.0);
            assert!(motion.is_ok(), "{tolerance} {amplitude}: {motion:?}");
        }
    }
    // Friction brings it to rest, where the speed is noise.
    let damped = |_, [x]: [f64; 1], [v]: [f64; 1]| [-x - 0.5 * v];
    let motion = Problem::new(damped).start([1.0], [0.0]).until(300.0);
    assert!(motion.expect("rest").end().inputs[0].abs() < 1e-7);
}

/// A load that ends: the last state is at the last time with a load.
#[test]
fn a_load_without_a_value_ends_the_motion() {
    let load = |time: f64| if time <= 0.5 { 2.0 } else { f64::NAN };
    for method in [Method::Explicit, Method::Implicit] {
        let problem = Problem::reduced(|time, _: [f64; 1], _| Reduced::one(1.0, load(time)));
        let error = problem.method(method).until(3.0).expect_err("no load");
        let Cause::Undefined { state, fault } = *error.cause() else {
            panic!("{error}");
        };
        assert_eq!(fault, Fault::ForceUndefined);
        assert!((state.time - 0.5).abs() < 1e-12, "{}", state.time);
        assert!((state.inputs[0] - 0.25).abs() < 1e-7);
        assert!((error.motion().state(0.25).inputs[0] - 0.0625).abs() < 1e-7);
    }
    // From closures of accelerations there is less to know.
    let problem = Problem::new(|time, _: [f64; 1], _| [load(time)]);
    let error = problem.until(3.0).expect_err("no load");
    let text = error.to_string();
    assert!(
        text.starts_with("the accelerations are not finite after 0.5 s"),
        "{text}"
    );
}

/// A load that ends at a position: the last state is before it, and has a load.
#[test]
fn the_last_state_has_accelerations() {
    for method in [Method::Explicit, Method::Implicit] {
        for part in 1..=400 {
            let limit = 0.01 * f64::from(part);
            let load = |_, [x]: [f64; 1], _: [f64; 1]| {
                [if x <= limit {
                    1.0 + 0.9 * (9.0 * x).sin()
                } else {
                    f64::NAN
                }]
            };
            let problem = Problem::new(load).method(method).tolerance(0.1);
            let error = problem.until(9.0).expect_err("no load");
            let state = error.motion().end();
            assert!(matches!(error.cause(), Cause::Undefined { .. }), "{error}");
            assert!(state.inputs[0] <= limit, "{limit} {state:?}");
            assert!((state.inputs[0] - limit).abs() < 1e-7, "{limit} {state:?}");
        }
    }
}

#[test]
fn no_inertia_is_an_error_at_the_start() {
    let problem = Problem::reduced(|_, _: [f64; 1], _| Reduced::one(0.0, 1.0));
    let error = problem.until(1.0).expect_err("no inertia");
    let Cause::Undefined { state, fault } = *error.cause() else {
        panic!("{error}");
    };
    assert_eq!((state.time, fault), (0.0, Fault::InertiaNotPositive(0.0)));
    assert_eq!(error.motion().steps(), 0);
    let text = error.to_string();
    assert!(
        text.contains("the inertia 0 is not positive after 0 s"),
        "{text}"
    );
    assert!(
        text.contains("help: give the moving links masses"),
        "{text}"
    );
}

/// A speed that grows without bound at the time 1.
#[test]
fn a_tolerance_that_is_not_reached() {
    let problem = Problem::new(|time: f64, _: [f64; 1], _| [(1.0 - time).powi(-2)]);
    let error = problem.until(2.0).expect_err("no end");
    let Cause::Tolerance { state, .. } = *error.cause() else {
        panic!("{error}");
    };
    assert!((state.time - 1.0).abs() < 1e-9, "{error}");
    let state = error.motion().state(0.5);
    assert!((state.speeds[0] - 1.0).abs() < 1e-6, "{state:?}");
}

#[test]
fn steps_are_limited() {
    let problem = Problem::new(|_, [x]: [f64; 1], _| [-x]).start([1.0], [0.0]);
    let error = problem.most_steps(5).until(1e4).expect_err("five steps");
    assert!(matches!(error.cause(), Cause::Steps { most: 5, .. }));
    assert_eq!(error.motion().steps(), 5);
    assert!(error.to_string().starts_with("5 steps end after "));
}

#[test]
fn numbers_of_the_problem_are_checked() {
    let problem = || Problem::new(|_, [x]: [f64; 1], _| [-x]).start([1.0], [0.0]);
    let cause = |result: Result<_, Interrupted<1>>| result.expect_err("a mistake").cause().clone();
    for tolerance in [0.0, -1.0, f64::NAN, 1.0, 1e-15] {
        let found = cause(problem().tolerance(tolerance).until(1.0));
        assert!(matches!(found, Cause::BadTolerance(_)), "{tolerance}");
    }
    for end in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let found = cause(problem().until(end));
        assert!(matches!(found, Cause::BadEnd { .. }), "{end}");
    }
    let found = cause(problem().start([f64::NAN], [0.0]).until(1.0));
    assert!(matches!(found, Cause::BadStart(_)));
}

//! The integrator of pages against a pendulum in elliptic functions.

use std::f64::consts::PI;

use linkage_browser::Page;
use linkage_js::engine::INTEGRATOR;

use crate::page::load;

/// The pendulum `phi" = -sin phi` from rest: all states, evaluations, and what ends it. A quarter of its length is out of reach if `end` is given.
const PENDULUM: &str = "
const moved = (amplitude, times, tolerance, end) => {
  let evaluations = 0;
  const rates = ([phi, omega], slopes) => {
    evaluations += 1;
    slopes[0] = omega;
    slopes[1] = end !== null && phi < end ? NaN : -Math.sin(phi);
  };
  const states = times.map(() => null);
  const take = (row, state) => { states[row] = [...state]; };
  const why = integrated({ rates, state: [amplitude, 0], times, tolerance, mostSteps: 100000, take });
  return { states, evaluations, why: why && { ...why, state: [...why.state], rates: null } };
};
// The time at which the speed changes its sign first.
const turned = (amplitude, tolerance) => {
  const rates = ([phi, omega], slopes) => { slopes[0] = omega; slopes[1] = -Math.sin(phi); };
  const watch = (step) => {
    if (!(step.from[1] * step.to[1] < 0)) return null;
    const part = zeroWithin(step, (state) => state[1]);
    return { time: step.time + part, state: [...step.after(part)] };
  };
  return integrated({ rates, state: [amplitude, 0], times: [0, 100], tolerance, mostSteps: 100000, take: () => {}, watch });
};
";

const AMPLITUDE: f64 = 1.5;

fn page() -> Option<Page> {
    load(&format!(
        "<!doctype html><meta charset=\"utf-8\"><title>Integrator</title><script>{INTEGRATOR}\n{PENDULUM}</script>"
    ))
}

/// The period by the arithmetic-geometric mean of Gauss.
fn period() -> f64 {
    let (mut a, mut b) = (1.0, f64::cos(AMPLITUDE / 2.0));
    for _ in 0..8 {
        (a, b) = ((a + b) / 2.0, f64::sqrt(a * b));
    }
    2.0 * PI / a
}

/// Angle and speed after eighths of the period: the elliptic sine is known there in closed form.
fn exact(eighth: usize) -> [f64; 2] {
    let k = f64::sin(AMPLITUDE / 2.0);
    let complement = f64::cos(AMPLITUDE / 2.0);
    let half = 1.0 / f64::sqrt(1.0 + complement);
    let (sine, sign) = match eighth % 8 {
        0 => (1.0, 0.0),
        1 => (half, -1.0),
        2 => (0.0, -1.0),
        3 => (-half, -1.0),
        4 => (-1.0, 0.0),
        5 => (-half, 1.0),
        6 => (0.0, 1.0),
        _ => (half, 1.0),
    };
    let angle = 2.0 * f64::asin(k * sine);
    let speed = f64::sqrt((2.0 * (angle.cos() - AMPLITUDE.cos())).max(0.0));
    [angle, sign * speed]
}

#[test]
fn a_pendulum_moves_by_elliptic_functions() {
    let Some(mut page) = page() else {
        return;
    };
    let times: Vec<f64> = (0..=80).map(|k| period() * f64::from(k) / 8.0).collect();
    let mut evaluations = 0.0;
    for (tolerance, limit) in [(1e-6, 1e-3), (1e-8, 1e-5), (1e-10, 1e-7), (1e-12, 2e-9)] {
        let moved = page.value(&format!(
            "moved({AMPLITUDE}, {times:?}, {tolerance:e}, null)"
        ));
        assert!(moved["why"].is_null());
        let states = moved["states"].as_array().expect("states");
        assert_eq!(states.len(), times.len());
        for (eighth, state) in states.iter().enumerate() {
            for (component, exact) in exact(eighth).into_iter().enumerate() {
                let error = state[component].as_f64().expect("a number") - exact;
                assert!(error.abs() < limit, "{tolerance:e}, {eighth}: {error:e}");
            }
        }
        // A method of order 5: a hundredth of the error for two and a half times the work.
        let more = moved["evaluations"].as_f64().expect("a number");
        assert!(
            more < 3.0 * evaluations || evaluations == 0.0,
            "{more} after {evaluations}"
        );
        evaluations = more;
    }
}

#[test]
fn a_zero_within_a_step_is_exact() {
    let Some(mut page) = page() else {
        return;
    };
    let turn = page.value(&format!("turned({AMPLITUDE}, 1e-12)"));
    let time = turn["time"].as_f64().expect("a time");
    assert!((time - period() / 2.0).abs() < 1e-9, "{time}");
    assert!((turn["state"][0].as_f64().expect("a number") + AMPLITUDE).abs() < 1e-9);
}

#[test]
fn a_motion_ends_where_rates_end() {
    let Some(mut page) = page() else {
        return;
    };
    // After three eighths of a period the angle is as far on the other side.
    let end = exact(3)[0];
    let moved = page.value(&format!("moved({AMPLITUDE}, [0, 1, 20], 1e-10, {end:?})"));
    let why = &moved["why"];
    assert_eq!(why["why"], "undefined");
    let time = why["time"].as_f64().expect("a time");
    assert!((time - 3.0 * period() / 8.0).abs() < 1e-7, "{time}");
    assert!(moved["states"][1].is_array() && moved["states"][2].is_null());
}

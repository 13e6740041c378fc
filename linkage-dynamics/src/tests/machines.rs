//! Questions of machine builders against closed forms.

use crate::{
    Machine, Motor, NotReached, NotSteady, Reduced, brake, flywheel, run_up, steady_state,
};
use std::f64::consts::TAU;

/// A machine of the inertia 1 with the force `h + g cos phi - c omega^2`, whose half squared speed
/// fulfils `e' = h + g cos phi - 2 c e`.
fn with_fan(h: f64, g: f64, c: f64) -> Machine<impl Fn(f64, f64) -> Reduced> {
    Machine::new(move |phi: f64, omega: f64| {
        Reduced::one(1.0, h + g * phi.cos() - c * omega * omega)
    })
}

#[test]
fn steady_state_in_closed_form() {
    let (h, g, c) = (20.0, 8.0, 0.05);
    let found = steady_state(&with_fan(h, g, c), 30.0).expect("a steady state");
    let exact = |phi: f64| {
        let half_square =
            h / (2.0 * c) + g * (2.0 * c * phi.cos() + phi.sin()) / (4.0 * c * c + 1.0);
        (2.0 * half_square).sqrt()
    };
    for phi in [0.0, 1.0, 2.5, 4.0, TAU] {
        assert!((found.speed(phi) - exact(phi)).abs() < 1e-9, "{phi}");
    }
    assert!((found.multiplier() - (-2.0 * c * TAU).exp()).abs() < 1e-9);
    // Extremes where `2 c cos + sin` is extreme.
    let fastest = 1.0_f64.atan2(2.0 * c);
    assert!((found.fastest().0 - fastest).abs() < 1e-8);
    assert!((found.slowest().0 - fastest - 0.5 * TAU).abs() < 1e-8);
    assert!((found.fastest().1 - exact(fastest)).abs() < 1e-9);
    // The time by the trapezoidal rule, which is exact for periodic functions.
    let count = 200;
    let sum: f64 = (0..count)
        .map(|i| 1.0 / exact(TAU * f64::from(i) / f64::from(count)))
        .sum();
    assert!((found.time() - sum * TAU / f64::from(count)).abs() < 1e-11);
    assert!((found.mean_speed() * found.time() - TAU).abs() < 1e-12);
    assert!((found.time_at_input(TAU) - found.time()).abs() < 1e-14);
    let unevenness = (exact(fastest) - exact(fastest + 0.5 * TAU)) / found.mean_speed();
    assert!((found.unevenness() - unevenness).abs() < 1e-10);
}

#[test]
fn machines_without_steady_state() {
    // Resistance only: it stops.
    let error = steady_state(&with_fan(-3.0, 0.0, 0.0), 2.0).expect_err("no motor");
    let NotSteady::Stalls { input, .. } = error else {
        panic!("{error}");
    };
    assert!((input - 2.0 / 3.0).abs() < 1e-6, "{input}");
    // A constant moment.
    let error = steady_state(&with_fan(3.0, 1.0, 0.0), 2.0).expect_err("it grows");
    let NotSteady::Indifferent { gain } = error else {
        panic!("{error}");
    };
    assert!((gain - 3.0 * TAU).abs() < 1e-8, "{gain}");
    assert!(steady_state(&with_fan(1.0, 0.0, 1.0), f64::NAN).is_err());
}

#[test]
fn the_smallest_flywheel() {
    let machine = with_fan(20.0, 8.0, 0.05);
    let before = steady_state(&machine, 20.0)
        .expect("a steady state")
        .unevenness();
    let wished = 0.25 * before;
    let found = flywheel(&machine, wished, 20.0).expect("a flywheel");
    assert!((found.steady_state.unevenness() / wished - 1.0).abs() < 1e-7);
    let heavy = |inertia: f64| {
        let machine = Machine::new(move |phi: f64, omega: f64| {
            Reduced::one(1.0 + inertia, 20.0 + 8.0 * phi.cos() - 0.05 * omega * omega)
        });
        steady_state(&machine, 20.0)
            .expect("a steady state")
            .unevenness()
    };
    assert!(heavy(1.001 * found.inertia) < wished && heavy(0.999 * found.inertia) > wished);
    let none = flywheel(&machine, 2.0 * before, 20.0).expect("no flywheel");
    assert_eq!(none.inertia, 0.0);
}

/// A DC motor and a constant inertia: the speed approaches that without load exponentially.
#[test]
fn run_up_of_a_flywheel_by_a_dc_motor() {
    let (voltage, resistance, constant, inertia) = (48.0, 0.6, 0.12, 0.003);
    let motor = Motor::dc(voltage, resistance, constant, constant);
    let machine = Machine::new(|_, _| Reduced::one(inertia, 0.0));
    let speed = 0.9 * motor.no_load_speed();
    let found = run_up(&machine, &motor, speed, 10.0).expect("a run-up");
    let time_constant = inertia * resistance / (constant * constant);
    assert!((found.time - time_constant * 10.0_f64.ln()).abs() < 1e-9);
    // The current's energy is `J omega omega_0`.
    let kinetic = 0.5 * inertia * speed * speed;
    let heat = inertia * speed * motor.no_load_speed() - kinetic;
    assert!((found.work - kinetic).abs() < 1e-8 * kinetic);
    assert!((found.heat - heat).abs() < 1e-8 * heat);
    let angle = motor.no_load_speed() * (found.time - 0.9 * time_constant);
    assert!((found.angle - angle).abs() < 1e-7);
    // More than the speed without load is never reached.
    let error = run_up(&machine, &motor, 1.1 * motor.no_load_speed(), 2.0).expect_err("too fast");
    let NotReached::Late { motion, .. } = &error else {
        panic!("{error}");
    };
    assert_eq!(motion.end().time, 2.0);
}

/// A constant moment: time `J omega / M`, angle `J omega^2 / (2 M)`, in both directions.
#[test]
fn brake_with_a_constant_moment() {
    let machine = Machine::new(|_, _| Reduced::one(0.02, 0.0)).start(0.5);
    for speed in [30.0, -30.0] {
        let stop = brake(&machine, speed, |_| 1.5, 5.0).expect("a stop");
        assert!((stop.time - 0.4).abs() < 1e-9);
        assert!((stop.angle - 0.2 * speed).abs() < 1e-8, "{}", stop.angle);
        assert!((stop.input - 0.5 - stop.angle).abs() < 1e-12);
        assert!((stop.heat - 9.0).abs() < 1e-8);
    }
    let weak = brake(&machine, 30.0, |_| 0.01, 5.0).expect_err("too weak");
    assert!(
        weak.to_string().contains("is not reached within 5 s"),
        "{weak}"
    );
}

//! The pendulum in elliptic functions, by the arithmetic-geometric mean (Abramowitz and Stegun,
//! 16.4 and 17.6).

use crate::{Conservative, Event, Method, Problem};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Arithmetic-geometric mean.
fn mean(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// Returns the angle and the speed of a pendulum with `phi'' = -sin phi` at a time after its
/// release at an amplitude: `phi = 2 asin(k cd(t, k))` with `k = sin(amplitude / 2)`.
fn pendulum(amplitude: f64, time: f64) -> [f64; 2] {
    let k = (0.5 * amplitude).sin();
    let (mut a, mut b, mut c) = (1.0, (0.5 * amplitude).cos(), k);
    let mut ratios = Vec::new();
    while c.abs() > 1e-17 {
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        ratios.push(c / a);
    }
    let mut phi = f64::powi(2.0, ratios.len() as i32) * a * time;
    for ratio in ratios.into_iter().rev() {
        phi = 0.5 * (phi + (ratio * phi.sin()).asin());
    }
    let (sn, cn) = phi.sin_cos();
    let dn = (1.0 - k * k * sn * sn).sqrt();
    let sine = k * cn / dn;
    // The derivative of cd is `-(1 - k^2) sn / dn^2`.
    let slope = -k * (1.0 - k * k) * sn / (dn * dn);
    [2.0 * sine.asin(), 2.0 * slope / (1.0 - sine * sine).sqrt()]
}

fn released(amplitude: f64) -> Problem<'static, 1, impl crate::Equations<1>> {
    Problem::new(|_, [phi]: [f64; 1], _| [-phi.sin()]).start([amplitude], [0.0])
}

/// The reference fulfils the energy, and repeats after its period.
#[test]
fn the_reference_is_a_pendulum() {
    let period = TAU / mean(1.0, 1.0_f64.cos());
    for share in [0.0, 0.1, 0.2, 0.4, 0.7, 1.0] {
        let [phi, omega] = pendulum(2.0, share * period);
        let energy = 0.5 * omega * omega - phi.cos();
        assert!((energy + 2.0_f64.cos()).abs() < 4e-15, "{share}");
    }
    assert!((pendulum(2.0, period)[0] - 2.0).abs() < 1e-14);
    assert!((pendulum(2.0, 0.5 * period)[0] + 2.0).abs() < 1e-14);
}

/// Both integrators, at steps and between them, over two periods.
#[test]
fn motions_in_elliptic_functions() {
    let cases = [
        (Method::Explicit, 1e-13, 3e-12),
        (Method::Explicit, 1e-6, 3e-5),
        (Method::Implicit, 1e-10, 3e-7),
    ];
    for (method, tolerance, error) in cases {
        let problem = released(2.0).method(method).tolerance(tolerance);
        let motion = problem.until(20.0).expect("a motion");
        for state in motion.states(97) {
            let [phi, omega] = pendulum(2.0, state.time);
            let off = (state.inputs[0] - phi)
                .abs()
                .max((state.speeds[0] - omega).abs());
            assert!(off < error, "{method:?} {tolerance} {}: {off}", state.time);
        }
        let off = (motion.end().inputs[0] - pendulum(2.0, 20.0)[0]).abs();
        assert!(off < error, "{off}");
    }
}

/// Events are as accurate as dense output: passages and turns at quarters of the period.
#[test]
fn events_at_quarters_of_the_period() {
    let quarter = FRAC_PI_2 / mean(1.0, 1.0_f64.cos());
    let problem = released(2.0)
        .tolerance(1e-13)
        .event(Event::input(0, 0.0).falling())
        .event(Event::reversal(0))
        .event(Event::new(|state| state.time - 6.5 * quarter).stop());
    let motion = problem.until(100.0).expect("a motion");
    let found = motion.occurrences();
    let expected = [(0, 1.0), (1, 2.0), (1, 4.0), (0, 5.0), (1, 6.0), (2, 6.5)];
    assert_eq!(found.len(), expected.len());
    for (found, (event, quarters)) in found.iter().zip(expected) {
        assert_eq!(found.event, event);
        let off = found.state.time - quarters * quarter;
        assert!(off.abs() < 2e-11, "{quarters}: {off}");
    }
    assert_eq!(motion.end().time, found[5].state.time);
    assert_eq!(motion.ended(), crate::Ended::Event(2));
}

/// The energy integral: times from inputs and inputs from times, over 10^6 turns, too.
#[test]
fn energy_integral_of_a_pendulum() {
    let falling = Conservative::new(|phi: f64| [1.0, phi.cos()]).start(2.0, 0.0);
    for share in [0.1, 0.5, 0.9, 1.0] {
        let time = share * FRAC_PI_2 / mean(1.0, 1.0_f64.cos());
        let [phi, omega] = pendulum(2.0, time);
        assert!((falling.time(phi).expect("a time") - time).abs() < 1e-13);
        assert!((falling.input(time).expect("an input") - phi).abs() < 1e-13);
        assert!((falling.speed(phi) + omega).abs() < 1e-14);
        let exact = Conservative::new(|phi: f64| [1.0, phi.cos()]).start(2.0, 0.0);
        let exact = exact.force(|phi| -phi.sin());
        assert!((exact.time(phi).expect("a time") - time).abs() < 5e-15);
    }
    // A pendulum that turns: with `omega^2 = 4 + 4 cos^2(phi / 2)` a turn takes `4 K / sqrt(8)` of
    // the modulus `1 / sqrt(2)`.
    let turning = Conservative::new(|phi: f64| [1.0, phi.cos()]).start(0.0, 8.0_f64.sqrt());
    let turning = turning.period(TAU);
    let turn = TAU / mean(8.0_f64.sqrt(), 2.0);
    let time = 1e6 * turn;
    let input = turning.input(time).expect("an input");
    assert!((input / TAU - 1e6).abs() < 1e-7, "{}", input / TAU);
    assert!((turning.time(TAU).expect("a time") - turn).abs() < 1e-14);
}

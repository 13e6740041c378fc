//! Andrews' squeezing mechanism against the reference of the test set for IVP solvers, with its error corrected.

use linkage::dynamics::{Conservative, Event, Method, Problem};

include!("../../mechanisms/andrews.rs");

const START: f64 = -0.061_713_890_014_276_45;
const MOMENT: f64 = 0.033;
const END: f64 = 0.03;
/// Angle and speed of the crank after 0.03 s; the angle by a Taylor series of 30 digits. The test set
/// has 15.81077119629904.
const ANGLE: f64 = 15.810_771_195_153_707;
const SPEED: f64 = 1_139.920_302_151_208;

fn linkage() -> AndrewsAssembly {
    Andrews::default().assemble().expect("an assembly")
}

#[test]
fn reference_by_both_integrators() {
    let linkage = linkage();
    for (method, tolerance, error) in [
        (Method::Explicit, 1e-13, 3e-11),
        (Method::Explicit, 1e-8, 1e-5),
        (Method::Implicit, 1e-9, 1e-4),
    ] {
        let accelerate = |_, [beta]: [f64; 1], [speed]: [f64; 1]| {
            [linkage.motion(beta, speed, MOMENT).acceleration]
        };
        let problem = Problem::new(accelerate).start([START], [0.0]);
        let problem = problem.method(method).tolerance(tolerance);
        let end = problem.until(END).expect("a motion").end();
        let off = end.inputs[0] - ANGLE;
        assert!(off.abs() < error, "{method:?} {tolerance}: {off:e}");
        assert!(
            (end.speeds[0] - SPEED).abs() < 1e4 * error,
            "{}",
            end.speeds[0]
        );
        // Without stored steps the same.
        let same = problem.only_end().until(END).expect("a motion").end();
        assert!((same.inputs[0] - end.inputs[0]).abs() < error);
    }
}

/// The motor and the spring are conservative: the speed follows from the energy, the time from its integral.
#[test]
fn reference_by_the_energy() {
    let linkage = linkage();
    let function = |beta: f64| {
        let energy = linkage.energy(beta, 1.0);
        [2.0 * energy.kinetic, MOMENT * beta - energy.potential]
    };
    let energy = Conservative::new(function).start(START, 0.0);
    let energy = energy.force(|beta| linkage.terms(beta, 0.0, MOMENT).force);
    let off = energy.input(END).expect("an input") - ANGLE;
    assert!(off.abs() < 1e-12, "{off:e}");
    assert!((energy.time(ANGLE).expect("a time") - END).abs() < 1e-15);
    assert!((energy.speed(ANGLE) - SPEED).abs() < 1e-6);
}

/// The power of the motor is the rate of both energies; each turn of the crank is an event.
#[test]
fn power_balance() {
    let linkage = linkage();
    let accelerate =
        |_, [beta]: [f64; 1], [speed]: [f64; 1]| [linkage.motion(beta, speed, MOMENT).acceleration];
    let problem = Problem::new(accelerate)
        .start([START], [0.0])
        .tolerance(1e-12);
    let problem = (1..=2).fold(problem, |problem, turn| {
        problem.event(Event::input(
            0,
            START + f64::from(turn) * std::f64::consts::TAU,
        ))
    });
    let motion = problem.until(END).expect("a motion");
    let energy = |beta: f64, speed: f64| {
        let energy = linkage.energy(beta, speed);
        energy.kinetic + energy.potential
    };
    let first = energy(START, 0.0);
    for state in motion.states(40) {
        let ([beta], [speed]) = (state.inputs, state.speeds);
        let work = MOMENT * (beta - START);
        assert!(
            (energy(beta, speed) - first - work).abs() < 1e-9,
            "{}",
            state.time
        );
    }
    let work = motion.integral(|state| MOMENT * state.speeds[0]);
    assert!((work - MOMENT * (motion.end().inputs[0] - START)).abs() < 1e-11);
    // The spring has the same length after a turn: all work is kinetic.
    assert_eq!(motion.occurrences().len(), 2);
    for (turn, found) in (1..).zip(motion.occurrences()) {
        let kinetic = linkage
            .energy(found.state.inputs[0], found.state.speeds[0])
            .kinetic;
        let work = MOMENT * std::f64::consts::TAU * f64::from(turn);
        assert!((kinetic - work).abs() < 1e-10, "{kinetic} {work}");
    }
}

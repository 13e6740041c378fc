//! Motions of one and two inputs against quadrature, energies and closed forms.

use crate::{Conservative, Event, Motor, Problem, Reduced};

const CRANK: f64 = 0.05;
const ROD: f64 = 0.18;

/// A slider-crank: moment of inertia of the crank, mass of the piston. Inertia and its slope.
fn slider_crank(phi: f64) -> [f64; 2] {
    let (inertia, mass) = (0.002, 1.3);
    let (sin, cos) = phi.sin_cos();
    let ratio = CRANK / ROD;
    let root = (1.0 - ratio * ratio * sin * sin).sqrt();
    let slope = -CRANK * sin - CRANK * ratio * sin * cos / root;
    let square = ratio * ratio * sin * sin * cos * cos / (root * root);
    let second = -CRANK * cos - CRANK * ratio / root * (cos * cos - sin * sin + square);
    [inertia + mass * slope * slope, 2.0 * mass * slope * second]
}

/// Without forces the speed follows from the energy, and the time from a quadrature.
#[test]
fn slider_crank_by_quadrature() {
    let free = |_, [phi]: [f64; 1], [omega]: [f64; 1]| {
        let [inertia, slope] = slider_crank(phi);
        Reduced::one(inertia, -0.5 * slope * omega * omega)
    };
    let problem = Problem::reduced(free).start([0.3], [40.0]).tolerance(1e-13);
    let event = (1..=3).map(|turns| Event::input(0, 0.3 + f64::from(turns) * 2.0));
    let motion = event
        .fold(problem, Problem::event)
        .until(0.5)
        .expect("a motion");
    let energy = Conservative::new(|phi| [slider_crank(phi)[0], 0.0]).start(0.3, 40.0);
    // By Simpson's rule with so many points that only rounding is left.
    let simpson = |to: f64| {
        let count = 4000;
        let width = (to - 0.3) / f64::from(count);
        let values = (0..=count).map(|i| {
            let weight = match i {
                0 => 1.0,
                _ if i == count => 1.0,
                _ if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight / energy.speed(0.3 + width * f64::from(i))
        });
        values.sum::<f64>() * width / 3.0
    };
    assert_eq!(motion.occurrences().len(), 3);
    for found in motion.occurrences() {
        let input = found.state.inputs[0];
        let exact = simpson(input);
        assert!((found.state.time - exact).abs() < 1e-13, "{input}");
        assert!((energy.time(input).expect("a time") - exact).abs() < 1e-14);
        assert!((found.state.speeds[0] - energy.speed(input)).abs() < 1e-10);
    }
    let last = energy.input(0.5).expect("an input");
    assert!((motion.end().inputs[0] - last).abs() < 1e-11);
}

/// The work of a motor is the change of the kinetic energy and the heat of a damper.
#[test]
fn power_balance() {
    let motor = Motor::dc(24.0, 0.4, 0.05, 0.05).geared(8.0);
    let damping = 0.02;
    let drive = |_, [phi]: [f64; 1], [omega]: [f64; 1]| {
        let [inertia, slope] = slider_crank(phi);
        let moment = motor.torque(omega) - damping * omega;
        Reduced::one(inertia, moment - 0.5 * slope * omega * omega)
    };
    let motion = Problem::reduced(drive)
        .tolerance(1e-12)
        .until(0.4)
        .expect("a motion");
    let kinetic =
        |state: crate::State<1>| 0.5 * slider_crank(state.inputs[0])[0] * state.speeds[0].powi(2);
    let work = motion.integral(|state| motor.torque(state.speeds[0]) * state.speeds[0]);
    let heat = motion.integral(|state| damping * state.speeds[0].powi(2));
    let change = kinetic(motion.end()) - kinetic(motion.start());
    assert!(change > 1.0 && heat > 1.0, "{change} {heat}");
    assert!(
        (work - change - heat).abs() < 1e-9 * work,
        "{work} {change} {heat}"
    );
}

/// Two pendulums on each other: a full mass matrix keeps the energy.
#[test]
fn double_pendulum_keeps_its_energy() {
    let equation = |_, [a, b]: [f64; 2], [va, vb]: [f64; 2]| {
        let (sin, cos) = (a - b).sin_cos();
        Reduced {
            inertia: [[2.0, cos], [cos, 1.0]],
            force: [
                -sin * vb * vb - 2.0 * 9.81 * a.sin(),
                sin * va * va - 9.81 * b.sin(),
            ],
        }
    };
    let energy = |state: crate::State<2>| {
        let ([a, b], [va, vb]) = (state.inputs, state.speeds);
        let kinetic = va * va + 0.5 * vb * vb + va * vb * (a - b).cos();
        kinetic - 9.81 * (2.0 * a.cos() + b.cos())
    };
    let problem = Problem::reduced(equation).start([1.0, 2.0], [0.0, 0.0]);
    let motion = problem.tolerance(1e-12).until(3.0).expect("a motion");
    let first = energy(motion.start());
    for state in motion.states(50) {
        assert!((energy(state) - first).abs() < 1e-8, "{}", state.time);
    }
    assert!((energy(motion.end()) - first).abs() < 1e-9);
}

/// A motion begins at its time, is NaN outside, and may store no steps.
#[test]
fn times_and_stored_steps() {
    let problem = || Problem::new(|time: f64, _: [f64; 1], _| [time]).start_time(1.0);
    let motion = problem().until(3.0).expect("a motion");
    // `v = (t^2 - 1) / 2`, `q = t^3 / 6 - t / 2 + 1 / 3`.
    assert!((motion.end().speeds[0] - 4.0).abs() < 1e-12);
    assert!((motion.state(2.0).inputs[0] - 2.0 / 3.0).abs() < 1e-12);
    for time in [0.9, 3.1, f64::NAN] {
        assert!(motion.state(time).inputs[0].is_nan(), "{time}");
    }
    assert_eq!(motion.state(3.0), motion.end());
    assert_eq!(motion.state(1.0), motion.start());
    assert_eq!(motion.step_states().count(), motion.steps() + 1);
    assert_eq!(motion.states(5).count(), 5);
    let end = problem().only_end().until(3.0).expect("a motion");
    assert_eq!((end.end(), end.steps()), (motion.end(), motion.steps()));
    assert!(end.state(2.0).inputs[0].is_nan());
}

/// After an event that stops there is none, also within its step.
#[test]
fn events_end_with_the_one_that_stops() {
    let problem = Problem::new(|_, _: [f64; 1], _| [0.0]).start([0.0], [1.0]);
    let times = [0.75, 0.25, 0.5];
    let problem = times.into_iter().fold(problem, |problem, time| {
        let event = Event::new(move |state| state.time - time);
        problem.event(if time == 0.5 { event.stop() } else { event })
    });
    let motion = problem.until(1e3).expect("a motion");
    let found = motion.occurrences().iter().map(|found| found.event);
    assert_eq!(found.collect::<Vec<_>>(), [1, 2]);
    assert!((motion.end().inputs[0] - 0.5).abs() < 1e-14);
    let steps = motion.step_states().map(|state| state.time);
    assert!(steps.fold(0.0, f64::max) == motion.end().time);
}

/// A stiff spring with a damper carries a mass along `cos t`: few implicit steps, many explicit
/// ones.
#[test]
fn stiff_springs_need_the_implicit_method() {
    let follow = |t: f64, [q]: [f64; 1], [v]: [f64; 1]| {
        [-1e8 * (q - t.cos()) - 1e5 * (v + t.sin()) - t.cos()]
    };
    let problem = Problem::new(follow).start([1.0], [0.0]).tolerance(1e-8);
    let motion = problem
        .method(crate::Method::Implicit)
        .until(2.0)
        .expect("a motion");
    assert!((motion.end().inputs[0] - 2.0_f64.cos()).abs() < 1e-8);
    assert!(motion.steps() < 400, "{}", motion.steps());
    let problem = Problem::new(follow).start([1.0], [0.0]).tolerance(1e-8);
    let motion = problem.until(0.2).expect("a motion");
    assert!((motion.end().inputs[0] - 0.2_f64.cos()).abs() < 1e-8);
    assert!(motion.steps() > 1000, "{}", motion.steps());
}

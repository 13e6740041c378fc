//! Benchmarks of dynamics with published results.

use linkage::dynamics::{Conservative, Event, Method, Problem};
use linkage::mechanism;
use linkage_engine::Mechanism;
use std::f64::consts::{FRAC_PI_2, TAU};

// Andrews' squeezing mechanism against the reference of the test set for IVP solvers, with its error corrected.

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

// The engine with one cylinder of the Modelica Standard Library (`MultiBody.Examples.Loops.Engine1a`) against the results
// that the Modelica Association publishes for it.

mechanism! {
    /// Crankshaft with a flywheel, rod and piston of steel. The angle is that of the crank from the upper dead centre.
    struct Engine {
        unit m;
        const density = 7700kg/m^3;
        input phi = 0deg in 0deg..360deg at omega;
        unknown theta = -90deg;
        unknown y = 0.3m;
        let pin_end = polar(0.1m, phi + 90deg);
        loop (0, y) + polar(0.2m, theta) = pin_end;
        gravity = (0, -9.80665m/s^2);

        // Boxes and cylinders by their sides and diameters.
        let web = density * 0.1m * 0.02m * 0.05m;
        let journal = density * 3.141592653589793 * 0.025m * 0.025m * 0.1m;
        let throw = density * 3.141592653589793 * 0.015m * 0.015m * 0.1m;
        let bar = density * 0.2m * 0.02m * 0.06m;
        body shaft = pin on frame at (0, 0), turns phi,
            mass 2 * web at pin_end / 2, mass throw at pin_end,
            inertia 1kg*m^2 + journal * 0.025m * 0.025m / 2 + throw * 0.015m * 0.015m / 2
                + 2 * web * (0.1m * 0.1m + 0.05m * 0.05m) / 12;
        body rod = pin on shaft at pin_end, turns theta,
            mass bar at (pin_end + (0, y)) / 2, inertia bar * (0.2m * 0.2m + 0.06m * 0.06m) / 12;
        body piston = slide on frame at (0, y) along (0, 1),
            mass density * 3.141592653589793 * 0.05m * 0.05m * 0.1m at (0, y);
        pin small = rod on piston at (0, y);
    }
    impl Engine {
        fn free(phi, omega) -> Free { a: driven_acceleration(phi) }
        fn energy(phi, omega) -> EngineEnergy { kinetic: kinetic_energy(), potential: potential_energy() }
    }
}

/// Time, angle and speed in the published file.
const PUBLISHED: [[f64; 3]; 5] = [
    [0.05, 0.499_522_473_869_050_13, 9.979_868_751_666_928],
    [0.1, 1.000_415_441_129_349, 10.105_694_909_248_406],
    [0.2, 2.060_532_597_622_818_6, 11.178_709_805_561_917],
    [0.294, 3.140_694_375_159_326_6, 11.640_356_185_464_672],
    [5.0, 53.415_197_349_631_406, 11.640_358_486_979_379],
];

#[test]
fn engine_of_the_modelica_library() {
    let engine = Engine::default().assemble().expect("an assembly");
    let accelerate = |_, [phi]: [f64; 1], [omega]: [f64; 1]| [engine.free(phi, omega).a];
    let problem = Problem::new(accelerate).start([0.0], [10.0]);
    let motion = problem.tolerance(1e-12).until(5.0).expect("a motion");
    let integral = Conservative::new(|phi: f64| {
        let energy = engine.energy(phi, 1.0);
        [2.0 * energy.kinetic, -energy.potential]
    });
    let integral = integral.start(0.0, 10.0).period(TAU);
    for [time, angle, speed] in PUBLISHED {
        let state = motion.state(time);
        let off = [state.inputs[0] - angle, state.speeds[0] - speed];
        // The published solver has a tolerance of 1e-6.
        let parts = [off[0] / angle, off[1] / speed];
        assert!(
            parts.iter().all(|part| part.abs() < 4e-6),
            "{time}: {parts:?}"
        );
        let exact = integral.input(time).expect("an angle");
        assert!((state.inputs[0] - exact).abs() < 1e-9 * angle, "{time}");
    }
}

// N parallelograms in a row, a benchmark of the IFToMM Technical Committee for Multibody Dynamics (problem A02): rods of
// 1 m and 1 kg fall from the vertical with 1 m/s at their upper ends. All links are in line twice in each turn.

const GRAVITY: f64 = 9.81;

/// The text: rods on the frame, and a horizontal rod between the upper ends of two neighbours.
fn text(count: usize) -> String {
    let rods = (0..=count).map(|k| {
        format!(
            "body rod{k} = pin on frame at ({k}m, 0), turns phi,
                mass 1kg at ({k}m, 0) + end / 2, inertia 1kg*m^2 / 12;\n"
        )
    });
    let covers = (1..=count).map(|k| {
        let (left, middle) = (k - 1, format!("{}m", k as f64 - 0.5));
        format!(
            "body cover{k} = pin on rod{left} at ({left}m, 0) + end, turns 0deg,
                mass 1kg at ({middle}, 0) + end, inertia 1kg*m^2 / 12;
            pin corner{k} = cover{k} on rod{k} at ({k}m, 0) + end;\n"
        )
    });
    let bodies: String = rods.chain(covers).collect();
    format!(
        "pub struct FourBars {{
            unit m;
            input phi = 90deg in -3600deg..90deg at omega;
            gravity = (0, -{GRAVITY}m/s^2);
            let end = polar(1m, phi);
            {bodies}
        }}
        impl FourBars {{
            pub fn free(phi, omega) -> Free {{ a: driven_acceleration(phi) }}
            pub fn energy(phi, omega) -> Energy {{ kinetic: kinetic_energy(), potential: potential_energy() }}
        }}"
    )
}

fn mean(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// All rods turn alike, so that the period is that of a pendulum: by the arithmetic-geometric mean. Aligned links make no
/// difference.
#[test]
fn four_bars_turn_as_a_pendulum() {
    for count in [1, 2, 40] {
        let mechanism = Mechanism::compile(&text(count)).expect("a mechanism");
        let assembly = mechanism
            .assemble(&mechanism.dimensions())
            .expect("an assembly");
        let [free, energy] = ["free", "energy"].map(|name| mechanism.function(name).expect("it"));
        let accelerate =
            |_, [phi]: [f64; 1], [omega]: [f64; 1]| [assembly.call(free, &[phi, omega])[0]];
        let inertia = (count + 1) as f64 / 3.0 + count as f64;
        let weight = ((count + 1) as f64 / 2.0 + count as f64) * GRAVITY;
        // `omega^2 = 1 + 2 weight / inertia (1 - sin phi)`.
        let turn = TAU / mean((1.0 + 4.0 * weight / inertia).sqrt(), 1.0);
        let start = Problem::new(accelerate).start([FRAC_PI_2], [-1.0]);
        let problem = (1..=4).fold(start.tolerance(1e-12), |problem, turns| {
            problem.event(Event::input(0, FRAC_PI_2 - f64::from(turns) * TAU))
        });
        let motion = problem.until(10.0).expect("a motion");
        assert_eq!(motion.occurrences().len(), ((10.0 / turn) as usize).min(4));
        for (turns, found) in (1..).zip(motion.occurrences()) {
            let off = found.state.time - f64::from(turns) * turn;
            assert!(off.abs() < 1e-9, "{count}, {turns}: {off:e}");
        }
        let values = |phi: f64, omega: f64| assembly.call(energy, &[phi, omega]);
        let total = |phi: f64, omega: f64| values(phi, omega).iter().sum::<f64>();
        let end = motion.end();
        let drift = total(end.inputs[0], end.speeds[0]) / total(FRAC_PI_2, -1.0) - 1.0;
        assert!(drift.abs() < 1e-10, "{count}: {drift:e}");
        let integral = Conservative::new(|phi: f64| {
            let [kinetic, potential] = values(phi, 1.0)[..] else {
                panic!("two energies");
            };
            [2.0 * kinetic, -potential]
        });
        let time = integral.start(FRAC_PI_2, -1.0).time(FRAC_PI_2 - TAU);
        assert!((time.expect("a time") - turn).abs() < 1e-12);
    }
}

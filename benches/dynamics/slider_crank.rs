//! A slider-crank under its weight: the drift of its energy, its motion as a problem for all solvers.

use crate::comparison::Method;
use crate::links::{Coupling, Links, Loop, Part};
use crate::task::Task;
use linkage::dynamics::{Conservative, Problem};
use linkage_peers::timing::only_tested;
use std::error::Error;
use std::f64::consts::TAU;
use std::time::Instant;

linkage::mechanism! {
    /// A conservative slider-crank with a weight.
    struct SliderCrank {
        unit m;
        input phi = 0deg in 0deg..360deg at omega;
        unknown theta = 0deg;
        unknown x = 0.23m;
        let p = polar(0.05m, phi);
        loop p + polar(0.18m, theta) = (x, 0);
        gravity = (0, -9.80665m/s^2);
        body wheel = pin on frame at (0, 0), turns phi, mass 0.5kg at p / 3, inertia 0.002kg*m^2;
        body rod = pin on wheel at p, turns theta, mass 0.4kg at (p + (x, 0)) / 2, inertia 0.001kg*m^2;
        body piston = slide on frame at (x, 0) along (1, 0), mass 1.3kg at (x, 0);
        pin end = rod on piston at (x, 0);
    }
    impl SliderCrank {
        fn free(phi, omega) -> CrankFree { acceleration: driven_acceleration(phi) }
        fn energy(phi, omega) -> CrankEnergy { kinetic: kinetic_energy(), potential: potential_energy() }
    }
}

/// Speed at the start, rad/s, and the time of the task in s.
const SPEED: f64 = 40.0;
const END: f64 = 1.0;
/// The angle at the end by quadrature with 50 digits: `benches/dynamics_rivals/solutions.py`.
const SOLUTION: f64 = 30.096_547_912_905_86;

/// The same links with a coordinate for each body: the angles of wheel and rod, the place of the piston.
fn links() -> Links {
    const GRAVITY: f64 = 9.80665;
    let [wheel, rod, piston] = [0.5, 0.4, 1.3];
    let [crank, length] = [0.05, 0.18];
    let [first, second] = [crank / 3.0, length / 2.0];
    let arm = |length| Part::Arm { length, shift: 0.0 };
    let parts = vec![(0, arm(crank)), (1, arm(length)), (2, Part::Slide(-1.0))];
    Links {
        inertias: vec![
            wheel * first * first + 0.002 + rod * crank * crank,
            rod * second * second + 0.001,
            piston,
        ],
        couplings: vec![Coupling {
            coordinates: [0, 1],
            moment: rod * crank * second,
            shift: 0.0,
        }],
        loops: vec![Loop {
            constant: [0.0, 0.0],
            parts,
        }],
        moments: vec![0.0; 3],
        weights: vec![
            GRAVITY * (wheel * first + rod * crank),
            GRAVITY * rod * second,
            0.0,
        ],
        spring: None,
    }
}

/// Returns all methods for a second of the motion.
pub(crate) fn methods() -> Result<Vec<Method>, Box<dyn Error>> {
    let linkage = SliderCrank::default().assemble()?;
    let task = Task {
        links: links(),
        positions: vec![0.0, 0.0, 0.23],
        speeds: vec![SPEED, -SPEED * 0.05 / 0.18, 0.0],
        end: END,
        solution: SOLUTION,
    };
    let explicit = |tolerance: f64| {
        let accelerate =
            |_, [phi]: [f64; 1], [omega]: [f64; 1]| [linkage.free(phi, omega).acceleration];
        let problem = Problem::new(accelerate)
            .start([0.0], [SPEED])
            .tolerance(tolerance)
            .only_end();
        task.run(|end| Some(problem.until(end).ok()?.end().inputs[0]))
    };
    let energy = |tolerance: f64| {
        let function = |input: f64| {
            let energy = linkage.energy(input, 1.0);
            [2.0 * energy.kinetic, -energy.potential]
        };
        let integral = Conservative::new(function).start(0.0, SPEED);
        let integral = integral.period(TAU).tolerance(tolerance);
        task.run(|end| integral.input(end).ok())
    };
    let mut methods = vec![
        Method::ours("ours, Problem, explicit", 3..=13, explicit),
        Method::ours("ours, Conservative", 2..=12, energy),
    ];
    methods.extend(task.others());
    Ok(methods)
}

/// The energy after many turns: by the integrator, and by the energy integral.
pub(crate) fn drift() -> Result<(), Box<dyn Error>> {
    let linkage = SliderCrank::default().assemble()?;
    let energy = |input: f64, speed: f64| {
        let energy = linkage.energy(input, speed);
        energy.kinetic + energy.potential
    };
    let first = energy(0.0, SPEED);
    let function = |input: f64| {
        let energy = linkage.energy(input, 1.0);
        [2.0 * energy.kinetic, -energy.potential]
    };
    let integral = Conservative::new(function).start(0.0, SPEED).period(TAU);
    let turn = integral.time(TAU)?;
    println!("slider-crank: turns, drift of the energy, off in the angle, s");
    let turns = if only_tested() {
        [1.0, 10.0]
    } else {
        [1e2, 1e4]
    };
    for turns in turns {
        let accelerate =
            |_, [phi]: [f64; 1], [omega]: [f64; 1]| [linkage.free(phi, omega).acceleration];
        let problem = Problem::new(accelerate)
            .start([0.0], [SPEED])
            .tolerance(1e-13)
            .most_steps(usize::MAX)
            .only_end();
        let start = Instant::now();
        let end = problem.until(turns * turn)?.end();
        let drift = energy(end.inputs[0], end.speeds[0]) / first - 1.0;
        let off = end.inputs[0] - turns * TAU;
        let time = start.elapsed().as_secs_f64();
        println!("  explicit 1e-13 {turns:9.0} {drift:9.1e} {off:9.1e} {time:9.6}");
    }
    for turns in [1e2, 1e4, 1e6] {
        let start = Instant::now();
        let input = integral.input((turns + 0.25) * turn)?;
        let drift = energy(input, integral.speed(input)) / first - 1.0;
        let off = input - turns * TAU - integral.input(0.25 * turn)?;
        let time = start.elapsed().as_secs_f64();
        println!("  energy         {turns:9.0} {drift:9.1e} {off:9.1e} {time:9.6}");
    }
    Ok(())
}

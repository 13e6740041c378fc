//! N parallelograms in a row, a benchmark of the IFToMM Technical Committee for Multibody Dynamics (problem A02): rods of
//! 1 m and 1 kg fall from the vertical with 1 m/s at their upper ends. All links are in line twice in each turn.

use linkage::dynamics::{Conservative, Event, Problem};
use linkage_engine::Mechanism;
use std::f64::consts::{FRAC_PI_2, TAU};

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

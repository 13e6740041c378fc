//! Motion under forces of mechanisms of the macro, against published numbers, energies and closed forms.

mod energies;
mod published;

use linkage::dynamics::{Event, Problem, Reduced, self_locking};
use linkage::mechanism;

// Machines that friction brakes: the energy becomes heat, and a load that locks itself stays.

mechanism! {
    /// A slider-crank with dry joints that runs down.
    struct RunDown {
        unit mm;
        argument load = 0N;
        input phi = 0deg in 0deg..360deg at omega, epsilon;
        unknown theta = 0deg;
        unknown x     = 150mm;
        let p = polar(30mm, phi);
        loop p + polar(120mm, theta) = (x, 0);
        body wheel  = pin a on frame at (0, 0), turns phi, inertia 20000kg*mm^2;
        body link   = pin b on wheel at p, turns theta, mass 0.6kg at (p + (x, 0)) / 2, inertia 700kg*mm^2;
        body piston = slide c on frame at (x, 0) along (1, 0), mass 1.5kg at (x, 0);
        pin d = link on piston at (x, 0);
        force (-load, 0) on piston at (x, 0);
        friction 0.1 on a, radius 15mm;
        friction 0.1 on b, radius 12mm;
        friction 0.1 on d, radius 10mm;
        friction 0.15 on c;
    }
    impl RunDown {
        fn free(phi, omega, load) -> Free { a: driven_acceleration(phi), j: inertia(phi) }
        fn losses(phi, omega, epsilon, load) -> Losses { heat: friction_power(), drive: torque(phi) }
        fn energy(phi, omega) -> Energy { e: kinetic_energy() }
        fn efficiency(phi, omega, load) -> Efficiency { eta: efficiency() }
    }
}

#[test]
fn the_energy_of_a_machine_that_runs_down_is_heat() {
    let machine = RunDown::default().assemble().expect("an assembly");
    let free = |phi: f64, omega: f64| machine.free(phi, omega, 0.0).a;
    let motion = Problem::new(|_, [phi], [omega]: [f64; 1]| [free(phi, omega)])
        .start([0.3], [60.0])
        .tolerance(1e-11)
        .event(Event::new(|state| state.speeds[0] - 30.0).stop())
        .until(100.0)
        .expect("it reaches the event");
    let end = motion.end();
    assert!((end.speeds[0] - 30.0).abs() < 1e-9, "{end:?}");
    let heat = motion.integral(|state| {
        let (phi, omega) = (state.inputs[0], state.speeds[0]);
        let losses = machine.losses(phi, omega, free(phi, omega), 0.0);
        // No drive is left.
        assert!(losses.drive.abs() < 1e-7, "{}", losses.drive);
        losses.heat
    });
    let energies = [[0.3, 60.0], [end.inputs[0], end.speeds[0]]]
        .map(|[phi, omega]| machine.energy(phi, omega).e);
    let lost = energies[0] - energies[1];
    assert!((heat - lost).abs() < 1e-6 * lost, "{heat} {lost}");
    // The same motion from the equation that the questions of machines take. The acceleration jumps
    // where a joint reverses, and steps over such a place are less accurate.
    let accelerations = |_, [phi]: [f64; 1], [omega]: [f64; 1]| [free(phi, omega)];
    let reduced = |_, [phi]: [f64; 1], [omega]: [f64; 1]| {
        let at = machine.free(phi, omega, 0.0);
        Reduced::one(1e-3 * at.j, 1e-3 * at.j * at.a)
    };
    let first = Problem::new(accelerations)
        .start([0.3], [60.0])
        .tolerance(1e-11)
        .until(0.5);
    let again = Problem::reduced(reduced)
        .start([0.3], [60.0])
        .tolerance(1e-11)
        .until(0.5);
    let [first, again] = [first, again].map(|motion| motion.expect("a motion").end().inputs[0]);
    assert!((first - again).abs() < 1e-6 * first, "{first} {again}");
}

/// A slow load drives the crank only where its arm is longer than those of friction.
#[test]
fn a_load_locks_itself_near_the_dead_point() {
    let machine = RunDown::default().assemble().expect("an assembly");
    let efficiency = |phi: f64| machine.efficiency(phi, 1e-9, 500.0).eta;
    let locked = self_locking(efficiency, [0.01, 3.13], 200);
    assert_eq!(locked.len(), 2, "{locked:?}");
    for limit in [locked[0].end, locked[1].start] {
        // The force of the rod touches the friction circles at its ends. Its lever about the crank's
        // pin is used up by the friction in both pins of the crank.
        let theta = (-30.0 * limit.sin() / 120.0).asin();
        let turn = -30.0 * limit.cos() / (120.0 * theta.cos());
        let line = theta - ((1.2 * (turn - 1.0).signum() + turn.signum()) / 120.0).asin();
        let lever = 30.0 * (line - limit).sin() - 1.2 * (turn - 1.0).signum() + 1.5;
        assert!(lever.abs() < 1e-9, "{limit}: {lever}");
    }
}

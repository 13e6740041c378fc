//! A five-bar with two inputs: it keeps its energy, and oscillates about its equilibrium.

use linkage::dynamics::{Problem, natural_modes};
use linkage::mechanism;

mechanism! {
    /// Two cranks on the frame with springs, and two links between them.
    struct FiveBar {
        unit m;
        input a = 100deg in 85deg..115deg at va;
        input b = 80deg in 65deg..95deg at vb;
        unknown p = 30deg;
        unknown q = 150deg;
        let c = polar(0.2m, a);
        let d = (0.3m, 0) + polar(0.2m, b);
        loop c + polar(0.25m, p) = d + polar(0.25m, q);
        gravity = (0, -9.80665m/s^2);
        body left = pin base_a on frame at (0, 0), turns a, mass 0.4kg at c / 2, inertia 0.002kg*m^2;
        body right = pin base_b on frame at (0.3m, 0), turns b, mass 0.4kg at (d + (0.3m, 0)) / 2, inertia 0.002kg*m^2;
        body first = pin on left at c, turns p, mass 0.3kg at c + polar(0.125m, p), inertia 0.0015kg*m^2;
        body second = pin on right at d, turns q, mass 0.3kg at d + polar(0.125m, q), inertia 0.0015kg*m^2;
        pin e = first on second at d + polar(0.25m, q);
        spring 40N*m on base_a, free 100deg;
        spring 40N*m on base_b, free 80deg;
    }
    impl FiveBar {
        fn free(a, b, va, vb) -> Free { first: driven_acceleration(a), second: driven_acceleration(b) }
        fn energy(a, b, va, vb) -> Energy { kinetic: kinetic_energy(), potential: potential_energy() }
    }
}

#[test]
fn two_inputs_keep_their_energy_and_oscillate() {
    let bar = FiveBar::default().assemble().expect("an assembly");
    let accelerate = |_, [a, b]: [f64; 2], [va, vb]: [f64; 2]| {
        let free = bar.free(a, b, va, vb);
        [free.first, free.second]
    };
    let energy = |[a, b]: [f64; 2], [va, vb]: [f64; 2]| {
        let energy = bar.energy(a, b, va, vb);
        energy.kinetic + energy.potential
    };
    let start = [105_f64.to_radians(), 78_f64.to_radians()];
    let motion = Problem::new(accelerate)
        .start(start, [0.5, -1.0])
        .tolerance(1e-11)
        .until(0.5);
    let motion = motion.expect("a motion");
    let first = energy(start, [0.5, -1.0]);
    for state in motion.states(50) {
        let off = energy(state.inputs, state.speeds) - first;
        assert!(off.abs() < 1e-8, "{} {off:e}", state.time);
    }
    // The equilibrium with dampers, and small oscillations about it.
    let damped = |t: f64, q: [f64; 2], v: [f64; 2]| {
        let [first, second] = accelerate(t, q, v);
        [first - 40.0 * v[0], second - 40.0 * v[1]]
    };
    let rest = Problem::new(damped)
        .start(start, [0.0, 0.0])
        .tolerance(1e-12)
        .until(30.0);
    let rest = rest.expect("rest").end().inputs;
    let modes = natural_modes(|q, v| accelerate(0.0, q, v), rest).expect("two modes");
    assert_eq!(modes.len(), 2);
    // Rayleigh: the energies of the slow mode, from a motion over one of its periods.
    let period = std::f64::consts::TAU / modes[0].angular_frequency;
    assert!(
        modes.iter().all(|mode| mode.decay.abs() < 1e-5),
        "{modes:?}"
    );
    let shift = 1e-5;
    let symmetric = [rest[0] + shift, rest[1] - shift];
    let opposite = [rest[0] + shift, rest[1] + shift];
    let returns = [symmetric, opposite].map(|start| {
        let motion = Problem::new(accelerate)
            .start(start, [0.0, 0.0])
            .tolerance(1e-12);
        [0, 1].map(|mode: usize| {
            let period = std::f64::consts::TAU / modes[mode].angular_frequency;
            let end = motion.until(period).expect("a motion").end();
            (end.inputs[0] - start[0])
                .abs()
                .max((end.inputs[1] - start[1]).abs())
        })
    });
    // The mechanism is symmetric: each start is one mode, and returns after the period of it.
    let best = returns.map(|[a, b]| a.min(b));
    assert!(
        best.iter().all(|off| *off < 1e-3 * shift),
        "{returns:?} {period}"
    );
}

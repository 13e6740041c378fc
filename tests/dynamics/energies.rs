//! Energies of motions: those that are kept, dead points, equilibria, and derivatives of times.

use linkage::dynamics::{Cause, Conservative, Problem, Reduced, equilibria, natural_modes};
use linkage::{Dual, Scalar, mechanism};
use num_dual::Dual64;

// A five-bar with two inputs: it keeps its energy, and oscillates about its equilibrium.

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

// A four-bar that its rocker drives into a dead point.

mechanism! {
    struct Rocker {
        unit mm;
        input psi = 120deg in 92deg..151deg at omega;
        unknown theta = 20deg;
        unknown phi = 75deg;
        loop polar(50mm, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi);
        body crank = pin on frame at (0, 0), turns phi, inertia 3000kg*mm^2;
        body coupler = pin on crank at polar(50mm, phi), turns theta;
        body rocker = pin on frame at (140mm, 0), turns psi;
        pin c = coupler on rocker at (140mm, 0) + polar(100mm, psi);
    }
    impl Rocker {
        fn crank(psi) -> Crank { phi, slope: velocity(phi) }
        fn parts(psi, omega) -> Parts { j: inertia(psi), bias: bias(psi) }
    }
}

/// Only the crank has inertia, so that it turns evenly: the dead point is where it has turned to the line of the
/// coupler, which lengths determine.
#[test]
fn a_rocker_ends_at_its_dead_point() {
    let rocker = Rocker::default().assemble().expect("an assembly");
    let start = 120_f64.to_radians();
    let equation = |_, [psi]: [f64; 1], [omega]: [f64; 1]| {
        let parts = rocker.parts(psi, omega);
        Reduced::from_parts(1e-3, [[parts.j]], [parts.bias], [0.0])
    };
    for (reach, sign) in [(170.0, -1.0), (70.0, 1.0)] {
        let problem = Problem::reduced(equation)
            .start([start], [sign * 3.0])
            .tolerance(1e-11);
        let error = problem.until(10.0).expect_err("a dead point");
        let Cause::DeadPoint { state, input: 0 } = error.cause() else {
            panic!("{error}");
        };
        let cos: f64 = (reach * reach - 29_600.0) / 28_000.0;
        let last = cos.acos();
        assert!((state.inputs[0] - last).abs() < 1e-7, "{error}");
        let crank = rocker.crank(start);
        let speed = sign * 3.0 * crank.slope;
        let line = (100.0 * last.sin()).atan2(140.0 + 100.0 * last.cos());
        let line = if reach < 100.0 {
            line + std::f64::consts::PI
        } else {
            line
        };
        let turned = (line - crank.phi + 0.5 * std::f64::consts::TAU)
            .rem_euclid(std::f64::consts::TAU)
            - 0.5 * std::f64::consts::TAU;
        let time = turned / speed;
        assert!((state.time - time).abs() < 1e-6 * time, "{error} {time}");
        // The motion up to there is kept: half of the turn at half of the time.
        let middle = error.motion().state(0.5 * time).inputs[0];
        let crank_there = rocker.crank(middle).phi;
        assert!((crank_there - crank.phi - 0.5 * turned).abs() < 1e-8);
    }
}

// The integral of the energy over dual numbers: derivatives of times and inputs.

type Number = Dual<Dual64>;

/// A pendulum from rest at 2 rad: with the gravity `g` all times are those for `g = 1` over the root of `g`.
#[test]
fn times_and_inputs_with_respect_to_gravity() {
    let gravity = Dual(Dual64::new(9.81, 1.0));
    let function = |phi: Number| {
        let (_, cos) = phi.sin_cos();
        [Number::from_f64(1.0), gravity * cos]
    };
    let force = |phi: Number| -(gravity * phi.sin_cos().0);
    let [start, rest] = [2.0, 0.0].map(Number::from_f64);
    let pendulum = Conservative::new(function).start(start, rest).force(force);
    let time = pendulum.time(Number::from_f64(-1.0)).expect("a time").0;
    let known = -0.5 * time.re / 9.81;
    assert!((time.eps - known).abs() < 1e-13, "{} {known}", time.eps);
    // The input at a fixed time moves on as at a time that is longer by `time / (2 g)`.
    let input = pendulum.input(Number::from_f64(time.re)).expect("an input");
    let speed = -pendulum.speed(input).0.re;
    let known = speed * 0.5 * time.re / 9.81;
    assert!((input.0.re + 1.0).abs() < 1e-14);
    assert!(
        (input.0.eps - known).abs() < 1e-12,
        "{} {known}",
        input.0.eps
    );
}

// A lid on a spring: equilibria and frequencies against the potential energy.

mechanism! {
    /// A lid of 12 kg that a spring from the frame holds.
    struct Lid {
        unit mm;
        input phi = 20deg in -30deg..110deg at omega;
        gravity = (0, -9.80665m/s^2);
        body lid = pin on frame at (0, 0), turns phi, mass 12kg at polar(500mm, phi), inertia 0.4kg*m^2;
        spring 1.1N/mm from frame at (80mm, -420mm) to lid at polar(260mm, phi), free 320mm;
    }
    impl Lid {
        fn parts(phi, omega) -> LidParts { j: inertia(phi), bias: bias(phi), force: generalised_force(phi) }
        fn kinetic(phi, omega) -> Kinetic { e: kinetic_energy() }
        fn energy(phi) -> LidEnergy { v: potential_energy() }
    }
}

#[test]
fn equilibria_are_extremes_of_the_potential() {
    let lid = Lid::default().assemble().expect("an assembly");
    let force = |phi: f64| {
        let parts = lid.parts(phi, 0.0);
        parts.force - parts.bias
    };
    let range = [-30_f64, 110.0].map(f64::to_radians);
    let found = equilibria(force, range, 100);
    assert!(!found.is_empty(), "a lid without equilibrium");
    for equilibrium in found {
        let step = 1e-3;
        let potential = [-step, 0.0, step].map(|x| lid.energy(equilibrium.input + x).v);
        let curvature = (potential[0] + potential[2] - 2.0 * potential[1]) / (step * step);
        let slope = (potential[2] - potential[0]) / (2.0 * step);
        assert!(slope.abs() < 1e-4 * curvature.abs(), "{slope}");
        let off = equilibrium.stiffness - curvature;
        assert!(
            off.abs() < 1e-4 * curvature.abs(),
            "{curvature} {equilibrium:?}"
        );
        // Small oscillations, or the fall from there.
        let accelerate = |[phi]: [f64; 1], [omega]: [f64; 1]| {
            let parts = lid.parts(phi, omega);
            Reduced::from_parts(1e-3, [[parts.j]], [parts.bias], [parts.force]).accelerations()
        };
        let modes = natural_modes(accelerate, [equilibrium.input]).expect("modes");
        let inertia = 2.0 * lid.kinetic(equilibrium.input, 1.0).e;
        let square = modes[0].angular_frequency.powi(2) - modes[0].decay.powi(2);
        assert!(
            (square * inertia / equilibrium.stiffness - 1.0).abs() < 1e-6,
            "{modes:?}"
        );
        assert_eq!(equilibrium.is_stable(), modes[0].angular_frequency > 0.0);
    }
}

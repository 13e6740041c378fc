//! A lid on a spring: equilibria and frequencies against the potential energy.

use linkage::dynamics::{Reduced, equilibria, natural_modes};
use linkage::mechanism;

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
        fn parts(phi, omega) -> Parts { j: inertia(phi), bias: bias(phi), force: generalised_force(phi) }
        fn kinetic(phi, omega) -> Kinetic { e: kinetic_energy() }
        fn energy(phi) -> Energy { v: potential_energy() }
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

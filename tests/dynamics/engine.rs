//! The engine with one cylinder of the Modelica Standard Library (`MultiBody.Examples.Loops.Engine1a`) against the results
//! that the Modelica Association publishes for it.

use linkage::dynamics::{Conservative, Problem};
use linkage::mechanism;
use std::f64::consts::TAU;

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
        fn energy(phi, omega) -> Energy { kinetic: kinetic_energy(), potential: potential_energy() }
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

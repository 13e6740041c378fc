//! Derivatives of points and axes against differences and the rotation of a rigid body.

use linkage::Vector3;

use crate::{Bar, angles, bar, coupler};

/// Step of central differences.
const STEP: f64 = 1e-5;

#[test]
fn velocity_and_acceleration_of_a_point() {
    for phi in angles() {
        let motion = bar().motion(phi);
        let [before, after] = [-STEP, STEP].map(|step| bar().motion(phi + step));
        let slope = (after.tip - before.tip) / (2.0 * STEP);
        assert!((motion.v - slope).norm() < 1e-6 * (1.0 + slope.norm()));
        let slope = (after.v - before.v) / (2.0 * STEP);
        assert!((motion.a - slope).norm() < 1e-6 * (1.0 + slope.norm()));
        let [before, after] = [-STEP, STEP].map(|step| bar().pose(phi + step).body.y);
        let slope = (after - before) / (2.0 * STEP);
        assert!((motion.spin - slope).norm() < 1e-8);
        // An axis keeps its length.
        assert!(motion.spin.dot(&bar().pose(phi).body.y).abs() < 1e-14);
    }
}

#[test]
fn sensitivities_of_a_point() {
    let phi = 0.7;
    let found = bar().errors(phi);
    let tip = |values: [f64; 7]| {
        let bar = Bar {
            crank: values[0],
            guide: Vector3::new(values[1], values[2], values[3]),
            tool: Vector3::new(values[4], values[5], values[6]),
        };
        bar.assemble().expect("no loops").pose(phi)
    };
    let nominal: [f64; 7] = std::array::from_fn(|k| Bar::PARAMETERS[k].nominal);
    for (parameter, derivative) in found.e.iter().enumerate() {
        let [before, after] = [-1e-4, 1e-4].map(|step| {
            let mut values = nominal;
            values[parameter] += step;
            tip(values)
        });
        let slope = (after.tip - before.tip) / 2e-4;
        assert!((derivative - slope).norm() < 1e-7, "{parameter}");
        if parameter == Bar::INDEX_GUIDE_Z {
            let slope = (after.body.z - before.body.z) / 2e-4;
            assert!((found.twist - slope).norm() < 1e-9);
        }
    }
    // Moving the tool along an axis moves the tip along it.
    assert!((found.e[Bar::INDEX_TOOL_Y] - bar().pose(phi).body.y).norm() < 1e-15);
}

#[test]
fn a_coupler_turns_about_the_normal() {
    for phi in angles().take(8) {
        let step = 1e-5;
        let [before, now, after] = [-step, 0.0, step].map(|step| coupler().tool(phi + step));
        let turn = (after.theta - before.theta) / (2.0 * step);
        let pin = Vector3::new(40.0 * phi.cos(), 40.0 * phi.sin(), 25.0);
        let pin_speed = Vector3::new(-pin.y, pin.x, 0.0);
        let expected = pin_speed + Vector3::z().cross(&(now.tool - pin)) * turn;
        let found = (after.tool - before.tool) / (2.0 * step);
        assert!((found - expected).norm() < 1e-6);
        assert_eq!(now.tool.z, 20.0);
    }
}

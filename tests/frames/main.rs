//! Frames: values, derivatives, sweeps and scalars of what is computed with them, and what it costs.

mod plane;
mod values;

use linkage::{Operations, Structure, Vector3, mechanism};

mechanism! {
    /// A bar between a crank pin and a slider that moves across the crank's plane, a tool on it.
    pub struct Bar {
        unit mm;
        param crank = 40mm;
        param guide = (120mm, 30mm, 0mm);
        param tool = (15mm, -20mm, 8mm);
        input phi = 20deg in 0deg..360deg;
        let pin = (crank * cos(phi), crank * sin(phi), 0);
        let slider = guide + (0, 0, crank * sin(phi) + 50mm);
        let body = frame(pin, slider - pin, (0, 1, 3));
        let tip = point_in(body, tool);
    }

    impl Bar {
        pub fn pose(phi) -> Pose { body, pin, slider, tip }
        pub fn back(phi) -> Back { local: coordinates_in(body, tip), end: coordinates_in(body, slider) }
        pub fn motion(phi) -> Motion { tip, v: velocity(tip), a: acceleration(tip), spin: velocity(body.y) }
        pub fn errors(phi) -> Errors { tip, e: sensitivity(tip), twist: d(body.z, guide.z) }
        pub fn parts(phi) -> Parts { origin: body.origin, x: body.x, y: body.y, z: body.z }
    }
}

mechanism! {
    /// A planar four-bar; frames of its coupler, one turned over, and a constant one.
    pub struct Coupler {
        unit mm;
        const fixed = frame((1mm, 2mm, 3mm), (0, 2mm, 0), (0, 1, -5));
        param crank = 40mm;
        param coupler = 50mm;
        param height = 25mm;
        input phi = 40deg;
        unknown theta = 60deg;
        unknown psi = 120deg;
        let pin = polar(crank, phi);
        loop pin + polar(coupler, theta) = (100mm, 0) + polar(80mm, psi);
        let centre = (pin.x, pin.y, height);
        let along = (cos(theta), sin(theta), 0);
        let body = frame(centre, along, (0, 0, 1));
        let under = frame(centre, coupler * along, (0, 0, -coupler));
    }

    impl Coupler {
        pub fn both(phi) -> Both { body, under, theta }
        pub fn body(phi) -> Body { body }
        pub fn by_hand(phi) -> ByHand { centre, along }
        pub fn tool(phi) -> Tool { tool: point_in(body, (30mm, 10mm, -5mm)), theta }
        pub fn constant() -> Constant { fixed }
        pub fn in_fixed(phi) -> InFixed { c: coordinates_in(fixed, centre) }
    }
}

mechanism! {
    /// Directions that become parallel.
    pub struct Parallel {
        input a = 1;
        let body = frame((0, 0, 0), (a, 0, 1), (0, 0, 2));
    }

    impl Parallel {
        pub fn body(a) -> ParallelBody { body }
    }
}

fn bar() -> BarAssembly {
    Bar::default().assemble().expect("nothing has to close")
}

fn coupler() -> CouplerAssembly {
    Coupler::default().assemble().expect("the links reach")
}

fn angles() -> impl Iterator<Item = f64> {
    (0..40).map(|k| 0.16 * f64::from(k) + 0.01)
}

// What is not asked for of a frame is not computed.

mechanism! {
    pub struct Sliced {
        unit mm;
        param out = 30mm;
        input phi = 20deg;
        input s = 10mm;
        let origin = (s, 0, 40mm);
        let x = (s, 20mm * cos(phi), 30mm);
        let z = (sin(phi), 2, 1);
        let body = frame(origin, x, z);
    }

    impl Sliced {
        pub fn origin(s) -> SlicedOrigin { o: body.origin }
        pub fn plain_origin(s) -> SlicedPlainOrigin { o: origin }
        pub fn x(phi, s) -> SlicedX { x: body.x }
        pub fn unit_x(phi, s) -> SlicedUnit { x: unit(x) }
        pub fn on_x(phi, s) -> SlicedOnX { p: point_in(body, (out, 0, 0)) }
        pub fn on_x_plain(phi, s) -> SlicedOnXPlain { p: origin + out * unit(x) }
        pub fn z(phi, s) -> SlicedZ { z: body.z }
        pub fn whole(phi, s) -> SlicedWhole { body }
        pub fn height(phi, s) -> SlicedHeight { h: point_in(body, (out, out, out)).z }
        pub fn twice(phi, s) -> SlicedTwice { body, again: body, x: body.x, o: body.origin }
        pub fn at_origin(s) -> SlicedAtOrigin { p: point_in(body, 0), c: origin }
    }
}

fn cost(structure: &Structure, name: &str) -> Operations {
    let function = structure.functions.iter().find(|f| f.name == name);
    function.expect("the function is listed").operations
}

fn sliced(name: &str) -> Operations {
    cost(Sliced::STRUCTURE, name)
}

#[test]
fn parts_cost_what_they_need() {
    assert_eq!(sliced("origin").total(), 0);
    assert_eq!(sliced("at_origin").total(), 0);
    assert_eq!(sliced("origin"), sliced("plain_origin"));
    assert_eq!(sliced("x"), sliced("unit_x"));
    assert_eq!(sliced("on_x"), sliced("on_x_plain"));
    assert_eq!((sliced("x").sqrt, sliced("z").sqrt), (1, 2));
    assert!(sliced("height").total() < sliced("whole").total());
    assert_eq!(sliced("twice"), sliced("whole"));
}

#[test]
fn a_frame_of_the_plane_costs_its_angle() {
    let [body, by_hand] = ["body", "by_hand"].map(|name| cost(Coupler::STRUCTURE, name));
    // Minus the sine, that of a link with its length in it.
    assert!(body.mul <= by_hand.mul + 1);
    assert_eq!(
        Operations {
            mul: by_hand.mul,
            ..body
        },
        by_hand
    );
    assert_eq!(cost(Coupler::STRUCTURE, "constant").total(), 0);
}

// Derivatives of points and axes against differences and the rotation of a rigid body.

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

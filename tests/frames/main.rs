//! Frames: values, derivatives, sweeps and scalars of what is computed with them, and what it costs.

mod cost;
mod derivatives;
mod plane;
mod values;

use linkage::mechanism;

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

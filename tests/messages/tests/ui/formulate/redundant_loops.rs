//! Loops that are said to follow from the others and do not: by how much, and where.

use linkage::mechanism;

mechanism! {
    /// The third wheel of a locomotive is coupled at a point that is 0.2 mm off.
    pub struct Wheels {
        unit mm;
        param crank = 40mm;
        param base = 100mm;
        input phi = 30deg in 10deg..170deg;
        unknown theta = 0deg;
        unknown psi = 30deg;
        let pin = polar(crank, phi);
        loop pin + polar(base, theta) = (base, 0mm) + polar(crank, psi);
        loop distance(pin + polar(2 * base, theta), (2 * base + 0.2mm, 0mm)) = crank redundant;
    }
    impl Wheels {
        pub fn motion(phi) -> Motion { theta, psi }
    }
}

mechanism! {
    /// Angles and vectors: the last one holds.
    pub struct Kinds {
        unit mm;
        param crank = 40mm;
        param base = 100mm;
        input phi = 30deg in 10deg..170deg;
        unknown theta = 0deg;
        unknown psi = 30deg;
        let pin = polar(crank, phi);
        loop pin + polar(base, theta) = (base, 0mm) + polar(crank, psi);
        loop psi = phi + 1deg redundant;
        loop pin + polar(base, theta) = (base, 3mm) + polar(crank, phi) redundant;
        loop psi = phi redundant;
    }
    impl Kinds {
        pub fn motion(phi) -> KindsMotion { theta, psi }
    }
}

mechanism! {
    pub struct Unread {
        unit mm;
        input phi = 30deg;
        unknown psi = 30deg;
        loop psi = phi redundnt;
    }
    impl Unread {
        pub fn motion(phi) -> UnreadMotion { psi }
    }
}

mechanism! {
    /// A table on three parallel cranks, a double parallelogram: the third one is 0.3 mm too long, and its foot 2 mm too high.
    pub struct Table {
        unit mm;
        param crank = 50mm;
        param span = 80mm;
        input phi = 70deg in 20deg..160deg;
        unknown tilt = 0deg;
        unknown psi = 70deg;
        let pin = polar(crank, phi);
        let third = pin + rotate((30mm, 25mm), tilt);
        loop pin + polar(span, tilt) = (span, 0mm) + polar(crank, psi);
        loop distance(third, (30mm, 25mm)) = crank + 0.3mm redundant;
        loop third = (30mm, 27mm) + polar(crank, phi) redundant;
        loop third = (30mm, 25mm) + polar(crank, phi) redundant;
    }
    impl Table {
        pub fn motion(phi) -> TableMotion { tilt, psi }
    }
}

mechanism! {
    /// Sarrus' linkage, whose hinge on the plate is turned by half a degree: the sides differ by sin 0.5deg.
    pub struct Sarrus {
        unit mm;
        input phi = 60deg in 30deg..85deg;
        unknown first = 120deg;
        unknown tilt = 0deg;
        unknown second = 60deg;
        unknown third = 120deg;
        unknown lean = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        const z = (0, 0, 1);
        let top = (90mm, 0mm, 0mm) + 70mm * turn(x, -y, phi) + 90mm * turn(x, -y, first);
        let other_top = (0mm, 90mm, 0mm) + 70mm * turn(y, x, second) + 90mm * turn(y, x, third);
        let plate_x = turn(x, -y, tilt);
        let plate_z = turn(z, x, lean);
        loop top - 85mm * plate_x = other_top - 85mm * turn(y, x, lean);
        loop dot(y, plate_z) = 0;
        loop dot(plate_x, plate_z) = 0;
        loop dot(plate_x, turn(turn(y, z, 0.5deg), x, lean)) = 0 redundant;
    }
    impl Sarrus {
        pub fn motion(phi) -> SarrusMotion { top, plate_x, lean }
    }
}

mechanism! {
    /// Bennett's linkage with a long link twisted by a tenth of a degree too much: it does not move any more.
    pub struct Bennett {
        unit mm;
        param short = 40mm;
        param long = 60mm;
        input phi = 60deg in 20deg..160deg;
        unknown psi = -130deg;
        const z = (0, 0, 1);
        const x = (1, 0, 0);
        const small = 30deg;
        const large = asin(1.5 * sin(30deg)) + 0.1deg;
        let across = turn(z, x, large);
        let first = turn((short, 0, 0), z, phi);
        let first_axis = turn(turn(z, x, small), z, phi);
        let second = (long, 0, 0) + turn((short, 0, 0), across, psi);
        let second_axis = turn(turn(across, x, small), across, psi);
        loop distance(first, second) = long;
        loop dot(first_axis, second_axis) = cos(large) redundant;
        loop dot(first_axis, second - first) = 0 redundant;
        loop dot(second_axis, second - first) = 0 redundant;
    }
    impl Bennett {
        pub fn motion(phi) -> BennettMotion { psi }
    }
}

mechanism! {
    /// Sides that are no numbers anywhere say nothing.
    pub struct NoValue {
        unit mm;
        input phi = 30deg in 10deg..170deg;
        unknown psi = 30deg;
        loop psi = phi;
        loop acos(2 + sin(psi)) = 30deg redundant;
    }
    impl NoValue {
        pub fn motion(phi) -> NoValueMotion { psi }
    }
}

fn main() {}

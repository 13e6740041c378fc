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

fn main() {}

//! Two vector loops in space with four unknowns, and a loop with one.

use linkage::mechanism;

mechanism! {
    pub struct TwoLoops {
        unit mm;
        input phi = 30deg;
        unknown s = 10mm;
        unknown t = 20mm;
        unknown theta = 0deg;
        unknown psi = 90deg;
        let pin = turn((40mm, 0, 0), (0, 0, 1), phi);
        loop pin + s * (1, 0, 0) = turn((30mm, 0, 0), (0, 1, 0), psi) + t * (1, 1, 1);
        loop turn((30mm, 0, 0), (0, 1, 0), theta) = pin + t * (0, 0, 1);
    }
    impl TwoLoops {
        pub fn slides(phi) -> Slides { s, t }
    }
}

mechanism! {
    pub struct OneUnknown {
        unit mm;
        input phi = 30deg;
        unknown s = 10mm;
        loop turn((40mm, 0, 0), (0, 0, 1), phi) = s * (1, 0, 1);
    }
    impl OneUnknown {
        pub fn slide(phi) -> Slide { s }
    }
}

fn main() {}

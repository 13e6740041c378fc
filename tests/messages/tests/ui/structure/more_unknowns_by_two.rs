//! Two loops too few.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 40deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        unknown tip = (100mm, 10mm);
        loop polar(40mm, phi) + polar(120mm, theta) = tip + polar(80mm, psi);
    }
}

fn main() {}

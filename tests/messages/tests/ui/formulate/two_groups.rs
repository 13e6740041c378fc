//! The second group does not close; the first one is fine.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
        unknown a1 = 20deg;
        unknown a2 = 60deg;
        loop polar(80mm, psi) + polar(10mm, a1) = (20mm, 0) + polar(20mm, a2);
    }
}

fn main() {}

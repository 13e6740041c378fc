//! An unknown that no loop contains.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
        unknown s = 3mm;
    }
}

fn main() {}

//! Links that are too short.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 40mm;
        input phi = 180deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(crank, phi) + polar(60mm, theta) = (100mm, 0) + polar(70mm, psi);
    }
}

fn main() {}

//! Several inputs are checked on a grid.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 60deg in 0deg..180deg;
        input s = 100mm in 80mm..150mm;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(40mm, phi) + polar(80mm, theta) = (s, 0) + polar(70mm, psi);
    }
}

fn main() {}

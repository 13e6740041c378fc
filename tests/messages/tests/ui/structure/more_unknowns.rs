//! A loop too few.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 40deg;
        param crank = 40mm;
        unknown theta = 20deg;
        unknown psi = 60deg;
        unknown s = 100mm;
        loop polar(crank, phi) + polar(120mm, theta) = (s, 0) + polar(80mm, psi);
    }
}

fn main() {}

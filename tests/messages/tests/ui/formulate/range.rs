//! A mechanism that comes apart within its range.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 80mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(crank, phi) + polar(70mm, theta) = (100mm, 0) + polar(90mm, psi);
    }
}

fn main() {}

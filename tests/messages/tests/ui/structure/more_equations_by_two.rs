//! A vector loop with one unknown too few, one without any.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 40deg;
        param crank = 40mm;
        unknown psi = 60deg;
        loop polar(crank, phi) = (100mm, 0) + polar(80mm, psi);
        loop polar(crank, phi) = (100mm, 0);
    }
}

fn main() {}

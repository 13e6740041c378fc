//! Coupler and rocker in line at the reference position.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 180deg;
        unknown theta = 0deg;
        unknown psi = 180deg;
        loop polar(40mm, phi) + polar(80mm, theta) = (100mm, 0) + polar(60mm, psi);
    }
}

fn main() {}

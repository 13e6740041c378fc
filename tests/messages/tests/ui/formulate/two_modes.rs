//! Start estimates half-way between two assemblies.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 0deg;
        unknown theta = 0deg;
        unknown psi = 0deg;
        loop polar(40mm, phi) + polar(60mm, theta) = (100mm, 0) + polar(60mm, psi);
    }
}

fn main() {}

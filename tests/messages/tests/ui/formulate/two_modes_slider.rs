//! An estimate half-way between two positions of a slider.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 90deg;
        unknown theta = -90deg;
        unknown s = 0;
        loop polar(40mm, phi) + polar(60mm, theta) = (s, 0);
    }
}

fn main() {}

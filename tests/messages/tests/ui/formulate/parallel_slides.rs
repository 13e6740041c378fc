//! Two guides of one direction.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 30deg;
        unknown s = 10mm;
        unknown t = 10mm;
        loop polar(40mm, phi) = s * (1, 0) + t * (2, 0);
    }
}

fn main() {}

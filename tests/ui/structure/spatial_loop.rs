//! A loop in space.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 60deg;
        unknown theta = 10deg;
        unknown s = 10mm;
        unknown t = 10mm;
        loop turn((40mm, 0, 0), (0, 0, 1), phi) + (s, 0, 0) = (0, t, 0) + turn((40mm, 0, 0), (0, 1, 0), theta);
    }
}

fn main() {}

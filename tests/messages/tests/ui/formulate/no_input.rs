//! A structure that does not close.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        unknown a = 60deg;
        unknown b = 120deg;
        loop polar(30mm, a) = (100mm, 0) + polar(50mm, b);
    }
}

fn main() {}

//! A distance that a given point cannot have.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 90deg;
        unknown s = 20mm;
        loop distance((s, 0), polar(40mm, phi)) = 30mm;
    }
}

fn main() {}

//! Crank and rod in line with the guide across them: a dead point.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 0deg;
        unknown theta = 0deg;
        unknown s = 0mm;
        loop polar(40mm, phi) + polar(120mm, theta) = (160mm, s);
    }
}

fn main() {}

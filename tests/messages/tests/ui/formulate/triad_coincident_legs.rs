//! Three equal and parallel legs: a platform that moves although the inputs stand, singular everywhere.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param leg = 80mm;
        input phi = 60deg;
        unknown link = 0deg;
        unknown leg_a = 90deg;
        unknown leg_b = 90deg;
        unknown leg_c = 90deg;
        let a = polar(40mm, phi);
        let p = a + polar(leg, leg_a);
        loop p + polar(60mm, link) = a + (60mm, 0mm) + polar(leg, leg_b);
        loop p + polar(30mm, link + 90deg) = a + (0mm, 30mm) + polar(leg, leg_c);
    }
}

fn main() {}

//! Two legs between the same two points: they say the same twice.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param leg = 70mm;
        input phi = 60deg;
        unknown link = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 100deg;
        let a = polar(40mm, phi) + polar(90mm, leg_a);
        let b = a + polar(60mm, link);
        loop b = (120mm, 0mm) + polar(leg, leg_b);
        loop b = (120mm, 0mm) + polar(leg, leg_c);
    }
}

fn main() {}

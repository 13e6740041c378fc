//! Estimates as near to one assembly as to its mirror image.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param leg = 70mm;
        // Everything is symmetrical about the x axis.
        input s = 30mm;
        unknown link = 0deg;
        unknown leg_a = 0deg;
        unknown leg_b = 0deg;
        unknown leg_c = 0deg;
        let a = (s, 0mm) + polar(leg, leg_a);
        loop a + polar(50mm, link) = (170mm, 0mm) + polar(60mm, leg_b);
        loop a + polar(25mm, link) = (125mm, 0mm) + polar(45mm, leg_c);
    }
}

fn main() {}

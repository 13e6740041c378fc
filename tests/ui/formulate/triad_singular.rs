//! A triad that is singular at the reference: the three legs meet in one point.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 0deg;
        unknown link = 0deg;
        unknown leg_a = 90deg;
        unknown leg_b = 90deg;
        unknown leg_c = 90deg;
        let a = (10mm, 0mm) * cos(phi) + polar(50mm, leg_a);
        loop a + polar(40mm, link) = (50mm, 0mm) + polar(50mm, leg_b);
        loop a + polar(90mm, link) = (100mm, 0mm) + polar(50mm, leg_c);
    }
}

fn main() {}

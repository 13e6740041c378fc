//! A triad that is singular at the reference: the lines of its three legs meet in one point.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param length_a = hypot(15mm, 50mm);
        param length_b = hypot(24mm, 80mm);
        param length_c = 90mm;
        input shift = 0mm;
        unknown link = 0deg;
        unknown leg_a = 107deg;
        unknown leg_b = 73deg;
        unknown leg_c = 90deg;
        let a = (15mm, -50mm + shift) + polar(length_a, leg_a);
        loop a + polar(60mm, link) = (36mm, -80mm) + polar(length_b, leg_b);
        loop a + rotate((30mm, 50mm), link) = (30mm, -40mm) + polar(length_c, leg_c);
    }
}

fn main() {}

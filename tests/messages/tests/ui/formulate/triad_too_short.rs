//! A triad whose dimensions are impossible: no assembly at the reference.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param leg = 20mm;
        input phi = 60deg;
        unknown link = 10deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        let a = polar(40mm, phi) + polar(leg, leg_a);
        loop a + polar(60mm, link) = (220mm, 0mm) + polar(50mm, leg_b);
        loop a + polar(60mm, link + 60deg) = (60mm, 210mm) + polar(50mm, leg_c);
    }
}

fn main() {}

//! A ternary link on three legs: a triad, class III.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param base_b = (120mm, 0);
        param base_c = (60mm, 110mm);
        input phi = 60deg;
        unknown link = 10deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        unknown leg_a = 20deg;
        let a = polar(40mm, phi) + polar(50mm, leg_a);
        loop a + polar(60mm, link) = base_b + polar(50mm, leg_b);
        loop a + polar(60mm, link + 60deg) = base_c + polar(50mm, leg_c);
    }

    impl M {
        pub fn link(phi) -> Link { link }
    }
}

fn main() {}

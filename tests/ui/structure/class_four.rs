//! Two ternary links joined by two binary ones: a closed contour of four links, class IV.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param base = (200mm, 0);
        input phi = 60deg;
        unknown first = 30deg;
        unknown second = 120deg;
        unknown upper = 0deg;
        unknown lower = 0deg;
        let a = polar(40mm, phi);
        loop a + polar(60mm, first) + polar(100mm, upper) = base + polar(60mm, second);
        loop a + polar(50mm, first + 40deg) + polar(110mm, lower) = base + polar(50mm, second - 40deg);
    }
}

fn main() {}

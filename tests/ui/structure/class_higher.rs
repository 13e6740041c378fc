//! Three coupled loops.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 60deg;
        unknown platform = 10deg;
        unknown a1 = 20deg;
        unknown a2 = 100deg;
        unknown a3 = 290deg;
        unknown b1 = 20deg;
        unknown b2 = 20deg;
        let a = polar(40mm, phi) + polar(50mm, a1);
        let b = a + polar(70mm, b1);
        loop a + polar(60mm, platform) = (120mm, 0) + polar(50mm, a2);
        loop b + polar(60mm, platform + 60deg) = (60mm, 110mm) + polar(50mm, a3);
        loop b + polar(20mm, b1 + 30deg) = (-60mm, 110mm) + polar(50mm, b2) + polar(10mm, platform);
    }
}

fn main() {}

//! A triad behind a dyad: the message counts the loops of the triad only.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
        unknown a1 = 20deg;
        unknown a2 = 100deg;
        unknown a3 = 290deg;
        unknown a4 = 10deg;
        let a = polar(30mm, psi) + polar(50mm, a1);
        loop a + polar(60mm, a4) = (120mm, 0) + polar(50mm, a2);
        loop a + polar(60mm, a4 + 60deg) = (60mm, 110mm) + polar(50mm, a3);
    }
}

fn main() {}

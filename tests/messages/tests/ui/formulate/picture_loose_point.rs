//! A point that moves, but of whose link the loops do not tell.
#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    struct FourBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let pin = polar(crank, phi);
        let joint = (140mm, 0) + polar(rocker, psi);
        loop pin + polar(coupler, theta) = joint;
        let ghost = (sin(phi) * joint.x, cos(phi) * joint.y);
    }
    impl FourBar {
        fn picture(phi) -> Picture { shape: picture() }
    }
}

fn main() {}

//! Nobody means radians by `30`: angles have a unit, or are computed.

use linkage::mechanism;

mechanism! {
    pub struct CrankRocker {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        input phi = 30 in 0..360;
        unknown theta = 40;
        unknown psi = 80;
        let tracer = polar(crank, phi) + polar(coupler / 2, theta - 15deg) + rotate((5mm, 0), 90);
        loop polar(crank, phi) + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
        let high = crank * sin(-(0.5)) + crank * sin(PI / 6) + crank * sin(0);
    }

    impl CrankRocker {
        pub fn path(phi) -> Path { tracer, high }
    }
}

fn main() {}

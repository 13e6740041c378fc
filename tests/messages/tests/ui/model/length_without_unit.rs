//! A length that lacks its unit is told where it is declared.

use linkage::mechanism;

mechanism! {
    pub struct CrankRocker {
        unit mm;
        param crank = 50;
        param coupler = 120 +- 0.1;
        param rocker = 100mm;
        const pivot = (140, 0);
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let pin = polar(crank, phi);
        loop pin + polar(coupler, theta) = pivot + polar(rocker, psi);
    }

    impl CrankRocker {
        pub fn path(phi) -> Path { psi }
    }
}

fn main() {}

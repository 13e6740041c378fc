//! A link that is drawn does not stretch, and moves.

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
    }
    impl FourBar {
        fn picture(phi) -> Picture {
            shape: picture([(140mm, 0), pin], [(0, 0), (140mm, 0)], [pin, joint]),
        }
    }
}

mechanism! {
    struct Gears {
        input phi = 0deg in 0deg..360deg;
        let psi = 2 * phi;
    }
    impl Gears {
        fn turn(phi) -> Turn { psi, shape: picture() }
    }
}

fn main() {}

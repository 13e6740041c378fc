//! A vector loop in space is three equations: two slides and an angle that cannot move.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 40mm;
        input phi = 30deg;
        unknown s = 10mm;
        unknown t = 20mm;
        let pin = turn((crank, 0, 0), (0, 0, 1), phi);
        loop pin + s * (1, 0, 0) = (0, 0, 20mm) + t * (0, 1, 0);
    }
    impl M {
        pub fn slides(phi) -> Slides { s, t }
    }
}

fn main() {}

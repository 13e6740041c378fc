//! Dimensions are checked in functions, too.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 30mm;
        input phi = 30deg;
        let a = polar(crank, phi);
    }

    impl M {
        pub fn one(phi) -> One { q: velocity(a) + phi, r: d(a, crank) + a }
    }
}

fn main() {}

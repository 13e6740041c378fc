//! Arguments are inputs.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 30mm;
        input phi = 30deg;
        let a = polar(crank, phi);
    }

    impl M {
        pub fn one(ph) -> One { a }
        pub fn two(crank) -> Two { a }
        pub fn three(phi, phi) -> Three { a }
    }
}

fn main() {}

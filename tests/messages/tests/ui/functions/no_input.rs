//! A mechanism without an input has functions without an argument.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 30mm;
        let a = 2 * crank;
    }

    impl M {
        pub fn one(phi) -> One { a }
        pub fn two() -> Two { v: velocity(a) }
    }
}

fn main() {}

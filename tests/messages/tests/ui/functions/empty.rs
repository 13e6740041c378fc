//! A function without a quantity.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
    }

    impl M {
        pub fn motion(phi) -> Motion {}
    }
}

fn main() {}

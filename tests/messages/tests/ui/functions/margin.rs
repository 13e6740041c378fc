//! `margin` takes no argument.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        let a = dir(phi);
    }

    impl M {
        pub fn one(phi) -> One { a, m: margin(a) }
    }
}

fn main() {}

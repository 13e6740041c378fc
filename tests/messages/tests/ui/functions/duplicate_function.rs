//! One function of a name.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        let a = dir(phi);
    }

    impl M {
        pub fn motion(phi) -> Motion { a }
        pub fn motion(phi) -> Other { a }
    }
}

fn main() {}

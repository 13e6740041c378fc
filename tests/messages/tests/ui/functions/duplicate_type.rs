//! One type of a name.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        let a = dir(phi);
    }

    impl M {
        pub fn position(phi) -> Motion { a }
        pub fn motion(phi) -> Motion { a, v: velocity(a) }
    }
}

fn main() {}

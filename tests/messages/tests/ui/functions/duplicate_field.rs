//! One field of a name.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        let a = dir(phi);
    }

    impl M {
        pub fn motion(phi) -> Motion { a, v: velocity(a), v: acceleration(a) }
    }
}

fn main() {}

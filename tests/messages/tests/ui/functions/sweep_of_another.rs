//! Functions that are generated anyway.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        let a = dir(phi);
    }

    impl M {
        pub fn motion(phi) -> Motion { a }
        pub fn motion_sweep(phi) -> Sweep { a }
        pub fn modes(phi) -> Modes { a }
    }
}

fn main() {}

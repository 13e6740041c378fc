//! The first block is missing.

use linkage::mechanism;

mechanism! {
    impl M {
        pub fn motion(phi) -> Motion { phi }
    }
}

mechanism! {}

fn main() {}

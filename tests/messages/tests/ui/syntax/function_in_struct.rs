//! Functions belong in the second block.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        fn motion(phi) -> Motion { phi }
    }
}

fn main() {}

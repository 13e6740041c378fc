//! The unit of length of a mechanism.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit milli;
    }
}

fn main() {}

//! One unit of length for a mechanism.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        unit cm;
    }
}

fn main() {}

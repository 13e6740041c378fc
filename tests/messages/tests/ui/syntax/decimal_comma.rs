//! The decimal sign is a point.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 1,5mm;
    }
}

fn main() {}

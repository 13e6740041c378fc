//! An item without its semicolon, before another one.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm
        param rocker = 80mm;
    }
}

fn main() {}

//! A tolerance whose value is negative.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param rocker = 80mm +- (1um - 2um);
    }
}

fn main() {}

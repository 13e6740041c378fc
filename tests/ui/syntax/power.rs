//! There is no operator for powers.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param n = 2;
        let a = n ^ 2;
        let b = n ** 2;
    }
}

fn main() {}

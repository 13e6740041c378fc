//! There is no operator for powers; only units have exponents.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param n = 2;
        let a = (n + 1) ^ 2;
        let b = n ** 2;
        let c = n ^ 1.5;
        let d = 3mm^2;
    }
}

fn main() {}

//! A product needs its sign.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param n = 2;
        let a = 2n;
        let b = 2 n;
        let c = (n)(n);
    }
}

fn main() {}

//! Products and quotients of vectors.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param a = (10mm, 0);
        param b = (0, 10mm);
        let c = a * b;
        let e = a / b;
        let g = 1 / b;
        let h = abs(a);
    }
}

fn main() {}

//! Functions that do not exist.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param a = 3mm;
        let b = sine(30deg);
        let c = nrom((a, a));
        let e = pow(a, 2);
        let g = a(2);
        let h = frobnicate(a);
    }
}

fn main() {}

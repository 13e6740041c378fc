//! A sum of a length and an angle.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        param lift = 30deg;
        let a = crank + lift;
        let b = lift - 2 * crank;
    }
}

fn main() {}

//! The length comes first.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input phi = 30deg;
        let a = polar(phi, crank);
        let b = rotate(phi, (crank, 0));
    }
}

fn main() {}

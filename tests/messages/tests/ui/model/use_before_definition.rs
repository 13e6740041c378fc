//! A `let` stands before its uses.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input phi = 30deg;
        let b = a + (crank, 0);
        let a = polar(crank, phi);
        let c = 2 * c;
    }
}

fn main() {}

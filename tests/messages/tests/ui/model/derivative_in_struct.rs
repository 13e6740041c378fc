//! Derivatives belong in functions.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input phi = 30deg;
        let a = polar(crank, phi);
        let v = velocity(a);
        let m = margin();
    }
}

fn main() {}

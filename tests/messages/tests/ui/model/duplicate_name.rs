//! A name is defined once.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input crank = 30deg;
    }
}

fn main() {}

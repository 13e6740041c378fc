//! Mistakes in several items are told together.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = .5mm;
        parm rocker = 80mm;
        let a = 2 crank;
        param coupler = 12in;
    }
}

fn main() {}

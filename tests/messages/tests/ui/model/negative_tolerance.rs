//! Tolerances are not negative.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm +- -1um;
        param pivot = (1mm +- -1um, 2mm) ;
    }
}

fn main() {}

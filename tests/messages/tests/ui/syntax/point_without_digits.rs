//! A decimal point needs digits on both sides.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = .5mm;
        param rocker = 1.mm;
        param coupler = -.25mm;
    }
}

fn main() {}

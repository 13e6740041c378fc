//! Numbers are decimal.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 0x10mm;
        param rocker = 0b11;
    }
}

fn main() {}

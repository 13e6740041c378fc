//! A range has two ends.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg in 0deg..;
        input psi = 30deg in 0deg, 360deg;
    }
}

fn main() {}

//! The reference lies in the range.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 400deg in 0deg..360deg;
        input psi = 10deg in 360deg..0deg;
        input s = 10mm in 11mm..2cm;
        let a = dir(phi) + dir(psi);
    }
}

fn main() {}

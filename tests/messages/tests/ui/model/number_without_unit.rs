//! A length needs its unit.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 50mm;
        let a = crank + 3;
        let b = max(crank, 10);
        input phi = 30deg in 0deg..90mm;
    }
}

fn main() {}

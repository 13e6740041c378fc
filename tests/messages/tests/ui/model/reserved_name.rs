//! Names that generated code uses.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param __crank = 50mm;
    }
}

fn main() {}

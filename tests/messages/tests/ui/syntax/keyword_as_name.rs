//! Keywords of Rust cannot be names.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param type = 50mm;
        param in = 3mm;
    }
}

fn main() {}

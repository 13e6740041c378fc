//! Attributes go to what becomes an item of Rust.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        #[allow(unused)]
        let a = 2 * crank;
    }
}

fn main() {}

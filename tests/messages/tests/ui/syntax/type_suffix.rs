//! Suffixes of Rust types have no meaning.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50f64;
    }
}

fn main() {}

//! The value gives the type.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank: f64 = 50mm;
        pub param rocker = 80mm;
    }
}

fn main() {}

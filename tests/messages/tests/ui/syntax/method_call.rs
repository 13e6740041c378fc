//! Functions are called with their arguments in parentheses.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param phi0 = 30deg;
        let a = phi0.sin();
    }
}

fn main() {}

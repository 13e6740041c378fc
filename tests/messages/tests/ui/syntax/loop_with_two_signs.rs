//! A loop is one equation.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param a = 3mm;
        loop a == a;
        loop a;
        loop a = a = a;
    }
}

fn main() {}

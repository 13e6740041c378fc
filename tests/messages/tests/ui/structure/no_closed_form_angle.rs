//! The value of an angle, beside its direction.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 60deg;
        unknown theta = 10deg;
        loop theta - 0.1 * sin(theta) = phi;
    }
}

fn main() {}

//! Names of the surrounding Rust code cannot be used.

use linkage::mechanism;

mechanism! {
    pub struct M {
        const lift = std::f64::consts::PI;
    }
}

fn main() {}

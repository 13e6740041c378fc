//! Numbers that a float cannot hold.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param a = 1e400mm;
        param b = 1e-400mm;
    }
}

fn main() {}

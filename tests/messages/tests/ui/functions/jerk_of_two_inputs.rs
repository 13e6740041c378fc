//! The third derivative is for one input.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        input psi = 30deg;
        let a = dir(phi) + dir(psi);
    }

    impl M {
        pub fn motion(phi, psi) -> Motion { j: jerk(a) }
    }
}

fn main() {}

//! Arguments that are missing, and arguments that are too many.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg at omega;
        argument press = 500N;
        let lever = press * dir(phi);
    }
    impl M {
        pub fn needs(phi) -> Needs { lever }
        pub fn both(phi) -> Both { lever, speed: omega }
        pub fn too_many(phi, press, omega) -> TooMany { lever }
    }
}

fn main() {}

//! An input that no quantity depends on.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        input s = 10mm in 0mm..20mm;
        let a = polar(10mm, phi);
    }

    impl M {
        pub fn motion(phi, s) -> Motion { a, v: velocity(a) }
        pub fn path(phi, s) -> Path { a }
    }
}

fn main() {}

//! An input that a quantity depends on.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        input s = 10mm in 0mm..20mm;
        input psi = 30deg;
        let a = polar(s, phi);
        let b = a + polar(s, psi);
    }

    impl M {
        pub fn path(phi) -> Path { a }
        pub fn nothing() -> Nothing { b }
        pub fn speed(phi) -> Speed { v: velocity(a) }
        pub fn by_other(phi) -> ByOther { v: d(a, s) }
    }
}

fn main() {}

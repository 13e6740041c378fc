//! Names that do not exist.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param coupler = 120mm;
        let a = 2 * copler;
        let b = 2 * ground;
        let c = pi / 2;
    }

    impl M {
        pub fn sums() -> Sums { cc }
    }
}

fn main() {}

//! Mistakes of several kinds in one mechanism are told together, one for each.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 50mm;
        param crank = 60mm;
        input phi = 30deg;
        let a = polar(phi, crank);
        let b = a + nowhere;
        let c = b + b;
    }

    impl M {
        pub fn points(phi) -> Points { a, b, c }
        pub fn points(phi) -> Others { q: crank + phi }
    }
}

fn main() {}

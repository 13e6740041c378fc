//! Types that are generated anyway.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
        let a = dir(phi);
    }

    impl M {
        pub fn own(phi) -> M { a }
        pub fn assembly(phi) -> MAssembly { a }
        pub fn one(phi) -> One { a }
        pub fn two(phi) -> OneColumns { a }
    }
}

fn main() {}

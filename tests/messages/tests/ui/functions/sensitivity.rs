//! Sensitivities are with respect to parameters.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 30mm;
        const frame = 100mm;
        input phi = 30deg;
        let a = polar(crank, phi);
    }

    impl M {
        pub fn one(phi) -> One { q: sensitivity(a, [phi]) }
        pub fn two(phi) -> Two { q: sensitivity(a, crank) }
        pub fn three(phi) -> Three { q: sensitivity(a, [frame]) }
        pub fn four(phi) -> Four { q: sensitivity(a, [crank, crank]) }
        pub fn five(phi) -> Five { q: sensitivity(a, []) }
        pub fn six(phi) -> Six { q: norm(sensitivity(a)) }
        pub fn seven(phi) -> Seven { q: sensitivity(a)[3] }
    }
}

fn main() {}

//! Variables of derivatives are inputs and parameters.

use linkage::mechanism;

mechanism! {
    pub struct M {
        const frame = 100mm;
        param crank = 30mm;
        param pivot = (10mm, 0);
        input phi = 30deg;
        let a = pivot + polar(crank, phi) + (frame, 0);
    }

    impl M {
        pub fn one(phi) -> One { q: d(a, frame) }
        pub fn two(phi) -> Two { q: d(a, a) }
        pub fn three(phi) -> Three { q: d(a, pivot) }
        pub fn four(phi) -> Four { q: d(a, pivot.z) }
        pub fn five(phi) -> Five { q: d(a, phi, phi, phi) }
        pub fn six(phi) -> Six { q: d(a) }
        pub fn seven(phi) -> Seven { q: d(a, phy) }
    }
}

fn main() {}

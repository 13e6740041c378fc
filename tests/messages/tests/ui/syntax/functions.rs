//! The shape of a function.

use linkage::mechanism;

mechanism! {
    pub struct M {
        input phi = 30deg;
    }

    impl M {
        pub fn one(phi: f64) -> One { phi }
        pub fn two(phi) { phi }
        pub fn three(phi) -> Three;
        pub fn four(phi) -> Four<f64> { phi }
        pub fn five(phi) -> Five { 2 * phi }
        pub fn six(phi) -> Six { phi; a: phi }
        pub fn seven(&self, phi) -> Seven { phi }
        pub fn eight(phi) -> Motion as OtherMotion { phi }
    }
}

fn main() {}

//! Warnings, which are errors here: parameters that nothing is written with.
#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    pub struct Crank {
        unit mm;
        param crank = 50mm;
        /// Forgotten in the loop.
        param rod = 120mm +- 10um;
        param pivot = (10mm, 5mm);
        param lean = 3deg;
        param ratio = 2;
        #[allow(dead_code)]
        param weight = 3;
        param _colour = 7;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        loop polar(crank, phi) + polar(120mm, theta) = (slide, 0);
    }

    impl Crank {
        pub fn slide(phi) -> Slide { slide, e: sensitivity(slide) }
    }
}

fn main() {}

//! A tolerance stands outermost in a parameter.

use linkage::mechanism;

mechanism! {
    pub struct M {
        const frame = 100mm +- 1um;
        input phi = 30deg +- 1deg;
        unknown theta = 40deg +/- 1deg;
        param crank = 2 * (50mm +/- 1um);
        param rocker = 80mm +- 1um + 3mm;
        param twice = 80mm +- 1um +- 2um;
    }
}

fn main() {}

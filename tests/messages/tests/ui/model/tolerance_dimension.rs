//! A tolerance has the dimension of its nominal value.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm +- 0.1;
        param rocker = 80mm +- 1deg;
        param pivot = (10mm, 0) +- 1deg;
        param lift = 30deg +- (1deg, 2deg);
        param tip = (10mm, 0) +- 0.1;
    }
}

fn main() {}

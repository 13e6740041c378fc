//! Arguments of the wrong dimension, too few, too many.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        param pivot = (10mm, 0);
        let a = sin(crank);
        let b = sin(pivot);
        let c = polar(crank);
        let e = norm(pivot, pivot);
        let g = distance(pivot, crank);
        let h = asin(30deg);
        let i = atan2(crank, 3);
        let j = sqrt(30deg);
    }
}

fn main() {}

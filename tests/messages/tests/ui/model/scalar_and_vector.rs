//! A sum of a scalar and a vector, of vectors of the plane and of space.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        param pivot = (10mm, 0);
        param far = (10mm, 0mm, 3mm);
        let a = pivot + crank;
        let b = pivot + far;
        let c = pivot + (1, 2);
    }
}

fn main() {}

//! Components that a quantity does not have.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        param pivot = (10mm, 0);
        let a = pivot.z;
        let b = crank.x;
        let c = pivot.length;
        let e = pivot[0];
        let g = (1mm, 2mm, 3mm, 4mm);
        let h = (1mm, 30deg);
    }
}

fn main() {}

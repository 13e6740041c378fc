//! Inputs and unknowns are angles or lengths.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input area = 3mm * 4mm;
        input point = (1mm, 2mm);
        unknown area_2 = crank * 3mm;
    }
}

fn main() {}

//! Defaults without a value.

use linkage::mechanism;

mechanism! {
    pub struct M {
        const zero = 0;
        param c = 1 / 0;
        param e = 1 / zero;
        param g = sqrt(-1);
        param h = triangle_angle(1mm, 1mm, 3mm);
        param i = 3mm +- 1mm / 0;
        const j = asin(2);
    }
}

fn main() {}

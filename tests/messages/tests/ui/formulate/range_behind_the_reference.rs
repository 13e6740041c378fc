//! It comes apart at the lower end only.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input s = 50mm in -80mm..60mm;
        unknown theta = 135deg;
        unknown t = 50mm;
        loop (s, 0) + polar(70mm, theta) = (0, t);
    }
}

fn main() {}

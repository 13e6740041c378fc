//! The ranges of two legs lead through a dead point of a platform.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input a = 70mm in 50mm..90mm;
        input b = 206mm in 0mm..506mm;
        unknown c = (0mm, 50mm);
        unknown t = 0deg;
        let arm = polar(50mm, t);
        loop distance(c - arm, (0, 0)) = a;
        loop distance(c, (200mm, 0mm)) = b;
        loop distance(c + arm, (100mm, 170mm)) = 130mm;
    }
    impl M { fn motion(a, b) -> Motion { c } }
}

fn main() {}

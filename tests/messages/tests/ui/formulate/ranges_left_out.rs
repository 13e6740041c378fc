//! Two inputs turn pivots so often that the states over their ranges cannot be prepared: no dead point, a limit.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input a = 0deg in -180deg..180deg;
        input b = 0deg in -180deg..180deg;
        unknown x1 = -3deg;
        unknown x2 = 136deg;
        unknown x3 = 240deg;
        unknown t = 56deg;
        let e1 = polar(15mm, 60 * a) + polar(90mm, x1);
        loop e1 + polar(80mm, t) = (200mm, 0mm) + polar(15mm, 60 * b) + polar(90mm, x2);
        loop e1 + polar(80mm, t + 60deg) = (100mm, 120mm) + polar(60mm, x3);
    }
    impl M { fn motion(a, b) -> Motion { e1 } }
}

fn main() {}

//! The ranges end shortly before a dead point, and the reference is there: it is none, but too near.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input a = 121.39deg in 116deg..121.39deg;
        input b = -1deg in -1deg..1deg;
        unknown x1 = 58deg;
        unknown x2 = 150deg;
        unknown x3 = 212deg;
        unknown t = -21deg;
        let e1 = polar(50mm, a + 90deg) + polar(90mm, x1);
        loop e1 + polar(80mm, t) = (200mm, 0mm) + polar(50mm, b + 210deg) + polar(90mm, x2);
        loop e1 + polar(80mm, t + 60deg) = polar(200mm, 60deg) + polar(50mm, 330deg) + polar(90mm, x3);
    }
    impl M { fn motion(a, b) -> Motion { e1 } }
}

fn main() {}

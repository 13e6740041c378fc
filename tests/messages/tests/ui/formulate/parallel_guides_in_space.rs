//! Guides that are parallel, or all parallel to one plane, or zero.

use linkage::mechanism;

mechanism! {
    pub struct Parallel {
        unit mm;
        param first = (1, 0, 0);
        param second = (2, 0, 0);
        input phi = 20deg;
        unknown r = 10mm;
        unknown s = 10mm;
        unknown t = 10mm;
        loop r * first + s * second + t * (0, 0, 1) = turn((10mm, 0, 0), (0, 1, 0), phi);
    }
    impl Parallel {
        pub fn slides(phi) -> Slides { r, s, t }
    }
}

mechanism! {
    pub struct InOnePlane {
        unit mm;
        input phi = 20deg;
        unknown r = 10mm;
        unknown s = 10mm;
        unknown t = 10mm;
        loop r * (1, 0, 0) + s * (1, 1, 0) + t * (0, 1, 0) = turn((10mm, 0, 0), (0, 1, 0), phi);
    }
    impl InOnePlane {
        pub fn slides(phi) -> Slides2 { r, s, t }
    }
}

mechanism! {
    pub struct Zero {
        unit mm;
        param guide = (0, 0, 0);
        unknown s = 10mm;
        loop distance((20mm, 0mm, 0mm), (60mm, 0mm, 50mm) + s * guide) = 90mm;
    }
    impl Zero {
        pub fn slide() -> Slide { s }
    }
}

mechanism! {
    pub struct WithAnAngle {
        unit mm;
        param first = (1, 0, 0);
        param second = (2, 0, 0);
        input phi = 20deg;
        unknown r = 10mm;
        unknown s = 10mm;
        unknown psi = 10deg;
        loop r * first + s * second + turn((20mm, 0, 5mm), (0, 0, 1), psi) = turn((10mm, 0, 0), (0, 1, 0), phi);
    }
    impl WithAnAngle {
        pub fn slides(phi) -> Slides3 { r, s }
    }
}

fn main() {}

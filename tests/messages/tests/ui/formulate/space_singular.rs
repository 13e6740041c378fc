//! Dead points in space.

use linkage::mechanism;

mechanism! {
    pub struct Rssr {
        unit mm;
        input phi = 0deg;
        unknown psi = 10deg;
        let pin = turn((20mm, 0, 0), (0, 0, 1), phi);
        let end = (60mm, 0mm, 0mm) + turn((60mm, 0, 0), (0, 1, 0), psi);
        loop distance(pin, end) = 100mm;
    }
    impl Rssr {
        pub fn angle(phi) -> RockerAngle { psi }
    }
}

mechanism! {
    pub struct Rssp {
        unit mm;
        input phi = 0deg;
        unknown s = 10mm;
        let pin = turn((20mm, 0, 0), (0, 0, 1), phi);
        loop distance(pin, (20mm, 0mm, 50mm) + s * (0, 1, 0)) = 50mm;
    }
    impl Rssp {
        pub fn slide(phi) -> Slide { s }
    }
}

mechanism! {
    pub struct Tripod {
        unit mm;
        unknown p = (0mm, 0mm, -30mm);
        loop distance(p, (50mm, 0mm, 0mm)) = 50mm;
        loop distance(p, (0mm, 50mm, 0mm)) = 50mm;
        loop distance(p, (-50mm, 0mm, 0mm)) = 50mm;
    }
    impl Tripod {
        pub fn point() -> Place { p }
    }
}

fn main() {}

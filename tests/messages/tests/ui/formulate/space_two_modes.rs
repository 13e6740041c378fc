//! Estimates between two assemblies in space.

use linkage::mechanism;

mechanism! {
    pub struct Rssr {
        unit mm;
        input phi = 0deg;
        unknown psi = 0deg;
        let pin = turn((20mm, 0, 0), (0, 0, 1), phi);
        let end = (60mm, 0mm, 0mm) + turn((60mm, 0, 0), (0, 1, 0), psi);
        loop distance(pin, end) = 90mm;
    }
    impl Rssr {
        pub fn angle(phi) -> RockerAngle { psi }
    }
}

mechanism! {
    pub struct Tripod {
        unit mm;
        unknown p = (0mm, 0mm, 0mm);
        loop distance(p, (50mm, 0mm, 0mm)) = 80mm;
        loop distance(p, (0mm, 50mm, 0mm)) = 80mm;
        loop distance(p, (-50mm, 0mm, 0mm)) = 80mm;
    }
    impl Tripod {
        pub fn point() -> Place { p }
    }
}

mechanism! {
    pub struct Direction {
        input phi = 70deg;
        unknown n = (0, 0, 0);
        loop norm(n) = 1;
        loop dot(n, (1, 0, 0)) = cos(phi);
        loop dot(n, (0, 1, 0)) = 0.5;
    }
    impl Direction {
        pub fn normal(phi) -> Normal { n }
    }
}

fn main() {}

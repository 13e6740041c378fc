//! Ranges in which mechanisms in space come apart.

use linkage::mechanism;

mechanism! {
    pub struct Rssr {
        unit mm;
        input phi = 30deg in 0deg..360deg;
        unknown psi = 140deg;
        let pin = turn((40mm, 0, 0), (0, 0, 1), phi);
        let end = (60mm, 0mm, 50mm) + turn((60mm, 0, 0), (0, 1, 0), psi);
        loop distance(pin, end) = 35mm;
    }
    impl Rssr {
        pub fn angle(phi) -> RockerAngle { psi }
    }
}

mechanism! {
    pub struct Rssp {
        unit mm;
        input phi = 30deg in 0deg..360deg;
        unknown s = 15mm;
        let pin = turn((40mm, 0, 0), (0, 0, 1), phi);
        loop distance(pin, (10mm, 0mm, 10mm) + s * (0, 1, 1)) = 35mm;
    }
    impl Rssp {
        pub fn slide(phi) -> Slide { s }
    }
}

mechanism! {
    pub struct Tripod {
        unit mm;
        input lift = 80mm in 60mm..200mm;
        unknown p = (0mm, 0mm, -60mm);
        loop distance(p, (50mm, 0mm, 0mm)) = lift;
        loop distance(p, (0mm, 50mm, 0mm)) = 80mm;
        loop distance(p, (-50mm, 0mm, 0mm)) = 80mm;
    }
    impl Tripod {
        pub fn point(lift) -> Place { p }
    }
}

fn main() {}

//! Links in space that do not reach, spheres that do not meet.

use linkage::mechanism;

mechanism! {
    pub struct Rssr {
        unit mm;
        param crank = 20mm;
        param coupler = 15mm;
        param rocker = 60mm;
        input phi = 200deg;
        unknown psi = 140deg;
        let pin = turn((crank, 0, 0), (0, 0, 1), phi);
        let end = (60mm, 0mm, 50mm) + turn((rocker, 0, 0), (0, 1, 0), psi);
        loop distance(pin, end) = coupler;
    }
    impl Rssr {
        pub fn angle(phi) -> RockerAngle { psi }
    }
}

mechanism! {
    pub struct Rssp {
        unit mm;
        param crank = 20mm;
        param rod = 40mm;
        input phi = 0deg;
        unknown s = 10mm;
        let pin = turn((crank, 0, 0), (0, 0, 1), phi);
        let end = (60mm, 0mm, 50mm) + s * (0, 1, 1);
        loop dot(pin - end, pin - end) = rod * rod;
    }
    impl Rssp {
        pub fn slide(phi) -> Slide { s }
    }
}

mechanism! {
    pub struct Tripod {
        unit mm;
        param leg = 40mm;
        unknown p = (0mm, 0mm, -30mm);
        loop distance(p, (50mm, 0mm, 0mm)) = leg;
        loop distance(p, (0mm, 50mm, 0mm)) = leg;
        loop distance(p, (-50mm, 0mm, 0mm)) = leg;
    }
    impl Tripod {
        pub fn point() -> Place { p }
    }
}

mechanism! {
    pub struct Direction {
        input phi = 20deg;
        unknown n = (0, 0, 1);
        loop norm(n) = 1;
        loop dot(n, (1, 0, 0)) = cos(phi);
        loop dot(n, (0, 1, 0)) = 0.9;
    }
    impl Direction {
        pub fn normal(phi) -> Normal { n }
    }
}

fn main() {}

//! Groups in space that are beyond the general machinery.

use linkage::mechanism;

mechanism! {
    pub struct UnknownAxis {
        unknown n = (0, 0, 1);
        unknown psi = 140deg;
        let turned = turn((1, 0, 0), n, psi);
        loop norm(n) = 1;
        loop dot(n, (1, 0, 0)) = 0.1;
        loop turned.y = 0.3;
        loop turned.z = 0.3;
    }
    impl UnknownAxis {
        pub fn axis() -> Axis { n }
    }
}

mechanism! {
    pub struct Hexapod {
        unit mm;
        param leg = 100mm;
        unknown p = (0mm, 0mm, 30mm);
        unknown x = (1, 0, 0);
        unknown y = (0, 1, 0);
        loop norm(x) = 1;
        loop norm(y) = 1;
        loop dot(x, y) = 0;
        loop distance(p, (50mm, 0mm, -40mm)) = leg;
        loop distance(p + 20mm * x, (0mm, 50mm, -40mm)) = leg;
        loop distance(p + 20mm * y, (-50mm, 0mm, -40mm)) = leg;
        loop distance(p + 20mm * x + 10mm * y, (50mm, 0mm, -40mm)) = leg;
        loop distance(p - 20mm * x, (0mm, 50mm, -40mm)) = leg;
        loop distance(p - 20mm * y, (-50mm, 0mm, -40mm)) = leg;
    }
    impl Hexapod {
        pub fn place() -> Place { p }
    }
}

fn main() {}

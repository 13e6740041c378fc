//! Components that no loop contains, or too few loops contain.

use linkage::mechanism;

mechanism! {
    pub struct Direction {
        input phi = 70deg;
        unknown n = (0, 0, 1);
        loop dot(n, (1, 0, 0)) = cos(phi);
        loop dot(n, (0, 1, 0)) = 0.5;
    }
    impl Direction {
        pub fn normal(phi) -> Normal { n }
    }
}

mechanism! {
    pub struct Point {
        unit mm;
        param length = 80mm;
        unknown p = (0mm, 0mm, 20mm);
        loop p.z = 10mm;
        loop distance(p, (0, 0, 0)) = length;
    }
    impl Point {
        pub fn point() -> Place { p }
    }
}

fn main() {}

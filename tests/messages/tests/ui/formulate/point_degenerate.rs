//! Centres on one line, centres that coincide, planes that are parallel or lie across the centres.

use linkage::mechanism;

mechanism! {
    pub struct OnOneLine {
        unit mm;
        param leg = 80mm;
        param left = (50mm, 0mm, 0mm);
        param middle = (10mm, 0mm, 0mm);
        param right = (-50mm, 0mm, 0mm);
        unknown p = (0mm, 0mm, -30mm);
        loop distance(p, left) = leg;
        loop distance(p, middle) = leg;
        loop distance(p, right) = leg;
    }
    impl OnOneLine {
        pub fn point() -> Place { p }
    }
}

mechanism! {
    pub struct Coincident {
        unit mm;
        param leg = 80mm;
        param left = (50mm, 0mm, 0mm);
        param middle = (50mm, 0mm, 0mm);
        param right = (-50mm, 0mm, 0mm);
        unknown p = (0mm, 0mm, -30mm);
        loop distance(p, left) = leg;
        loop distance(p, middle) = leg;
        loop distance(p, right) = leg;
    }
    impl Coincident {
        pub fn point() -> Place2 { p }
    }
}

mechanism! {
    pub struct PlaneAcross {
        unit mm;
        param leg = 80mm;
        param normal = (1, 0, 0);
        unknown p = (0mm, 0mm, -30mm);
        loop distance(p, (50mm, 0mm, 0mm)) = leg;
        loop distance(p, (-50mm, 0mm, 0mm)) = leg;
        loop dot(normal, p) = 0mm;
    }
    impl PlaneAcross {
        pub fn point() -> Place3 { p }
    }
}

mechanism! {
    pub struct ParallelPlanes {
        unit mm;
        param leg = 80mm;
        param normal = (0, 0, 1);
        unknown p = (0mm, 0mm, -20mm);
        loop distance(p, (0, 0, 0)) = leg;
        loop dot(normal, p) = 10mm;
        loop dot(2 * normal, p) = 30mm;
    }
    impl ParallelPlanes {
        pub fn point() -> Place4 { p }
    }
}

mechanism! {
    pub struct ParallelDirections {
        param a = (1, 1, 0);
        param b = (2, 2, 0);
        unknown n = (0, 0, 1);
        loop norm(n) = 1;
        loop dot(n, a) = 0.1;
        loop dot(n, b) = 0.1;
    }
    impl ParallelDirections {
        pub fn normal() -> Normal { n }
    }
}

fn main() {}

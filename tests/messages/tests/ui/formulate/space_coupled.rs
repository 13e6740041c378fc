//! Coupled groups in space, a platform on three hinged legs: too short, between two assemblies, a range through a turning point;
//! a loop that says the same as another.

use linkage::mechanism;

mechanism! {
    pub struct Open {
        unit mm;
        param base = 50mm;
        param plate = 60mm;
        param leg = 5mm;
        input lift = 5mm;
        unknown a = 80deg;
        unknown b = 80deg;
        unknown c = 80deg;
        let p = (base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), a);
        let q = turn((base, 0, 0) - turn((lift, 0, 0), (0, 1, 0), b), (0, 0, 1), 120deg);
        let r = turn((base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), c), (0, 0, 1), 240deg);
        loop distance(p, q) = plate;
        loop distance(q, r) = plate;
        loop distance(r, p) = plate;
    }
    impl Open {
        pub fn angles(lift) -> OpenAngles { a, b, c }
    }
}

mechanism! {
    pub struct Between {
        unit mm;
        param base = 50mm;
        param plate = 60mm;
        param leg = 100mm;
        input lift = 100mm;
        unknown a = 0.02deg;
        unknown b = 0.04deg;
        unknown c = 0.06deg;
        let p = (base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), a);
        let q = turn((base, 0, 0) - turn((lift, 0, 0), (0, 1, 0), b), (0, 0, 1), 120deg);
        let r = turn((base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), c), (0, 0, 1), 240deg);
        loop distance(p, q) = plate;
        loop distance(q, r) = plate;
        loop distance(r, p) = plate;
    }
    impl Between {
        pub fn angles(lift) -> BetweenAngles { a, b, c }
    }
}

mechanism! {
    pub struct Turning {
        unit mm;
        param base = 50mm;
        param plate = 60mm;
        param leg = 100mm;
        input lift = 90mm in 60mm..140mm;
        unknown a = 80deg;
        unknown b = 80deg;
        unknown c = 80deg;
        let p = (base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), a);
        let q = turn((base, 0, 0) - turn((lift, 0, 0), (0, 1, 0), b), (0, 0, 1), 120deg);
        let r = turn((base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), c), (0, 0, 1), 240deg);
        loop distance(p, q) = plate;
        loop distance(q, r) = plate;
        loop distance(r, p) = plate;
    }
    impl Turning {
        pub fn angles(lift) -> TurningAngles { a, b, c }
    }
}

mechanism! {
    pub struct Repeated {
        unit mm;
        param rod = 50mm;
        unknown a = 80deg;
        unknown b = 20deg;
        let p = (30mm, 0, 0) + turn((40mm, 0, 0), (0, 1, 0), a);
        let q = (-30mm, 0, 0) + turn((40mm, 0, 0), (0, 1, 0), b);
        loop distance(p, q) = rod;
        loop dot(p - q, p - q) = rod * rod;
    }
    impl Repeated {
        pub fn angles() -> Angles { a, b }
    }
}

fn main() {}

//! What is beyond the method for coupled groups: the degree and its term, the number of unknowns, and whose limit it is.

use linkage::mechanism;

mechanism! {
    struct FiveTimesAsFast {
        unit mm;
        param a = 100mm;
        param b = 20mm;
        input phi = 30deg;
        unknown theta = 10deg;
        unknown psi = 60deg;
        loop polar(a, theta) + polar(b, 5 * theta) = polar(a, psi) + polar(b, phi);
    }
    impl FiveTimesAsFast {
        fn angles(phi) -> Angles { theta, psi }
    }
}

mechanism! {
    struct Products {
        unit mm;
        param volume = 100mm;
        input phi = 30deg;
        unknown x = 10mm;
        unknown y = 20mm;
        let area = x * x * y * y * y;
        loop x * area / (volume * volume * volume) = area / (volume * volume) + polar(volume, phi).x * volume * volume;
        loop x * y = x * volume * cos(phi) + y * volume;
    }
    impl Products {
        fn lengths(phi) -> Lengths { x, y }
    }
}

mechanism! {
    struct RootOfUnknowns {
        unit mm;
        param a = 100mm;
        input phi = 30deg;
        unknown theta = 10deg;
        unknown s = 20mm;
        loop polar(a, theta) + (s, sqrt(s * s + a * a)) = polar(2 * a, phi);
    }
    impl RootOfUnknowns {
        fn slide(phi) -> Slide { s }
    }
}

mechanism! {
    struct SixAngles {
        input phi = 30deg;
        unknown t1 = 10deg;
        unknown t2 = 20deg;
        unknown t3 = 30deg;
        unknown t4 = 40deg;
        unknown t5 = 50deg;
        unknown t6 = 60deg;
        loop 1 * sin(2 * t1) + 3 * cos(t2) + 5 * sin(t3) + 7 * cos(2 * t4) + 2 * sin(t5) + 4 * cos(t6) = phi / 2;
        loop 2 * cos(t1) + 5 * sin(t2) + 1 * cos(2 * t3) + 4 * sin(t4) + 7 * cos(t5) + 3 * sin(2 * t6) = phi / 3;
        loop 5 * sin(t1) + 2 * cos(2 * t2) + 6 * sin(t3) + 3 * cos(t4) + 7 * sin(2 * t5) + 4 * cos(t6) = phi / 4;
        loop 3 * cos(2 * t1) + 1 * sin(t2) + 6 * cos(t3) + 4 * sin(2 * t4) + 2 * cos(t5) + 7 * sin(t6) = phi / 5;
        loop 3 * sin(t1) + 2 * cos(t2) + 1 * sin(2 * t3) + 7 * cos(t4) + 6 * sin(t5) + 5 * cos(2 * t6) = phi / 6;
        loop 5 * cos(t1) + 5 * sin(2 * t2) + 5 * cos(t3) + 5 * sin(t4) + 5 * cos(2 * t5) + 5 * sin(t6) = phi / 7;
    }
    impl SixAngles {
        fn angles(phi) -> All { t1, t2, t3, t4, t5, t6 }
    }
}

fn main() {}

//! Dimensions and inputs are finite, and what a loop computes of them is not: the function is named, with its argument.

use linkage::mechanism;

mechanism! {
    struct Dyad {
        unit mm;
        param crank = 50mm;
        param rod = 60mm;
        input phi = 30deg;
        unknown theta = 10deg;
        unknown psi = 60deg;
        let lean = acos(2 * cos(phi));
        loop polar(crank, lean) + polar(rod, theta) = (rod, 0) + polar(crank, psi);
    }
    impl Dyad {
        fn angles(phi) -> Angles { theta, psi }
    }
}

// In a coupled group.
mechanism! {
    struct Platform {
        unit mm;
        param size = 50mm;
        input s = 30mm;
        unknown x = 30mm;
        unknown y = 40mm;
        unknown turn = 10deg;
        let leg = sqrt(s * s - size * size);
        let p = (x, y);
        loop distance(p, (0, 0)) = size;
        loop distance(p + polar(size, turn), (2 * size, 0)) = size;
        loop distance(p + polar(size, turn + 60deg), (size, 2 * size)) = leg;
    }
    impl Platform {
        fn place(s) -> Place { x, y, turn }
    }
}

// Squares of lengths that no number holds.
mechanism! {
    struct Large {
        unit mm;
        param crank = 4e199mm;
        param huge = 1e200mm;
        input phi = 30deg;
        unknown theta = 10deg;
        unknown psi = 60deg;
        loop polar(crank, phi) + polar(huge, theta) = (huge, 0) + polar(crank, psi);
    }
    impl Large {
        fn angles(phi) -> LargeAngles { theta, psi }
    }
}

fn main() {}

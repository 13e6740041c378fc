//! A loop that is one too many and closes all the same: a third crank on one rod. And one that does not.

use linkage::mechanism;

mechanism! {
    struct ThreeCranks {
        unit mm;
        param crank = 50mm;
        param rod = 100mm;
        input phi = 60deg in 20deg..150deg;
        unknown theta = 5deg;
        unknown psi = 45deg;
        unknown chi = 80deg;
        loop polar(crank, phi) + polar(rod, theta) = (rod, 0) + polar(crank, psi);
        loop polar(crank, phi) + polar(rod / 3, theta) = (rod / 3, 0) + polar(crank, chi);
    }
    impl ThreeCranks {
        fn angles(phi) -> Angles { theta, psi, chi }
    }
}

// Seen from a crank that stands 30 degrees behind.
mechanism! {
    struct Behind {
        unit mm;
        param crank = 50mm;
        param rod = 100mm;
        param behind = 30deg;
        input phi = 60deg;
        unknown theta = 0deg;
        unknown psi = 60deg;
        unknown chi = 30deg;
        loop polar(crank, phi) + polar(rod, theta) = (rod, 0) + polar(crank, psi);
        loop polar(crank, phi) + polar(2 * rod, theta) = (2 * rod, 0) + polar(crank, chi + behind);
    }
    impl Behind {
        fn angles(phi) -> BehindAngles { theta, psi, chi }
    }
}

// Points instead of angles.
mechanism! {
    struct Points {
        unit mm;
        param crank = 50mm;
        param rod = 100mm;
        input phi = 60deg;
        unknown second = (120mm, 40mm);
        unknown third = (220mm, 40mm);
        let first = polar(crank, phi);
        loop distance(second, (rod, 0)) = crank;
        loop distance(first, second) = rod;
        loop distance(second, third) = rod;
        loop distance(first, third) = 2 * rod;
        loop distance(third, (2 * rod, 0)) = crank;
    }
    impl Points {
        fn points(phi) -> Both { second, third }
    }
}

mechanism! {
    struct Jammed {
        unit mm;
        param crank = 50mm;
        param third = 50.01mm;
        param rod = 100mm;
        input phi = 60deg;
        unknown theta = 0deg;
        unknown psi = 60deg;
        unknown chi = 60deg;
        loop polar(crank, phi) + polar(rod, theta) = (rod, 0) + polar(crank, psi);
        loop polar(crank, phi) + polar(2 * rod, theta) = (2 * rod, 0) + polar(third, chi);
    }
    impl Jammed {
        fn angles(phi) -> JammedAngles { theta, psi, chi }
    }
}

fn main() {}

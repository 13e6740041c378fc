use linkage::mechanism;

// The point runs around the origin for some values of one input and not for others.
mechanism! {
    struct Around {
        unit mm;
        input phi = 0deg in 0deg..360deg;
        input psi = 0deg in 0deg..360deg;
        unknown s = 70mm;
        unknown theta = 0deg;
        loop s * dir(theta) = (30mm, 1mm) + polar(20mm, phi) + polar(20mm, psi);
    }
    impl Around {
        fn direction(phi, psi) -> Direction { theta }
    }
}

fn main() {}

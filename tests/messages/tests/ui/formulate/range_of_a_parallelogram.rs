use linkage::mechanism;

// Stretched out, a parallelogram can fold into its mirror image.
mechanism! {
    struct Parallelogram {
        unit mm;
        param crank = 40mm;
        param base = 100mm;
        input phi = 40deg in 20deg..300deg;
        unknown theta = 0deg;
        unknown psi = 40deg;
        loop polar(crank, phi) + polar(base, theta) = (base, 0) + polar(crank, psi);
    }
    impl Parallelogram {
        fn angle(phi) -> Angle { psi }
    }
}

fn main() {}

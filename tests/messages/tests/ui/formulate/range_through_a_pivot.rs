use linkage::mechanism;

// The slider meets the pivot of its guide at half a turn: the guide could run on either way.
mechanism! {
    struct Through {
        unit mm;
        param crank = 20mm;
        input phi = 40deg in 0deg..360deg;
        unknown s = 30mm;
        unknown theta = 20deg;
        loop s * dir(theta) = (20mm, 0) + polar(crank, phi);
    }
    impl Through {
        fn guide(phi) -> Guide { theta }
    }
}

fn main() {}

//! The check of the declared range at run time, and what is at change points: assemblies that meet, positions without derivatives.

mod lengths;
mod points;

use linkage::mechanism;

mechanism! {
    struct FourBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param frame = 140mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }
    impl FourBar {
        fn motion(phi) -> Motion { psi, v: velocity(psi), a: acceleration(psi), m: margin() }
    }
}

mechanism! {
    struct SliderCrank {
        unit mm;
        param crank = 40mm;
        param rod = 150mm;
        param offset = 10mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -5deg;
        unknown slide = 180mm;
        loop polar(crank, phi) + polar(rod, theta) = (slide, offset);
    }
    impl SliderCrank {
        fn stroke(phi) -> Stroke { slide, v: velocity(slide) }
    }
}

// The second dyad hangs on the first; another function has the name of the check.
mechanism! {
    struct SixBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rod = 200mm;
        param height = 60mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        unknown chi = 10deg;
        unknown slide = 360mm;
        loop polar(crank, phi) + polar(coupler, theta) = (140mm, 0) + polar(100mm, psi);
        loop (140mm, 0) + polar(100mm, psi) + polar(rod, chi) = (slide, height);
    }
    impl SixBar {
        fn stroke(phi) -> SixStroke { slide }
    }
}

mechanism! {
    struct Free {
        unit mm;
        param coupler = 120mm;
        param rocker = 100mm;
        input phi = 30deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(50mm, phi) + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
    }
    impl Free {
        fn check_range(phi) -> FreeAngle { psi }
    }
}

mechanism! {
    struct TwoDrives {
        unit mm;
        param rod = 100mm;
        input alpha = 30deg in 0deg..90deg;
        input beta = 140deg in 90deg..150deg;
        unknown theta = 60deg;
        unknown psi = 120deg;
        loop polar(40mm, alpha) + polar(rod, theta) = (120mm, 0) + polar(40mm, beta) + polar(rod, psi);
    }
    impl TwoDrives {
        fn tip(alpha, beta) -> Tip { p: polar(40mm, alpha) + polar(rod, theta) }
    }
}

fn four_bar([crank, coupler, rocker, frame]: [f64; 4]) -> FourBar {
    FourBar {
        crank,
        coupler,
        rocker,
        frame,
    }
}

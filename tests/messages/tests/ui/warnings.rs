//! Warnings, which are errors here: inputs without a range, mechanisms that pass through a change point as they turn, and parameters
//! that nothing is written with.
#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    pub struct Parallelogram {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        input phi = 30deg;
        unknown theta = 1deg;
        unknown psi = 30deg;
        loop polar(crank, phi) + polar(coupler, theta) = (coupler, 0) + polar(crank, psi);
    }

    impl Parallelogram {
        pub fn angles(phi) -> Angles { theta, psi }
    }
}

mechanism! {
    pub struct EqualSums {
        input phi = 30deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(90mm, phi) + polar(120mm, theta) = (140mm, 0) + polar(110mm, psi);
    }

    impl EqualSums {
        pub fn angle(phi) -> Angle { psi }
    }
}

// One that turns fully, one whose crank is too long to, and one that does not reach its change point.
mechanism! {
    pub struct CrankRocker {
        input phi = 30deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(50mm, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi);
    }

    impl CrankRocker {
        pub fn angle(phi) -> CrankAngle { psi }
    }
}

mechanism! {
    pub struct Rocker {
        input phi = 30deg;
        unknown theta = -56deg;
        unknown psi = 0deg;
        loop polar(200mm, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi);
    }

    impl Rocker {
        pub fn angle(phi) -> RockerAngle { psi }
    }
}

mechanism! {
    pub struct InRange {
        input phi = 30deg in 10deg..170deg;
        unknown theta = 1deg;
        unknown psi = 30deg;
        loop polar(50mm, phi) + polar(120mm, theta) = (120mm, 0) + polar(50mm, psi);
    }

    impl InRange {
        pub fn angle(phi) -> InRangeAngle { psi }
    }
}

mechanism! {
    #[allow(deprecated)]
    pub struct Known {
        input phi = 30deg;
        unknown theta = 1deg;
        unknown psi = 30deg;
        loop polar(50mm, phi) + polar(120mm, theta) = (120mm, 0) + polar(50mm, psi);
    }

    impl Known {
        pub fn angle(phi) -> KnownAngle { psi }
    }
}

mechanism! {
    pub struct Crank {
        unit mm;
        param crank = 50mm;
        /// Forgotten in the loop.
        param rod = 120mm +- 10um;
        param pivot = (10mm, 5mm);
        param lean = 3deg;
        param ratio = 2;
        #[allow(dead_code)]
        param weight = 3;
        param _colour = 7;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        loop polar(crank, phi) + polar(120mm, theta) = (slide, 0);
    }

    impl Crank {
        pub fn slide(phi) -> Slide { slide, e: sensitivity(slide) }
    }
}

fn main() {}

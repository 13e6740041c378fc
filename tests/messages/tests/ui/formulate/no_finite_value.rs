//! Warnings, which are errors here: values that are no numbers for the declared dimensions.
#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    pub struct Crank {
        unit mm;
        param crank = 50mm;
        param rod = 120mm;
        param eccentricity = 0mm;
        const turns = 0;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        loop polar(crank, phi) + polar(rod, theta) = (slide, 0);
        let height = sqrt(crank * crank - rod * rod);
        let high = slide + 2 * height;
    }

    impl Crank {
        pub fn slide(phi) -> Slide { high, w: acos(rod / crank), curvature: cos(phi) / eccentricity, n: phi * (1 / turns), far: crank / eccentricity }
    }
}

fn main() {}

//! A library that knows linkage as `lk` only: generated code names the facade by the path from which `mechanism!` was
//! called, not by a fixed name. A module `linkage` of its own stands in the way of any guess.

/// Not the facade.
pub mod linkage {}

lk::mechanism! {
    /// Slider-crank.
    pub struct SliderCrank {
        unit mm;
        param crank = 30mm +- 10um;
        param rod = 120mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown s = 150mm;
        loop polar(crank, phi) + polar(rod, theta) = (s, 0);
        let pin = polar(crank, phi);
    }

    impl SliderCrank {
        /// Motion of the slide.
        pub fn motion(phi) -> Motion { s, pin, v: velocity(s), e: sensitivity(s), m: margin() }
    }
}

pub mod reexported {
    //! The macro under a name of the user's own.

    pub use lk::mechanism as compile;

    compile! {
        /// Two gears.
        pub struct Gears {
            param ratio = -1 / 3;
            input phi = 0deg in 0deg..1080deg;
            let driven = ratio * phi;
        }

        impl Gears {
            pub fn angle(phi) -> Angle { driven }
        }
    }
}

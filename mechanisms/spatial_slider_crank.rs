// A spatial slider-crank: the slide is on an oblique line, its rod has two ball joints.

linkage::mechanism! {
    /// The crank turns about the z axis, the slide moves along a line through `foot`.
    pub struct SpatialSlider {
        unit mm;

        param crank   = 35mm  +- 10um;
        param rod     = 150mm +- 20um;
        param foot    = (60mm, 40mm, -30mm) +- 25um;
        param bearing = 35deg +- 1arcmin;      // of the line in the crank's plane, from the x axis
        param rise    = 25deg +- 1arcmin;      // of the line above that plane

        input phi = 0deg in 0deg..360deg;

        let pin = turn((crank, 0, 0), (0, 0, 1), phi);
        let along = (cos(rise) * cos(bearing), cos(rise) * sin(bearing), sin(rise));
        unknown s = 115mm;
        let slide = foot + s * along;
        loop distance(pin, slide) = rod;
    }

    impl SpatialSlider {
        /// Both joints.
        pub fn joints(phi) -> Joints { pin, slide }
        /// The slide with its kinematic coefficients, and how far it is from a dead point.
        pub fn stroke(phi) -> Stroke { s, v: velocity(s), a: acceleration(s), margin: margin() }
        /// What the dimensions do to the slide.
        pub fn accuracy(phi) -> Accuracy { s, e: sensitivity(s) }
    }
}

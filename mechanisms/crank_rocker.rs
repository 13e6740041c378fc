// A crank-rocker four-bar with a coupler point.

linkage::mechanism! {
    /// Crank-rocker four-bar with a coupler point.
    pub struct CrankRocker {
        unit mm;

        param crank   = 40mm  +- 12um;
        param coupler = 120mm +- 20um;
        param rocker  = 80mm  +- 20um;
        param frame   = 100mm +- 20um;
        param arm     = 60mm;
        param lift    = 30deg +- 30arcsec;

        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi   = 60deg;

        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }

    impl CrankRocker {
        /// Both link angles.
        pub fn angles(phi) -> Angles { theta, psi }
        /// Motion of the coupler point, and how far the dyad is from a dead point.
        pub fn motion(phi) -> Motion { tracer, v: velocity(tracer), margin: margin() }
        /// What the dimensions do to the rocker's angle and to the coupler point.
        pub fn accuracy(phi) -> Accuracy {
            tracer,
            rocker_angle: sensitivity(psi, [crank, coupler, rocker, frame]),
            point: sensitivity(tracer),
        }
    }
}

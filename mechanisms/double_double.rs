// The crank-rocker with a coupler point, for numbers of more digits.

linkage::mechanism! {
    /// Crank-rocker four-bar with a coupler point.
    pub struct CrankRocker {
        unit mm;

        param crank   = 40mm;
        param coupler = 120.1mm;
        param rocker  = 80mm;
        param frame   = 100mm;
        param arm     = 60mm;
        param lift    = 30deg;

        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi   = 60deg;

        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }

    impl CrankRocker {
        /// Motion of the coupler point, and the rocker's angle.
        pub fn motion(phi) -> Motion {
            tracer,
            v: velocity(tracer),
            a: acceleration(tracer),
            psi,
        }
    }
}

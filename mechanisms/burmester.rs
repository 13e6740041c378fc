// A four-bar whose coupler is a body that takes given poses.

linkage::mechanism! {
    /// A four-bar whose coupler is the body, its frame turned to the x axis.
    pub struct Guide {
        param frame   = 289mm;
        param crank   = 88mm;
        param coupler = 228mm;
        param rocker  = 210mm;

        input phi = 30deg in -360deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }

    impl Guide {
        pub fn coupler(phi) -> Coupler { theta }
    }
}

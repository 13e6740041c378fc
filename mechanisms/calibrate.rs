// A four-bar that exists, with the dimensions of its drawing.

linkage::mechanism! {
    /// A four-bar on a base that may stand anywhere; the crank's encoder has a zero of its own.
    pub struct FourBar {
        unit mm;
        param base    = (0mm, 0mm);
        param tilt    = 0deg;
        param zero    = 0deg;
        param frame   = 140mm;
        param crank   = 50mm;
        param coupler = 120mm;
        param rocker  = 100mm;
        param arm     = (60mm, 30mm);
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        let a = base + polar(crank, phi + zero);
        let along = dir(theta);
        loop a + polar(coupler, theta) = base + polar(frame, tilt) + polar(rocker, psi);
        let tracer = a + arm.x * along + arm.y * rotate(along, 90deg);
    }
    impl FourBar {
        pub fn rocker(phi) -> Rocker { psi, s: sensitivity(psi) }
        pub fn path(phi) -> Path { tracer, s: sensitivity(tracer) }
    }
}

// The four-bar of the path problems.

linkage::mechanism! {
    /// A four-bar whose frame may stand anywhere, with a point on its coupler.
    pub struct FourBar {
        unit mm;
        param frame = 40mm;
        param crank = 15mm;
        param coupler = 35mm;
        param rocker = 30mm;
        param arm = (20mm, 10mm);
        param base = (0mm, 0mm);
        param tilt = 0deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let a = base + polar(crank, phi + tilt);
        loop a + polar(coupler, theta) = base + polar(frame, tilt) + polar(rocker, psi);
        let tracer = a + rotate(arm, theta);
    }
    impl FourBar {
        /// The point, what the crank's angle does to it, and what each of the nine dimensions does.
        pub fn path(phi) -> Path { tracer, v: velocity(tracer), s: sensitivity(tracer) }
        /// A pose.
        pub fn pose(phi) -> Pose {
            tracer, theta,
            v: velocity(tracer), w: velocity(theta),
            s: sensitivity(tracer), t: sensitivity(theta),
        }
        /// A velocity as a quantity.
        pub fn speed(phi) -> Speed {
            v: velocity(psi), a: acceleration(psi), s: sensitivity(velocity(psi)), psi,
        }
        /// The velocity of the point as a quantity.
        pub fn going(phi) -> Going {
            v: velocity(tracer), a: acceleration(tracer), s: sensitivity(velocity(tracer)), tracer,
        }
        /// Without derivatives by the input, and by two parameters only.
        pub fn poor(phi) -> Poor { tracer, s: sensitivity(tracer, [crank, coupler]) }
    }
}

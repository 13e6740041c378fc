// A geared five-bar: one crank turns twice as fast as the other, and their phase can be set.

linkage::mechanism! {
    /// Five-bar with gear ratio 2 and an adjustable phase of the second crank.
    pub struct GearedFiveBar {
        unit mm;

        const ratio = 2;
        param crank_1 = 30mm;
        param crank_2 = 25mm;
        param rod_1   = 90mm;
        param rod_2   = 85mm;
        param frame   = 80mm;

        input phi   = 70deg in 0deg..360deg;
        input phase = 25deg in -60deg..60deg;

        unknown alpha = 42deg;
        unknown beta  = 76deg;
        let pin_1 = polar(crank_1, phi);
        let pin_2 = (frame, 0) + polar(crank_2, ratio * phi + phase);
        let point = pin_1 + polar(rod_1, alpha);
        loop point = pin_2 + polar(rod_2, beta);
    }

    impl GearedFiveBar {
        /// The point in which the rods meet, and both crank pins.
        pub fn points(phi, phase) -> FiveBarPoints { point, pin_1, pin_2 }
        /// The point with all its first and second derivatives.
        pub fn motion(phi, phase) -> FiveBarMotion {
            point,
            v: velocity(point),
            a: acceleration(point),
            alpha,
            mixed: d(alpha, phi, phase),
        }
        /// The second rod's angle and what the lengths do to it.
        pub fn accuracy(phi, phase) -> FiveBarAccuracy { beta, e: sensitivity(beta) }
    }
}

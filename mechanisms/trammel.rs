// Two drives that have nothing but slides as unknowns: the elliptic trammel and the Scotch yoke.

linkage::mechanism! {
    /// Elliptic trammel; the second guide may be oblique.
    pub struct Trammel {
        unit mm;

        param rod   = 100mm;
        param arm   = 160mm;           // from the slider on the second guide to the tracer
        param guide = 90deg;           // between the guides

        input phi = 30deg in 0deg..360deg;
        unknown across = 87mm;         // slider on the first guide, the x axis
        unknown up     = -50mm;        // slider on the second guide
        loop polar(up, guide) + polar(rod, phi) = (across, 0);
        let tracer = polar(up, guide) + polar(arm, phi);
    }

    impl Trammel {
        /// Both sliders and the tracer.
        pub fn point(phi) -> TrammelPoint { across, up, tracer, margin: margin() }
    }
}

linkage::mechanism! {
    /// Scotch yoke: the crank pin slides in a slot of the reciprocating yoke.
    pub struct ScotchYoke {
        unit mm;

        param crank = 35mm;

        input phi = 0deg in 0deg..720deg;
        unknown x    = 35mm;           // the yoke
        unknown slot = 0mm;            // the pin in its slot
        loop polar(crank, phi) = (x, 0) + (0, slot);
    }

    impl ScotchYoke {
        /// The yoke and its first three kinematic coefficients.
        pub fn yoke(phi) -> Yoke { x, v: velocity(x), a: acceleration(x), j: jerk(x) }
        /// What the crank's length does to the yoke and to its velocity.
        pub fn accuracy(phi) -> YokeAccuracy { dx: d(x, crank), dv: d(x, phi, crank) }
    }
}

// A straight-line drive with two counter-rotating cranks: a triad with a slider.

linkage::mechanism! {
    /// The drive as published.
    pub struct TwoCranks {
        unit mm;

        param l12 = 13mm;
        param l67 = 11mm;
        param p7 = (82mm, 22mm);
        param l23 = 68mm;
        param l64 = 85mm;
        param l34 = 66mm;
        param l35 = 40mm;
        param angle_435 = -65deg;
        param n1 = (28mm, 0mm);
        param guide = 90deg;
        param l58 = 40mm;
        param angle_58 = 30deg;

        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 105deg;
        unknown phi34 = 29deg;
        unknown phi64 = 118deg;
        unknown s = 42mm;

        // The first crank turns clockwise, the second one counter-clockwise.
        let p2 = polar(l12, -phi);
        let p6 = p7 + polar(l67, phi);
        let p3 = p2 + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = n1 + polar(s, guide);
        loop p4 = p6 + polar(l64, phi64);
        loop p3 + polar(l35, phi34 + angle_435) = p5;

        let p8 = p5 + polar(l58, guide + angle_58);
    }

    impl TwoCranks {
        /// The working point.
        pub fn working_point(phi) -> WorkingPoint { p8 }

        /// All links, for drawings.
        pub fn picture(phi) -> Picture { shape: picture() }

        /// The whole position, with both derivatives.
        pub fn motion(phi) -> Motion {
            p3, p4, p8,
            s, ds: velocity(s), dds: acceleration(s),
            phi34, dphi34: velocity(phi34), ddphi34: acceleration(phi34),
        }
    }
}

// The eye-needle drive of a warp-knitting machine, a six-bar of class III.

linkage::mechanism! {
    /// The drive of the eye needles, with the tolerances of its drawing.
    pub struct EyeNeedle {
        unit mm;

        param l12 = 50mm +- 12um;
        param l23 = 272.5mm +- 26um;
        // The ternary link is given by its three sides.
        param l34 = 81mm +- 17um;
        param l45 = 104.5mm +- 17um;
        param l35 = 174mm +- 20um;
        param l46 = 104.5mm +- 17um;
        param l57 = 261mm +- 26um;
        param l78 = 136.8mm +- 20um;
        param angle_578 = -25deg +- 30arcsec;
        param p6 = (195mm, 226mm) +- 23um;
        param p7 = (46mm, 533mm) +- (12um, 35um);

        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;

        let p2 = polar(l12, phi);
        let p3 = p2 + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45));
        loop p4 = p6 + polar(l46, phi64);
        loop p5 = p7 + polar(l57, phi75);

        let p8 = p7 + polar(l78, phi75 + angle_578);
    }

    impl EyeNeedle {
        /// The needle's point.
        pub fn needle(phi) -> Needle { p8 }

        /// With both kinematic coefficients.
        pub fn motion(phi) -> Motion { p8, v: velocity(p8), a: acceleration(p8) }

        /// With the derivatives by all dimensions as well.
        pub fn accuracy(phi) -> Accuracy {
            p8, v: velocity(p8), a: acceleration(p8), e: sensitivity(p8),
        }

        /// All links, for drawings.
        pub fn picture(phi) -> Picture { shape: picture() }

        /// How the rocker of the needle moves.
        pub fn rocker(phi) -> Rocker { phi75, v: velocity(phi75), a: acceleration(phi75) }

        /// How far the drive is from a singular position.
        pub fn posture(phi) -> Posture { phi75, margin: margin() }
    }
}

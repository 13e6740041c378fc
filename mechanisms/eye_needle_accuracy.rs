// The eye-needle drive of a warp-knitting machine, with the tolerances of a published analysis.

linkage::mechanism! {
    /// The needle is driven by a crank through a ternary link, which is given by its three sides.
    pub struct EyeNeedle {
        unit mm;

        param l12 = 50mm    +- 12um;
        param l23 = 272.5mm +- 26um;
        param l34 = 81mm    +- 17um;
        param l45 = 104.5mm +- 17um;
        param l35 = 174mm   +- 20um;
        param l46 = 104.5mm +- 17um;
        param l57 = 261mm   +- 26um;
        param l78 = 136.8mm +- 20um;
        param arm = -25deg  +- 30arcsec;
        param p6  = (195mm, 226mm) +- 23um;
        param p7  = (46mm +- 12um, 533mm +- 35um);

        input phi = 0deg in 0deg..360deg;

        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;

        let p3 = polar(l12, phi) + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45));
        loop p4 = p6 + polar(l46, phi64);
        loop p5 = p7 + polar(l57, phi75);
        let needle = p7 + polar(l78, phi75 + arm);
    }

    impl EyeNeedle {
        /// The needle's point.
        pub fn needle(phi) -> Needle { needle }
        /// What each of the 13 dimensions does to it.
        pub fn accuracy(phi) -> Accuracy { e: sensitivity(needle) }
    }
}

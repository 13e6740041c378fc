// The eye-needle drive of a warp-knitting machine, for searches of its longest dwell.

linkage::mechanism! {
    /// The drive of the eye needles; the tolerance of the angle is 20 um at the needle.
    #[derive(Clone, Copy)]
    pub struct EyeNeedle {
        unit mm;

        param l12 = 50mm +- 20um;
        param l23 = 272.5mm +- 20um;
        param l34 = 81mm +- 20um;
        param l45 = 104.5mm +- 20um;
        param l35 = 174mm +- 20um;
        param l46 = 104.5mm +- 20um;
        param l57 = 261mm +- 20um;
        param l78 = 136.8mm +- 20um;
        param angle_578 = -25deg +- 30arcsec;
        param p6 = (195mm, 226mm) +- 20um;
        param p7 = (46mm, 533mm) +- 20um;

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

        // The needle's point, and its way along its arc.
        let p8 = p7 + polar(l78, phi75 + angle_578);
        let way = l78 * (phi75 + angle_578);
    }

    impl EyeNeedle {
        pub fn motion(phi) -> Motion { way, v: velocity(way), a: acceleration(way) }
        pub fn accuracy(phi) -> Accuracy { way, e: sensitivity(way) }
        pub fn picture(phi) -> Picture { shape: picture(), p8 }
    }
}

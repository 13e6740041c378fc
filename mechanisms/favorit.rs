// The hook-needle drive of the Favorit warp-knitting machine.

linkage::mechanism! {
    /// The two-crank drive of the hook needle, as published.
    pub struct Favorit {
        unit mm;

        param pivot_1 = (0mm, 0mm);
        param pivot_4 = (5mm, 150mm);
        param pivot_7 = (112.5mm, 3.5mm);
        param l12 = 5mm;
        param l23 = 46.5mm;
        param l34 = 123mm;
        param l45 = 13.5mm;
        param l78 = 10mm;
        param l89 = 160mm;
        param l56 = 130mm;
        param l910 = 122.5mm;
        param angle_345 = -62.5deg;
        param angle_456 = 90deg;
        param start_78 = 60deg;

        input phi12 = -90deg in -90deg..630deg;
        let phi78 = start_78 - (phi12 + 90deg) / 2;

        // Main crank, coupler and rocker.
        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let p2 = pivot_1 + polar(l12, phi12);
        let p3 = p2 + polar(l23, phi23);
        loop p3 = pivot_4 + polar(l34, phi43);

        // The guide, fixed on the rocker.
        let phi45 = phi43 + angle_345;
        let phi56 = phi45 + angle_456;
        let p5 = pivot_4 + polar(l45, phi45);
        let p6 = p5 + polar(l56, phi56);

        // Second crank, rod and slider; the needle points back along the guide.
        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let p8 = pivot_7 + polar(l78, phi78);
        let p9 = p8 + polar(l89, phi89);
        loop p9 = p5 + polar(slide, phi56);
        let phi910 = phi56 + 180deg;
        let p10 = p9 + polar(l910, phi910);
    }

    impl Favorit {
        /// The needle's point: position and both kinematic coefficients.
        pub fn needle(phi12) -> Needle { p10, v: velocity(p10), a: acceleration(p10) }

        /// The needle's height over the input, with three derivatives.
        pub fn height(phi12) -> Height {
            y: p10.y, v: velocity(p10.y), a: acceleration(p10.y), j: jerk(p10.y),
        }

        /// The angle between coupler and rocker, and how far the drive is from a singular position.
        pub fn transmission(phi12) -> Transmission {
            mu: phi43 - phi23, v: velocity(phi43 - phi23), a: acceleration(phi43 - phi23), margin: margin(),
        }

        /// All links, for drawings.
        pub fn picture(phi12) -> Picture { shape: picture() }

        /// Everything that the publication tabulates.
        pub fn motion(phi12) -> Motion {
            p2, v2: velocity(p2), a2: acceleration(p2),
            p3, v3: velocity(p3), a3: acceleration(p3),
            p5, v5: velocity(p5), a5: acceleration(p5),
            p6, v6: velocity(p6), a6: acceleration(p6),
            p8, v8: velocity(p8), a8: acceleration(p8),
            p9, v9: velocity(p9), a9: acceleration(p9),
            p10, v10: velocity(p10), a10: acceleration(p10),
            phi23, om23: velocity(phi23), eps23: acceleration(phi23),
            phi43, om43: velocity(phi43), eps43: acceleration(phi43),
            phi45, om45: velocity(phi45), eps45: acceleration(phi45),
            phi56, om56: velocity(phi56), eps56: acceleration(phi56),
            phi78, om78: velocity(phi78), eps78: acceleration(phi78),
            phi89, om89: velocity(phi89), eps89: acceleration(phi89),
            phi910, om910: velocity(phi910), eps910: acceleration(phi910),
        }
    }
}

// The drives of a warp-knitting machine, and the machine that they are parts of.

linkage::mechanism! {
    /// Drive of the hook needle, as in the example `favorit`: two cranks, a rocker, and a slider on its guide.
    pub struct HookNeedle {
        unit mm;
        param p1 = (0mm, 0mm) +- 20um;
        param p4 = (5mm, 150mm) +- 20um;
        param p7 = (112.5mm, 3.5mm) +- 20um;
        param l12 = 5mm +- 8um;
        param l23 = 46.5mm +- 15um;
        param l34 = 123mm +- 20um;
        param l45 = 13.5mm +- 10um;
        param l78 = 10mm +- 10um;
        param l89 = 160mm +- 20um;
        param l910 = 122.5mm +- 20um;
        param angle_345 = -62.5deg +- 30arcsec;
        param angle_456 = 90deg +- 30arcsec;
        param start_12 = -90deg +- 30arcsec;
        param start_78 = 60deg +- 30arcsec;

        // The main crank turns backwards, twice in a turn of the shaft; the second one turns with it.
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let p2 = p1 + polar(l12, start_12 - 2 * phi);
        let p3 = p2 + polar(l23, phi23);
        loop p3 = p4 + polar(l34, phi43);

        let phi45 = phi43 + angle_345;
        let phi56 = phi45 + angle_456;
        let p5 = p4 + polar(l45, phi45);
        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let p8 = p7 + polar(l78, start_78 + phi);
        let p9 = p8 + polar(l89, phi89);
        loop p9 = p5 + polar(slide, phi56);
        let phi910 = phi56 + 180deg;
        let p10 = p9 + polar(l910, phi910);
    }
    impl HookNeedle {
        pub fn motion(phi) -> HookMotion { p10, v: velocity(p10), a: acceleration(p10) }
    }

    /// Drive of the eye needle, as in the example `eye_needle`, a six-bar of class III. It hangs over the hook needle,
    /// turned over.
    pub struct EyeNeedle {
        unit mm;
        param l12 = 50mm +- 12um;
        param l23 = 272.5mm +- 26um;
        param l34 = 81mm +- 17um;
        param l45 = 104.5mm +- 17um;
        param l35 = 174mm +- 20um;
        param l46 = 104.5mm +- 17um;
        param l57 = 261mm +- 26um;
        param l78 = 136.8mm +- 20um;
        param angle_578 = -25deg +- 30arcsec;
        param p6 = (195mm, 226mm) +- 23um;
        param p7 = (46mm, 533mm) +- (12um, 35um);
        param place = (-68mm, 649.5mm) +- 50um;
        param turned = 175deg +- 1arcmin;
        /// By how much the crank is ahead of the shaft.
        param lead = 10deg +- 5arcmin;

        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 237deg;
        unknown phi34 = 321deg;
        unknown phi64 = 319deg;
        unknown phi75 = 76deg;
        let pivot_6 = place + rotate(p6, turned);
        let pivot_7 = place + rotate(p7, turned);
        let p2 = place + polar(l12, turned + phi + lead);
        let p3 = p2 + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45));
        loop p4 = pivot_6 + polar(l46, phi64);
        loop p5 = pivot_7 + polar(l57, phi75);
        let p8 = pivot_7 + polar(l78, phi75 + angle_578);
        // The way of its point on its circle.
        let way = l78 * (phi75 - turned);
    }
    impl EyeNeedle {
        pub fn motion(phi) -> EyeMotion { p8, v: velocity(p8), a: acceleration(p8) }
    }

    /// Drive of the sinkers, as in the example `two_crank_triad`: two cranks turn against each other, a slide runs
    /// straight.
    pub struct Sinker {
        unit mm;
        param l12 = 13mm +- 10um;
        param l67 = 11mm +- 10um;
        param p7 = (82mm, 22mm) +- 15um;
        param l23 = 68mm +- 15um;
        param l64 = 85mm +- 15um;
        param l34 = 66mm +- 15um;
        param l35 = 40mm +- 15um;
        param angle_435 = -65deg +- 30arcsec;
        param n1 = (28mm, 0mm) +- 15um;
        param guide = 90deg +- 30arcsec;
        param place = (20mm, 270mm) +- 50um;
        /// By how much both cranks are ahead of the shaft.
        param lead = 20deg +- 5arcmin;

        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 105deg;
        unknown phi34 = 29deg;
        unknown phi64 = 118deg;
        unknown s = 42mm;
        let p2 = place + polar(l12, -(phi + lead));
        let p6 = place + p7 + polar(l67, phi + lead);
        let p3 = p2 + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = place + n1 + polar(s, guide);
        loop p4 = p6 + polar(l64, phi64);
        loop p3 + polar(l35, phi34 + angle_435) = p5;
    }
    impl Sinker {
        pub fn motion(phi) -> SinkerMotion { s, v: velocity(s), a: acceleration(s) }
    }

    /// Drive of the press, as in the example `spatial_crank_rocker`: a rocker about an axis that is tilted twice.
    pub struct Press {
        unit mm;
        param l12 = 30mm +- 15um;
        param p4 = (110mm, 30mm, -50mm) +- 20um;
        param gamma1 = 15deg +- 30arcsec;
        param gamma2 = -20deg +- 30arcsec;
        param l43 = 70mm +- 15um;
        param l23 = 130mm +- 20um;
        param place = (150mm, 250mm, 0mm) +- 50um;
        /// By how much the crank is ahead of the shaft.
        param lead = -60deg +- 5arcmin;

        input phi = 0deg in 0deg..360deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        const z = (0, 0, 1);
        let p2 = place + turn(l12 * y, x, phi + lead);
        let new_x = turn(x, y, gamma1);
        let axis = turn(turn(z, y, gamma1), new_x, gamma2);
        unknown psi = 100deg;
        let p3 = place + p4 + turn(l43 * new_x, axis, psi);
        loop distance(p2, p3) = l23;
        let way = l43 * psi;
    }
    impl Press {
        pub fn motion(phi) -> PressMotion { way, v: velocity(way), a: acceleration(way) }
    }

    /// Four organs on one shaft.
    pub struct KnittingMachine {
        unit mm;
        input shaft = 0deg in 0deg..360deg;
        part hook: HookNeedle { phi = shaft };
        part eye: EyeNeedle { phi = shaft };
        part sinker: Sinker { phi = shaft };
        part press: Press { phi = shaft };
    }
    impl KnittingMachine {
        pub fn hook(shaft) -> Hook { tip: hook.p10, v: velocity(hook.p10), a: acceleration(hook.p10) }
        pub fn eye(shaft) -> Eye { tip: eye.p8, v: velocity(eye.p8), a: acceleration(eye.p8) }
        pub fn eye_way(shaft) -> EyeWay { way: eye.way, v: velocity(eye.way), a: acceleration(eye.way) }
        pub fn sinker(shaft) -> SinkerWay { s: sinker.s, v: velocity(sinker.s), a: acceleration(sinker.s) }
        pub fn press(shaft) -> PressWay { way: press.way, v: velocity(press.way), a: acceleration(press.way) }

        // What all dimensions do to places and velocities.
        pub fn hook_accuracy(shaft) -> HookAccuracy {
            e: sensitivity(hook.p10), rate: sensitivity(velocity(hook.p10)),
        }
        pub fn eye_accuracy(shaft) -> EyeAccuracy { e: sensitivity(eye.p8) }
        pub fn eye_way_accuracy(shaft) -> EyeWayAccuracy {
            e: sensitivity(eye.way), rate: sensitivity(velocity(eye.way)),
        }
        pub fn sinker_accuracy(shaft) -> SinkerAccuracy {
            e: sensitivity(sinker.s), rate: sensitivity(velocity(sinker.s)),
        }
        pub fn press_accuracy(shaft) -> PressAccuracy {
            e: sensitivity(press.way), rate: sensitivity(velocity(press.way)),
        }

        /// The eye needle's point as one sees it who sits on the hook needle's: x along the needle, y across.
        pub fn seen(shaft) -> Seen {
            seen: rotate(eye.p8 - hook.p10, -hook.phi910),
            v: velocity(rotate(eye.p8 - hook.p10, -hook.phi910)),
        }
        /// All links, for drawings.
        pub fn picture(shaft) -> Picture { shape: picture() }
    }
}

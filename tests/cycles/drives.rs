//! Two drives whose searches lose their way within wide bounds: of an eye needle, and of a press.

use linkage::mechanism;

mechanism! {
    /// A coupler with a triangle that is nearly flat, where derivatives grow without limit.
    #[derive(Clone, Copy)]
    pub(crate) struct Needle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l34 = 81mm;
        param l45 = 104.5mm;
        param l35 = 174mm;
        param l46 = 104.5mm;
        param l57 = 261mm;
        param l78 = 136.8mm;
        param p6 = (195mm, 226mm);
        param p7 = (46mm, 533mm);
        input phi = 0deg in 0deg..360deg;
        unknown a23 = 62deg;
        unknown a34 = 146deg;
        unknown a64 = 144deg;
        unknown a75 = -99deg;
        let p3 = polar(l12, phi) + polar(l23, a23);
        let p4 = p3 + polar(l34, a34);
        let p5 = p3 + polar(l35, a34 + triangle_angle(l34, l35, l45));
        loop p4 = p6 + polar(l46, a64);
        loop p5 = p7 + polar(l57, a75);
        let way = l78 * a75;
    }
    impl Needle {
        pub(crate) fn motion(phi) -> NeedleMotion {
            way, v: velocity(way), a: acceleration(way), j: jerk(way),
            s: sensitivity(way), sv: sensitivity(velocity(way)),
        }
    }
}

mechanism! {
    #[derive(Clone, Copy)]
    pub(crate) struct Press {
        unit mm;
        param crank = 30mm;
        param rod = 160mm;
        param upper = 100mm;
        param lower = 110mm;
        param top = (170mm, 100mm);
        input phi = 110deg in 0deg..360deg;
        unknown theta = 0deg;
        unknown psi = -100deg;
        unknown eta = -80deg;
        unknown way = -100mm;
        let knee = top + polar(upper, psi);
        loop polar(crank, phi) + polar(rod, theta) = knee;
        loop knee + polar(lower, eta) = (170mm, way);
    }
    impl Press {
        pub(crate) fn motion(phi) -> PressMotion {
            way, v: velocity(way), a: acceleration(way), j: jerk(way),
            s: sensitivity(way), sv: sensitivity(velocity(way)),
        }
    }
}

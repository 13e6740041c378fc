//! Kinds of groups that no mechanism of the project has: triads by the legs of their ternary link, a
//! contour, a point on two spheres and a plane, three slides in space. Tests of these groups run by
//! the engine; here each is compiled once by the macro.

mechanism! {
    pub struct PpPrRp {
        unit mm;
        param crank = 18mm; param a1 = (97mm, -20mm); param a3 = (78mm, 139mm); param b = 69mm;
        param c = 81mm; param kappa = 45deg; param tau = -40deg; param p1 = 85deg;
        param q1 = -10deg; param q2 = 35deg; param q3 = 170deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = -163mm; unknown y1 = 126mm; unknown x2 = 77mm; unknown x3 = -45mm;
        let e1 = a1 + polar(x1, q1) + polar(y1, tau + p1);
        let e2 = polar(crank, phi) + polar(x2, q2);
        let e3 = a3 + polar(x3, tau + q3);
        loop e1 + polar(b, tau) = e2;
        loop e1 + polar(c, tau + kappa) = e3;
    }
    impl PpPrRp {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct RpRpRp {
        unit mm;
        param crank = 20mm; param a2 = (128mm, 17mm); param a3 = (82mm, 111mm); param b = 96mm;
        param c = 73mm; param kappa = 80deg; param q1 = 50deg; param q2 = -15deg;
        param q3 = -70deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 41mm; unknown x2 = 19mm; unknown x3 = 12mm; unknown theta = -16deg;
        let e1 = polar(crank, phi) + polar(x1, theta + q1);
        let e2 = a2 + polar(x2, theta + q2);
        let e3 = a3 + polar(x3, theta + q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl RpRpRp {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct PpRrPr {
        unit mm;
        param crank = 17mm; param a1 = (131mm, -19mm); param a3 = (39mm, 101mm); param b = 50mm;
        param c = 88mm; param kappa = 85deg; param tau = 35deg; param p1 = 110deg;
        param q1 = -160deg; param q2 = 129mm; param q3 = -150deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 261mm; unknown y1 = 18mm; unknown x2 = -143deg; unknown x3 = 245mm;
        let e1 = a1 + polar(x1, q1) + polar(y1, tau + p1);
        let e2 = polar(crank, phi) + polar(q2, x2);
        let e3 = a3 + polar(x3, q3);
        loop e1 + polar(b, tau) = e2;
        loop e1 + polar(c, tau + kappa) = e3;
    }
    impl PpRrPr {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct Contour {
        unit mm;
        input phi = 30deg;
        unknown alpha = -47deg; unknown beta = -106deg; unknown gamma = 11deg;
        unknown delta = 98deg;
        let a = polar(11mm, phi);
        let base = (150mm, 27mm);
        let c1 = a + polar(84mm, alpha);
        let d1 = a + polar(70mm, alpha + 25deg);
        let c2 = base + polar(73mm, beta);
        let d2 = base + polar(86mm, beta - 85deg);
        let c = c1 + polar(64mm, gamma) - c2;
        let d = d1 + polar(64mm, delta) - d2;
        loop c = (0, 0);
        loop d = (0, 0);
    }
    impl Contour {
        pub fn motion(phi) -> Motion { alpha, beta, c1, v: velocity(c1) }
    }
}

mechanism! {
    pub struct Pinned {
        unit mm;
        input phi = 30deg;
        unknown x2 = -121mm; unknown x3 = 153mm; unknown theta = 1deg;
        let p1 = polar(27mm, phi);
        let guide = (96mm, -1mm) + polar(x2, 170deg);
        let fixed = (28mm, 84mm);
        unknown x1 = -21deg;
        let e1 = guide - polar(97mm, theta);
        loop p1 + polar(102mm, x1) = e1;
        loop e1 + polar(42mm, theta + 30deg) = fixed + polar(x3, theta - 35deg);
    }
    impl Pinned {
        pub fn motion(phi) -> Motion { e1, x2, v: velocity(e1) }
    }
}

mechanism! {
    pub struct Bent {
        unit mm;
        param ground = 40mm; param b = 100mm; param c = 80mm; param q1 = 130mm; param q2 = 110mm;
        param q3 = 120mm; param a2 = (220mm, 20mm); param a3 = (60mm, 230mm);
        input phi = 60deg;
        let p1 = polar(ground, phi);
        unknown t1 = 66deg; unknown bend = 215deg; unknown t3 = -40deg; unknown theta = -60deg;
        let e1 = p1 + polar(q1, t1);
        loop e1 + polar(b, theta) = a2 + polar(q2, theta + bend);
        loop e1 + polar(c, theta + 60deg) = a3 + polar(q3, t3);
        let e2 = e1 + polar(b, theta);
        let e3 = e1 + polar(c, theta + 60deg);
    }
    impl Bent {
        pub fn motion(phi) -> Motion { e2, e3, v: velocity(e3), by: sensitivity(e3, [b]) }
    }
}

mechanism! {
    pub struct RrRpRp {
        unit mm;
        param crank = 21mm; param a2 = (152mm, 12mm); param a3 = (29mm, 138mm); param b = 68mm;
        param c = 67mm; param kappa = 60deg; param q1 = 119mm; param q2 = 40deg;
        param q3 = 160deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 116deg; unknown x2 = -157mm; unknown x3 = -18mm; unknown theta = -58deg;
        let e1 = polar(crank, phi) + polar(q1, x1);
        let e2 = a2 + polar(x2, theta + q2);
        let e3 = a3 + polar(x3, theta + q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl RrRpRp {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct PrPrPr {
        unit mm;
        param crank = 35mm; param a2 = (90mm, 12mm); param a3 = (68mm, 102mm); param b = 107mm;
        param c = 89mm; param kappa = 85deg; param q1 = 5deg; param q2 = -60deg;
        param q3 = -90deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 99mm; unknown x2 = -92mm; unknown x3 = 141mm; unknown theta = 142deg;
        let e1 = polar(crank, phi) + polar(x1, q1);
        let e2 = a2 + polar(x2, q2);
        let e3 = a3 + polar(x3, q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl PrPrPr {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct PpRrRr {
        unit mm;
        param crank = 21mm; param a1 = (143mm, 16mm); param a3 = (62mm, 116mm); param b = 104mm;
        param c = 42mm; param kappa = 45deg; param tau = -5deg; param p1 = 85deg;
        param q1 = -170deg; param q2 = 114mm; param q3 = 101mm;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 119mm; unknown y1 = -7mm; unknown x2 = -16deg; unknown x3 = -93deg;
        let e1 = a1 + polar(x1, q1) + polar(y1, tau + p1);
        let e2 = polar(crank, phi) + polar(q2, x2);
        let e3 = a3 + polar(q3, x3);
        loop e1 + polar(b, tau) = e2;
        loop e1 + polar(c, tau + kappa) = e3;
    }
    impl PpRrRr {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct RrPrPr {
        unit mm;
        param crank = 22mm; param a2 = (96mm, -18mm); param a3 = (66mm, 81mm); param b = 102mm;
        param c = 87mm; param kappa = 75deg; param q1 = 125mm; param q2 = -70deg;
        param q3 = 85deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 100deg; unknown x2 = -83mm; unknown x3 = 95mm; unknown theta = -47deg;
        let e1 = polar(crank, phi) + polar(q1, x1);
        let e2 = a2 + polar(x2, q2);
        let e3 = a3 + polar(x3, q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl RrPrPr {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct PrPrRp {
        unit mm;
        param crank = 27mm; param a2 = (137mm, 13mm); param a3 = (103mm, 92mm); param b = 108mm;
        param c = 62mm; param kappa = 70deg; param q1 = -65deg; param q2 = -5deg;
        param q3 = 15deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = -67mm; unknown x2 = -243mm; unknown x3 = 132mm; unknown theta = -158deg;
        let e1 = polar(crank, phi) + polar(x1, q1);
        let e2 = a2 + polar(x2, q2);
        let e3 = a3 + polar(x3, theta + q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl PrPrRp {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct RrRrRp {
        unit mm;
        param crank = 17mm; param a2 = (111mm, 14mm); param a3 = (108mm, 147mm); param b = 75mm;
        param c = 62mm; param kappa = 40deg; param q1 = 119mm; param q2 = 95mm; param q3 = 170deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 76deg; unknown x2 = 157deg; unknown x3 = -88mm; unknown theta = -106deg;
        let e1 = polar(crank, phi) + polar(q1, x1);
        let e2 = a2 + polar(q2, x2);
        let e3 = a3 + polar(x3, theta + q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl RrRrRp {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct PrRpRp {
        unit mm;
        param crank = 16mm; param a2 = (144mm, 6mm); param a3 = (30mm, 144mm); param b = 78mm;
        param c = 44mm; param kappa = 65deg; param q1 = 55deg; param q2 = 15deg; param q3 = 10deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 84mm; unknown x2 = -31mm; unknown x3 = 90mm; unknown theta = -45deg;
        let e1 = polar(crank, phi) + polar(x1, q1);
        let e2 = a2 + polar(x2, theta + q2);
        let e3 = a3 + polar(x3, theta + q3);
        loop e1 + polar(b, theta) = e2;
        loop e1 + polar(c, theta + kappa) = e3;
    }
    impl PrRpRp {
        pub fn motion(phi) -> Motion {
            e1, v: velocity(e3), a: acceleration(e3), margin: margin(), by: sensitivity(e1, [b, c])
        }
    }
}

mechanism! {
    pub struct OnePlane {
        unit mm;
        param crank = 10mm; param two = (60mm, 5mm, 3mm); param l1 = 45mm; param l2 = 57mm;
        param normal = (0.1, 0.9, 0.2); param height = 13mm;
        input phi = 30deg in 0deg..360deg;
        unknown p = (25mm, 21mm, -40mm);
        let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
        loop dot(normal, p - height / dot(normal, normal) * normal) = 0mm;
        loop l2 = norm(two - p);
        loop dot(p - one, p - one) = l1 * l1;
    }
    impl OnePlane {
        pub fn motion(phi) -> Motion {
            p, v: velocity(p), a: acceleration(p), by: sensitivity(p), margin: margin()
        }
    }
}

mechanism! {
    pub struct ThreeRows {
        unit mm;
        param crank = 20mm; param base = (30mm, -15mm, 25mm); param one = 10deg;
        param two = 20deg; param tilt = 15deg;
        input phi = 30deg in 0deg..360deg;
        unknown s = 10mm; unknown t = -20mm; unknown v = 30mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let corner = pin + s * (cos(one), sin(one), 0);
        let third = turn((sin(tilt), 0, cos(tilt)), (0, 0, 1), phi / 8);
        let end = base - v * third - corner;
        loop end.x = 0;
        loop end.y = t * cos(two);
        loop end.z = t * sin(two);
    }
    impl ThreeRows {
        pub fn motion(phi) -> Motion {
            s, t, v, speed: velocity(v), by: sensitivity(s), margin: margin()
        }
    }
}

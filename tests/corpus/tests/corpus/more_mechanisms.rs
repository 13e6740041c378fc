//! Generated: `UPDATE=1 cargo test -p linkage-corpus --test corpus` writes it anew.

use crate::corpus;

corpus! {
    m1 Generated1 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f10.x, f10.y, l14, l16, w17, f19.x, f19.y, l20, l23, l26, l29, f31.x, f31.y, l33, l34, f36.x, f36.y, l37, l40, w41, w43, f45.x, f45.y, l46]
    {
pub struct Generated1 {
    unit mm;
    input phi1 = -0.3455752rad in -0.3457810rad..-0.3453694rad;
    param f2 = (5.3249mm, 19.6625mm);
    param l3 = 49.1301mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.5879932rad;
    let g6 = w5 - phi1 / 2;
    param f7 = (53.4875mm, 19.6625mm);
    param l8 = 28.2520mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    param f10 = (-3.7347mm, -54.4606mm);
    const l11 = 90.4730mm;
    unknown t12 = 178deg;
    unknown t13 = 120deg;
    param l14 = 70.0355mm;
    loop f10 + polar(l14, t13) = q4 + polar(l11, t12);
    let q15 = q4 + polar(l11, t12);
    param l16 = 37.5595mm;
    param w17 = -1.2336343rad;
    let q18 = q4 + polar(l16, t12 + w17);
    param f19 = (-125.3914mm, 63.1718mm);
    param l20 = 81.5146mm +- 20um;
    unknown t21 = -155deg;
    unknown t22 = -82deg;
    param l23 = 92.8032mm +- 20um;
    loop f19 + polar(l23, t22) = q15 + polar(l20, t21);
    let q24 = q15 + polar(l20, t21);
    const f25 = (-93.4474mm, -119.9848mm);
    param l26 = 101.7493mm;
    unknown t27 = -138deg;
    unknown t28 = 166deg;
    param l29 = -97.9835mm;
    loop f25 + polar((-l29), t28) = q24 + polar(l26, t27);
    let q30 = q24 + polar(l26, t27);
    param f31 = (-15.2463mm, 89.7520mm);
    unknown p32 = (-34.3mm, -25.7mm);
    param l33 = 98.7246mm;
    loop l33 = norm(p32 - q18);
    param l34 = 117.0489mm +- 20um;
    loop l34 = norm(f31 - p32);
    let q35 = p32;
    param f36 = (-23.1240mm, -37.9407mm);
    param l37 = 35.2626mm;
    unknown t38 = 17deg;
    unknown s39 = -82.7mm;
    loop q24 = f36 + s39 * dir(t38) - polar(l37, t38 - 90deg);
    param l40 = 45.4523mm +- 20um;
    param w41 = 0.4872927rad;
    let q42 = f36 + polar(l40, t38 + w41);
    param w43 = -0.1044021rad;
    unknown t44 = 83deg;
    loop (t12) / 2 + w43 = t44;
    param f45 = (0.0000mm, 0.0000mm);
    param l46 = 49.1039mm +- 20um;
    unknown p47 = (6.0mm, 48.7mm);
    loop p47 = f45 + polar(l46, t44);
    let q48 = p47;
}

impl Generated1 {
    pub fn position1(phi1) -> Position1 {
        q48,
        q42,
        p47,
        t44,
        s39,
        t38,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q48,
        velocity0: velocity(q48),
        acceleration0: acceleration(q48),
        jerk0: jerk(q48),
        q42,
        velocity1: velocity(q42),
        acceleration1: acceleration(q42),
        jerk1: jerk(q42),
        p47,
        velocity2: velocity(p47),
        acceleration2: acceleration(p47),
        jerk2: jerk(p47),
        t44,
        velocity3: velocity(t44),
        acceleration3: acceleration(t44),
        jerk3: jerk(t44)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q48,
        e0: sensitivity(q48, [f19.y, f10.y]),
        v0: d(q48, phi1),
        m0: d(q48, phi1, f19.y),
        w0: d(q48, f19.y, f10.y),
        q42,
        e1: sensitivity(q42, [f2.x, f36.y]),
        v1: d(q42, phi1),
        m1: d(q42, phi1, f2.x),
        w1: d(q42, f2.x, f36.y),
        p47,
        e2: sensitivity(p47, [l23, f19.x]),
        v2: d(p47, phi1),
        m2: d(p47, phi1, l23),
        w2: d(p47, l23, f19.x),
        t44,
        e3: sensitivity(t44, [f2.y, l20]),
        v3: d(t44, phi1),
        m3: d(t44, phi1, f2.y),
        w3: d(t44, f2.y, l20)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f10 + polar(l14, t13)) - (q4 + polar(l11, t12)),
        v0: velocity((f10 + polar(l14, t13)) - (q4 + polar(l11, t12))),
        a0: acceleration((f10 + polar(l14, t13)) - (q4 + polar(l11, t12))),
        r1: (f19 + polar(l23, t22)) - (q15 + polar(l20, t21)),
        v1: velocity((f19 + polar(l23, t22)) - (q15 + polar(l20, t21))),
        a1: acceleration((f19 + polar(l23, t22)) - (q15 + polar(l20, t21))),
        r2: (f25 + polar((-l29), t28)) - (q24 + polar(l26, t27)),
        v2: velocity((f25 + polar((-l29), t28)) - (q24 + polar(l26, t27))),
        a2: acceleration((f25 + polar((-l29), t28)) - (q24 + polar(l26, t27))),
        r3: (l33) - (norm(p32 - q18)),
        v3: velocity((l33) - (norm(p32 - q18))),
        a3: acceleration((l33) - (norm(p32 - q18))),
        r4: (l34) - (norm(f31 - p32)),
        v4: velocity((l34) - (norm(f31 - p32))),
        a4: acceleration((l34) - (norm(f31 - p32))),
        r5: (q24) - (f36 + s39 * dir(t38) - polar(l37, t38 - 90deg)),
        v5: velocity((q24) - (f36 + s39 * dir(t38) - polar(l37, t38 - 90deg))),
        a5: acceleration((q24) - (f36 + s39 * dir(t38) - polar(l37, t38 - 90deg)))
    }
}
}
    position1(0): q48, q42, p47, t44, s39, t38, margin;
    motion1(0): q48, velocity0, acceleration0, jerk0, q42, velocity1, acceleration1, jerk1, p47, velocity2, acceleration2, jerk2, t44, velocity3, acceleration3, jerk3;
    accuracy1(0): q48, e0, v0, m0, w0, q42, e1, v1, m1, w1, p47, e2, v2, m2, w2, t44, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m2 Generated2 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f11.x, f11.y, l12, l17, l19, w20, f22.x, f22.y, l23, l26, w29, w32, l33, l34, l38, w39, f41.x, f41.y, l42, l46, w48, l50]
    {
pub struct Generated2 {
    unit cm;
    input phi1 = 1.6458455rad in 1.6456397rad..1.6460512rad;
    input phi10 = -2.8012534rad in -2.8014592rad..-2.8010477rad;
    input x43 = 29.8628mm in 29.8525mm..29.8730mm;
    param f2 = (7.2952mm, 19.9320mm);
    param l3 = 37.8691mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.4552319rad;
    let g6 = w5 - phi1;
    param f7 = (50.4300mm, 19.9320mm);
    param l8 = 24.3451mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    param f11 = (-10.8615mm, -9.7740mm);
    param l12 = 26.3057mm;
    let q13 = f11 + polar(l12, phi10);
    const l14 = 82.4545mm;
    unknown t15 = -22deg;
    unknown t16 = -112deg;
    param l17 = 49.6512mm +- 20um;
    loop q9 + polar(-l17, t16 + 180deg) = q13 + rotate((l14, 0mm), t15);
    let q18 = q13 + polar(l14, t15);
    param l19 = 20.3288mm;
    param w20 = 0.8905590rad;
    let q21 = q13 + polar(l19, t15 + w20);
    param f22 = (60.3090mm, 75.5905mm);
    param l23 = 27.4932mm;
    unknown t24 = 46deg;
    unknown t25 = -73deg;
    param l26 = -61.0625mm +- 20um;
    loop f22 + polar((-l26), t25) = q9 + polar(l23, t24);
    let q27 = q9 + polar(l23, t24);
    const l28 = 56.3693mm;
    param w29 = -0.8781038rad;
    let q30 = q9 + polar(l28, t24 + w29);
    const f31 = (-18.0073mm, -107.4999mm);
    param w32 = -0.8520527rad;
    param l33 = 79.7575mm;
    param l34 = -32.2590mm;
    unknown t35 = -72deg;
    unknown s36 = -10.2mm;
    loop q21 + polar(l33, t35) = f31 + dir(phi10 + w32) * s36 + l34 * dir(90deg + phi10 + w32);
    let q37 = q21 + polar(l33, t35);
    param l38 = 37.6326mm;
    param w39 = -0.4284204rad;
    let q40 = q21 + polar(l38, t35 + w39);
    param f41 = (55.9023mm, -22.7886mm);
    param l42 = 37.8024mm;
    unknown t44 = 127deg;
    unknown t45 = 165deg;
    param l46 = 122.7748mm +- 20um;
    loop q40 + polar((l42 + x43), t44) = f41 + polar(l46, t45);
    let q47 = q40 + polar((l42 + x43), t44);
    param w48 = 1.3659238rad;
    unknown s49 = 32.7mm;
    param l50 = 139.5590mm;
    loop distance(q37, q47 + polar(s49, w48)) = l50;
    let q51 = q47 + polar(s49, w48);
}

impl Generated2 {
    pub fn position1(phi1) -> Position1 {
        q30,
        q27,
        t25,
        t24,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q30,
        velocity0: velocity(q30),
        acceleration0: acceleration(q30),
        jerk0: jerk(q30),
        q27,
        velocity1: velocity(q27),
        acceleration1: acceleration(q27),
        jerk1: jerk(q27),
        t25,
        velocity2: velocity(t25),
        acceleration2: acceleration(t25),
        jerk2: jerk(t25),
        t24,
        velocity3: velocity(t24),
        acceleration3: acceleration(t24),
        jerk3: jerk(t24)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q30,
        e0: sensitivity(q30, [f41.y, f11.y]),
        v0: d(q30, phi1),
        m0: d(q30, phi1, f41.y),
        w0: d(q30, f41.y, f11.y),
        q27,
        e1: sensitivity(q27, [f2.y, l26]),
        v1: d(q27, phi1),
        m1: d(q27, phi1, f2.y),
        w1: d(q27, f2.y, l26),
        t25,
        e2: sensitivity(t25, [l26, f2.y]),
        v2: d(t25, phi1),
        m2: d(t25, phi1, l26),
        w2: d(t25, l26, f2.y),
        t24,
        e3: sensitivity(t24, [l19, f2.x]),
        v3: d(t24, phi1),
        m3: d(t24, phi1, l19),
        w3: d(t24, l19, f2.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f22 + polar((-l26), t25)) - (q9 + polar(l23, t24)),
        v0: velocity((f22 + polar((-l26), t25)) - (q9 + polar(l23, t24))),
        a0: acceleration((f22 + polar((-l26), t25)) - (q9 + polar(l23, t24)))
    }
    pub fn position2(phi10) -> Position2 {
        q13
    }
    pub fn motion2(phi10) -> Motion2 {
        q13,
        velocity0: velocity(q13),
        acceleration0: acceleration(q13),
        jerk0: jerk(q13)
    }
    pub fn accuracy2(phi10) -> Accuracy2 {
        q13,
        e0: sensitivity(q13, [l38, f7.x]),
        v0: d(q13, phi10),
        m0: d(q13, phi10, l38),
        w0: d(q13, l38, f7.x)
    }
    pub fn position3(phi1, phi10) -> Position3 {
        q40,
        q37,
        s36,
        t35,
        t16,
        t15,
        margin: margin()
    }
    pub fn motion3(phi1, phi10) -> Motion3 {
        q40,
        velocity0: velocity(q40),
        acceleration0: acceleration(q40),
        q37,
        velocity1: velocity(q37),
        acceleration1: acceleration(q37),
        s36,
        velocity2: velocity(s36),
        acceleration2: acceleration(s36),
        t35,
        velocity3: velocity(t35),
        acceleration3: acceleration(t35)
    }
    pub fn accuracy3(phi1, phi10) -> Accuracy3 {
        q40,
        e0: sensitivity(q40, [f11.y, w20]),
        v0: d(q40, phi1),
        m0: d(q40, phi1, f11.y),
        w0: d(q40, f11.y, w20),
        q37,
        e1: sensitivity(q37, [l50, f22.y]),
        v1: d(q37, phi1),
        m1: d(q37, phi1, l50),
        w1: d(q37, l50, f22.y),
        s36,
        e2: sensitivity(s36, [l34, f7.y]),
        v2: d(s36, phi1),
        m2: d(s36, phi1, l34),
        w2: d(s36, l34, f7.y),
        t35,
        e3: sensitivity(t35, [l50, f41.x]),
        v3: d(t35, phi1),
        m3: d(t35, phi1, l50),
        w3: d(t35, l50, f41.x)
    }
    pub fn closure3(phi1, phi10) -> Closure3 {
        r0: (q9 + polar(-l17, t16 + 180deg)) - (q13 + rotate((l14, 0mm), t15)),
        v0: velocity((q9 + polar(-l17, t16 + 180deg)) - (q13 + rotate((l14, 0mm), t15))),
        a0: acceleration((q9 + polar(-l17, t16 + 180deg)) - (q13 + rotate((l14, 0mm), t15))),
        r1: (q21 + polar(l33, t35)) - (f31 + dir(phi10 + w32) * s36 + l34 * dir(90deg + phi10 + w32)),
        v1: velocity((q21 + polar(l33, t35)) - (f31 + dir(phi10 + w32) * s36 + l34 * dir(90deg + phi10 + w32))),
        a1: acceleration((q21 + polar(l33, t35)) - (f31 + dir(phi10 + w32) * s36 + l34 * dir(90deg + phi10 + w32)))
    }
    pub fn position7(phi1, phi10, x43) -> Position7 {
        q51,
        q47,
        s49,
        t45,
        t44,
        margin: margin()
    }
    pub fn motion7(phi1, phi10, x43) -> Motion7 {
        q51,
        velocity0: velocity(q51),
        acceleration0: acceleration(q51),
        q47,
        velocity1: velocity(q47),
        acceleration1: acceleration(q47),
        s49,
        velocity2: velocity(s49),
        acceleration2: acceleration(s49),
        t45,
        velocity3: velocity(t45),
        acceleration3: acceleration(t45)
    }
    pub fn accuracy7(phi1, phi10, x43) -> Accuracy7 {
        q51,
        e0: sensitivity(q51, [f22.x, w39]),
        v0: d(q51, x43),
        m0: d(q51, x43, f22.x),
        w0: d(q51, f22.x, w39),
        q47,
        e1: sensitivity(q47, [w39, f41.y]),
        v1: d(q47, x43),
        m1: d(q47, x43, w39),
        w1: d(q47, w39, f41.y),
        s49,
        e2: sensitivity(s49, [f22.y, l26]),
        v2: d(s49, x43),
        m2: d(s49, x43, f22.y),
        w2: d(s49, f22.y, l26),
        t45,
        e3: sensitivity(t45, [l8, l50]),
        v3: d(t45, x43),
        m3: d(t45, x43, l8),
        w3: d(t45, l8, l50)
    }
    pub fn closure7(phi1, phi10, x43) -> Closure7 {
        r0: (q40 + polar((l42 + x43), t44)) - (f41 + polar(l46, t45)),
        v0: velocity((q40 + polar((l42 + x43), t44)) - (f41 + polar(l46, t45))),
        a0: acceleration((q40 + polar((l42 + x43), t44)) - (f41 + polar(l46, t45))),
        r1: (distance(q37, q47 + polar(s49, w48))) - (l50),
        v1: velocity((distance(q37, q47 + polar(s49, w48))) - (l50)),
        a1: acceleration((distance(q37, q47 + polar(s49, w48))) - (l50))
    }
}
}
    position1(0): q30, q27, t25, t24, margin;
    motion1(0): q30, velocity0, acceleration0, jerk0, q27, velocity1, acceleration1, jerk1, t25, velocity2, acceleration2, jerk2, t24, velocity3, acceleration3, jerk3;
    accuracy1(0): q30, e0, v0, m0, w0, q27, e1, v1, m1, w1, t25, e2, v2, m2, w2, t24, e3, v3, m3, w3;
    closure1(0): r0, v0, a0;
    position2(1): q13;
    motion2(1): q13, velocity0, acceleration0, jerk0;
    accuracy2(1): q13, e0, v0, m0, w0;
    position3(0, 1): q40, q37, s36, t35, t16, t15, margin;
    motion3(0, 1): q40, velocity0, acceleration0, q37, velocity1, acceleration1, s36, velocity2, acceleration2, t35, velocity3, acceleration3;
    accuracy3(0, 1): q40, e0, v0, m0, w0, q37, e1, v1, m1, w1, s36, e2, v2, m2, w2, t35, e3, v3, m3, w3;
    closure3(0, 1): r0, v0, a0, r1, v1, a1;
    position7(0, 1, 2): q51, q47, s49, t45, t44, margin;
    motion7(0, 1, 2): q51, velocity0, acceleration0, q47, velocity1, acceleration1, s49, velocity2, acceleration2, t45, velocity3, acceleration3;
    accuracy7(0, 1, 2): q51, e0, v0, m0, w0, q47, e1, v1, m1, w1, s49, e2, v2, m2, w2, t45, e3, v3, m3, w3;
    closure7(0, 1, 2): r0, v0, a0, r1, v1, a1;
}

corpus! {
    m4 Generated4 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f10.x, f10.y, w11, w13, l14, l16, l19, l21, w22, f24.x, f24.y, l25, l27]
    {
pub struct Generated4 {
    unit mm;
    input phi1 = -0.0506145rad in -0.0561701rad..-0.0450590rad;
    param f2 = (-5.4835mm, 31.3925mm);
    param l3 = 45.7735mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.0753426rad;
    let g6 = w5 - phi1;
    param f7 = (45.4207mm, 31.3925mm);
    param l8 = 32.0055mm;
    let q9 = f7 + polar(l8, g6);
    param f10 = (-16.1319mm, -36.9637mm);
    param w11 = 2.5242972rad;
    unknown s12 = 59.5mm;
    param w13 = 2.1238650rad;
    param l14 = 81.3740mm;
    loop dot(q4 + polar(s12, w11) - f10, dir(w13)) = l14;
    let q15 = q4 + polar(s12, w11);
    param l16 = 82.8768mm;
    unknown t17 = -125deg;
    unknown t18 = -161deg;
    param l19 = 101.9466mm;
    loop q4 - q15 = polar(l16, t17) - l19 * dir(t18);
    let q20 = q15 + polar(l16, t17);
    param l21 = 41.0114mm;
    param w22 = -1.1799944rad;
    let q23 = q15 + polar(l21, t17 + w22);
    param f24 = (20.7411mm, -33.8622mm);
    param l25 = 33.0940mm +- 20um;
    unknown t26 = -60deg;
    param l27 = 60.1410mm;
    loop l27 = distance(q20 + polar(l25, t26), f24);
    let q28 = q20 + polar(l25, t26);
}

impl Generated4 {
    pub fn position1(phi1) -> Position1 {
        q28,
        q23,
        t26,
        t18,
        t17,
        s12,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q28,
        velocity0: velocity(q28),
        acceleration0: acceleration(q28),
        jerk0: jerk(q28),
        q23,
        velocity1: velocity(q23),
        acceleration1: acceleration(q23),
        jerk1: jerk(q23),
        t26,
        velocity2: velocity(t26),
        acceleration2: acceleration(t26),
        jerk2: jerk(t26),
        t18,
        velocity3: velocity(t18),
        acceleration3: acceleration(t18),
        jerk3: jerk(t18)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q28,
        e0: sensitivity(q28, [l25, w5]),
        v0: d(q28, phi1),
        m0: d(q28, phi1, l25),
        w0: d(q28, l25, w5),
        q23,
        e1: sensitivity(q23, [l21, l25]),
        v1: d(q23, phi1),
        m1: d(q23, phi1, l21),
        w1: d(q23, l21, l25),
        t26,
        e2: sensitivity(t26, [l21, l19]),
        v2: d(t26, phi1),
        m2: d(t26, phi1, l21),
        w2: d(t26, l21, l19),
        t18,
        e3: sensitivity(t18, [w22, w11]),
        v3: d(t18, phi1),
        m3: d(t18, phi1, w22),
        w3: d(t18, w22, w11)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (dot(q4 + polar(s12, w11) - f10, dir(w13))) - (l14),
        v0: velocity((dot(q4 + polar(s12, w11) - f10, dir(w13))) - (l14)),
        a0: acceleration((dot(q4 + polar(s12, w11) - f10, dir(w13))) - (l14)),
        r1: (q4 - q15) - (polar(l16, t17) - l19 * dir(t18)),
        v1: velocity((q4 - q15) - (polar(l16, t17) - l19 * dir(t18))),
        a1: acceleration((q4 - q15) - (polar(l16, t17) - l19 * dir(t18))),
        r2: (l27) - (distance(q20 + polar(l25, t26), f24)),
        v2: velocity((l27) - (distance(q20 + polar(l25, t26), f24))),
        a2: acceleration((l27) - (distance(q20 + polar(l25, t26), f24)))
    }
}
}
    position1(0): q28, q23, t26, t18, t17, s12, margin;
    motion1(0): q28, velocity0, acceleration0, jerk0, q23, velocity1, acceleration1, jerk1, t26, velocity2, acceleration2, jerk2, t18, velocity3, acceleration3, jerk3;
    accuracy1(0): q28, e0, v0, m0, w0, q23, e1, v1, m1, w1, t26, e2, v2, m2, w2, t18, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m5 Generated5 [l2, f4.x, f4.y, l5, l8, f10.x, f10.y, w11, l12, l13, w18, f20.x, f20.y, l25, l27, w28, f30.x, f30.y, l31, l33, l35, l39, l41, w42, l45, l48, w49]
    {
pub struct Generated5 {
    unit m;
    input phi1 = -2.4836035rad in -2.4836721rad..-2.4835349rad;
    input x22 = 48.7115mm in 48.7081mm..48.7149mm;
    input x36 = 39.8122mm in 39.8088mm..39.8156mm;
    param l2 = 26.9813mm;
    let q3 = polar(l2, phi1);
    param f4 = (-94.5306mm, 7.9621mm);
    param l5 = 69.1194mm +- 20um;
    unknown t6 = -173deg;
    unknown t7 = -82deg;
    param l8 = 33.7369mm +- 20um;
    loop f4 + polar(l8, t7) = q3 + polar(l5, t6);
    let q9 = q3 + polar(l5, t6);
    param f10 = (-82.0037mm, -5.3700mm);
    param w11 = -0.1563354rad;
    param l12 = 26.4271mm +- 20um;
    param l13 = 19.1139mm;
    unknown t14 = 77deg;
    unknown s15 = -65.3mm;
    loop f10 + rotate((s15, l13), phi1 + w11) = q3 + polar(l12, t14);
    let q16 = q3 + polar(l12, t14);
    const l17 = 36.5477mm;
    param w18 = -0.1416651rad;
    let q19 = q3 + polar(l17, t14 + w18);
    param f20 = (23.9350mm, 84.3902mm);
    const l21 = 37.5861mm;
    unknown t23 = 121deg;
    unknown t24 = 175deg;
    param l25 = 77.1701mm;
    loop q19 + polar((l21 + x22), t23) = f20 + polar(l25, t24);
    let q26 = q19 + polar((l21 + x22), t23);
    param l27 = 41.1412mm;
    param w28 = 2.4581751rad;
    let q29 = q19 + polar(l27, t23 + w28);
    param f30 = (-68.3600mm, 35.6491mm);
    param l31 = 56.0108mm +- 20um;
    unknown t32 = 158deg;
    param l33 = 84.9380mm +- 20um;
    loop l33 = distance(q26 + polar(l31, t32), f30);
    let q34 = q26 + polar(l31, t32);
    param l35 = 31.5544mm +- 20um;
    unknown t37 = -18deg;
    unknown t38 = 98deg;
    param l39 = 107.7944mm;
    loop q34 + polar((l35 + x36), t37) = q3 + polar(l39, t38);
    let q40 = q34 + polar((l35 + x36), t37);
    param l41 = 54.1396mm;
    param w42 = -0.6310320rad;
    let q43 = q34 + polar(l41, t37 + w42);
    const f44 = (-178.5977mm, 167.7637mm);
    param l45 = -14.0450mm;
    unknown t46 = -28deg;
    unknown s47 = 91.1mm;
    loop q34 = f44 + rotate((s47, l45), t46);
    param l48 = 37.4897mm;
    param w49 = 0.2451727rad;
    let q50 = f44 + polar(l48, t46 + w49);
}

impl Generated5 {
    pub fn position1(phi1) -> Position1 {
        q19,
        q16,
        s15,
        t14,
        t7,
        t6,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q19,
        velocity0: velocity(q19),
        acceleration0: acceleration(q19),
        jerk0: jerk(q19),
        q16,
        velocity1: velocity(q16),
        acceleration1: acceleration(q16),
        jerk1: jerk(q16),
        s15,
        velocity2: velocity(s15),
        acceleration2: acceleration(s15),
        jerk2: jerk(s15),
        t14,
        velocity3: velocity(t14),
        acceleration3: acceleration(t14),
        jerk3: jerk(t14)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q19,
        e0: sensitivity(q19, [l2, l13]),
        v0: d(q19, phi1),
        m0: d(q19, phi1, l2),
        w0: d(q19, l2, l13),
        q16,
        e1: sensitivity(q16, [l48, f30.x]),
        v1: d(q16, phi1),
        m1: d(q16, phi1, l48),
        w1: d(q16, l48, f30.x),
        s15,
        e2: sensitivity(s15, [l31, w18]),
        v2: d(s15, phi1),
        m2: d(s15, phi1, l31),
        w2: d(s15, l31, w18),
        t14,
        e3: sensitivity(t14, [f20.y, f4.x]),
        v3: d(t14, phi1),
        m3: d(t14, phi1, f20.y),
        w3: d(t14, f20.y, f4.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f4 + polar(l8, t7)) - (q3 + polar(l5, t6)),
        v0: velocity((f4 + polar(l8, t7)) - (q3 + polar(l5, t6))),
        a0: acceleration((f4 + polar(l8, t7)) - (q3 + polar(l5, t6))),
        r1: (f10 + rotate((s15, l13), phi1 + w11)) - (q3 + polar(l12, t14)),
        v1: velocity((f10 + rotate((s15, l13), phi1 + w11)) - (q3 + polar(l12, t14))),
        a1: acceleration((f10 + rotate((s15, l13), phi1 + w11)) - (q3 + polar(l12, t14)))
    }
    pub fn position3(phi1, x22) -> Position3 {
        q50,
        q34,
        s47,
        t46,
        t32,
        t24,
        margin: margin()
    }
    pub fn motion3(phi1, x22) -> Motion3 {
        q50,
        velocity0: velocity(q50),
        acceleration0: acceleration(q50),
        q34,
        velocity1: velocity(q34),
        acceleration1: acceleration(q34),
        s47,
        velocity2: velocity(s47),
        acceleration2: acceleration(s47),
        t46,
        velocity3: velocity(t46),
        acceleration3: acceleration(t46)
    }
    pub fn accuracy3(phi1, x22) -> Accuracy3 {
        q50,
        e0: sensitivity(q50, [f30.x, l5]),
        v0: d(q50, x22),
        m0: d(q50, x22, f30.x),
        w0: d(q50, f30.x, l5),
        q34,
        e1: sensitivity(q34, [w49, l31]),
        v1: d(q34, x22),
        m1: d(q34, x22, w49),
        w1: d(q34, w49, l31),
        s47,
        e2: sensitivity(s47, [f20.y, w28]),
        v2: d(s47, x22),
        m2: d(s47, x22, f20.y),
        w2: d(s47, f20.y, w28),
        t46,
        e3: sensitivity(t46, [l48, l45]),
        v3: d(t46, x22),
        m3: d(t46, x22, l48),
        w3: d(t46, l48, l45)
    }
    pub fn closure3(phi1, x22) -> Closure3 {
        r0: (q19 + polar((l21 + x22), t23)) - (f20 + polar(l25, t24)),
        v0: velocity((q19 + polar((l21 + x22), t23)) - (f20 + polar(l25, t24))),
        a0: acceleration((q19 + polar((l21 + x22), t23)) - (f20 + polar(l25, t24))),
        r1: (l33) - (distance(q26 + polar(l31, t32), f30)),
        v1: velocity((l33) - (distance(q26 + polar(l31, t32), f30))),
        a1: acceleration((l33) - (distance(q26 + polar(l31, t32), f30))),
        r2: (q34) - (f44 + rotate((s47, l45), t46)),
        v2: velocity((q34) - (f44 + rotate((s47, l45), t46))),
        a2: acceleration((q34) - (f44 + rotate((s47, l45), t46)))
    }
    pub fn position7(phi1, x22, x36) -> Position7 {
        q43,
        q40,
        t38,
        t37,
        margin: margin()
    }
    pub fn motion7(phi1, x22, x36) -> Motion7 {
        q43,
        velocity0: velocity(q43),
        acceleration0: acceleration(q43),
        q40,
        velocity1: velocity(q40),
        acceleration1: acceleration(q40),
        t38,
        velocity2: velocity(t38),
        acceleration2: acceleration(t38),
        t37,
        velocity3: velocity(t37),
        acceleration3: acceleration(t37)
    }
    pub fn accuracy7(phi1, x22, x36) -> Accuracy7 {
        q43,
        e0: sensitivity(q43, [w49, f20.x]),
        v0: d(q43, x36),
        m0: d(q43, x36, w49),
        w0: d(q43, w49, f20.x),
        q40,
        e1: sensitivity(q40, [f30.y, f20.x]),
        v1: d(q40, x36),
        m1: d(q40, x36, f30.y),
        w1: d(q40, f30.y, f20.x),
        t38,
        e2: sensitivity(t38, [l39, f30.y]),
        v2: d(t38, x36),
        m2: d(t38, x36, l39),
        w2: d(t38, l39, f30.y),
        t37,
        e3: sensitivity(t37, [l45, l33]),
        v3: d(t37, x36),
        m3: d(t37, x36, l45),
        w3: d(t37, l45, l33)
    }
    pub fn closure7(phi1, x22, x36) -> Closure7 {
        r0: (q34 + polar((l35 + x36), t37)) - (q3 + polar(l39, t38)),
        v0: velocity((q34 + polar((l35 + x36), t37)) - (q3 + polar(l39, t38))),
        a0: acceleration((q34 + polar((l35 + x36), t37)) - (q3 + polar(l39, t38)))
    }
}
}
    position1(0): q19, q16, s15, t14, t7, t6, margin;
    motion1(0): q19, velocity0, acceleration0, jerk0, q16, velocity1, acceleration1, jerk1, s15, velocity2, acceleration2, jerk2, t14, velocity3, acceleration3, jerk3;
    accuracy1(0): q19, e0, v0, m0, w0, q16, e1, v1, m1, w1, s15, e2, v2, m2, w2, t14, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1;
    position3(0, 1): q50, q34, s47, t46, t32, t24, margin;
    motion3(0, 1): q50, velocity0, acceleration0, q34, velocity1, acceleration1, s47, velocity2, acceleration2, t46, velocity3, acceleration3;
    accuracy3(0, 1): q50, e0, v0, m0, w0, q34, e1, v1, m1, w1, s47, e2, v2, m2, w2, t46, e3, v3, m3, w3;
    closure3(0, 1): r0, v0, a0, r1, v1, a1, r2, v2, a2;
    position7(0, 1, 2): q43, q40, t38, t37, margin;
    motion7(0, 1, 2): q43, velocity0, acceleration0, q40, velocity1, acceleration1, t38, velocity2, acceleration2, t37, velocity3, acceleration3;
    accuracy7(0, 1, 2): q43, e0, v0, m0, w0, q40, e1, v1, m1, w1, t38, e2, v2, m2, w2, t37, e3, v3, m3, w3;
    closure7(0, 1, 2): r0, v0, a0;
}

corpus! {
    m7 Generated7 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f10.x, f10.y, w11, l12, l13, l17, w18, f20.x, f20.y, l21, l24, l26, w27, l29, l32, l34, w35, w37, l38, l39, l43, w44, w46, w48, l49, w51, l53]
    {
pub struct Generated7 {
    unit mm;
    input phi1 = 0.5148721rad;
    param f2 = (-8.8136mm, -38.6569mm);
    param l3 = 47.0228mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = -0.1737172rad;
    let g6 = 2 * phi1 + w5;
    param f7 = (49.9826mm, -38.6569mm);
    param l8 = 36.7833mm;
    let q9 = f7 + polar(l8, g6);
    param f10 = (137.0123mm, -43.0448mm);
    param w11 = -0.5763270rad;
    param l12 = 82.1460mm +- 20um;
    param l13 = 22.2321mm +- 20um;
    unknown t14 = -12deg;
    unknown s15 = 6.4mm;
    loop f10 + polar(s15, w11) + polar(l13, w11 + 90deg) = q9 + polar(l12, t14);
    let q16 = q9 + polar(l12, t14);
    param l17 = 57.4074mm;
    param w18 = -1.4476394rad;
    let q19 = q9 + polar(l17, t14 + w18);
    param f20 = (137.0665mm, -54.6654mm);
    param l21 = 43.9341mm;
    unknown t22 = -39deg;
    unknown t23 = -129deg;
    param l24 = 53.1743mm;
    loop q19 + rotate((l21, 0mm), t22) = f20 + polar(-l24, t23 + 180deg);
    let q25 = q19 + polar(l21, t22);
    param l26 = 44.6510mm;
    param w27 = -0.7239882rad;
    let q28 = q19 + polar(l26, t22 + w27);
    param l29 = 41.5976mm;
    unknown t30 = 20deg;
    unknown t31 = -52deg;
    param l32 = 55.0135mm;
    loop polar(l29, t30) - l32 * dir(t31) = q9 - q19;
    let q33 = q19 + polar(l29, t30);
    param l34 = 33.2744mm;
    param w35 = 2.3223820rad;
    let q36 = q19 + polar(l34, t30 + w35);
    param w37 = 1.3635887rad;
    param l38 = 69.9823mm;
    param l39 = 37.1515mm;
    unknown t40 = -70deg;
    unknown s41 = -46.4mm;
    loop q33 + rotate((s41, l39), t14 + w37) = q4 + polar(l38, t40);
    let q42 = q4 + polar(l38, t40);
    param l43 = 47.8581mm +- 20um;
    param w44 = 1.1561591rad;
    let q45 = q4 + polar(l43, t40 + w44);
    param w46 = -1.4367771rad;
    unknown s47 = 63.4mm;
    param w48 = -2.1162723rad;
    param l49 = 115.2917mm;
    loop l49 = dot(q42 + polar(s47, w46) - q45, dir(w48));
    let q50 = q42 + polar(s47, w46);
    param w51 = -0.8937849rad;
    const l52 = 73.0438mm;
    param l53 = -33.8827mm +- 20um;
    unknown t54 = 131deg;
    unknown s55 = -64.5mm;
    loop q42 + polar(l52, t54) = q45 + polar(s55, phi1 + w51) + polar(l53, phi1 + w51 + 90deg);
    let q56 = q42 + polar(l52, t54);
}

impl Generated7 {
    pub fn position1(phi1) -> Position1 {
        q56,
        q50,
        s55,
        t54,
        s47,
        s41,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q56,
        velocity0: velocity(q56),
        acceleration0: acceleration(q56),
        jerk0: jerk(q56),
        q50,
        velocity1: velocity(q50),
        acceleration1: acceleration(q50),
        jerk1: jerk(q50),
        s55,
        velocity2: velocity(s55),
        acceleration2: acceleration(s55),
        jerk2: jerk(s55),
        t54,
        velocity3: velocity(t54),
        acceleration3: acceleration(t54),
        jerk3: jerk(t54)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q56,
        e0: sensitivity(q56, [f2.y, w27]),
        v0: d(q56, phi1),
        m0: d(q56, phi1, f2.y),
        w0: d(q56, f2.y, w27),
        q50,
        e1: sensitivity(q50, [l32, f2.y]),
        v1: d(q50, phi1),
        m1: d(q50, phi1, l32),
        w1: d(q50, l32, f2.y),
        s55,
        e2: sensitivity(s55, [l17, l43]),
        v2: d(s55, phi1),
        m2: d(s55, phi1, l17),
        w2: d(s55, l17, l43),
        t54,
        e3: sensitivity(t54, [w27, f20.y]),
        v3: d(t54, phi1),
        m3: d(t54, phi1, w27),
        w3: d(t54, w27, f20.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f10 + polar(s15, w11) + polar(l13, w11 + 90deg)) - (q9 + polar(l12, t14)),
        v0: velocity((f10 + polar(s15, w11) + polar(l13, w11 + 90deg)) - (q9 + polar(l12, t14))),
        a0: acceleration((f10 + polar(s15, w11) + polar(l13, w11 + 90deg)) - (q9 + polar(l12, t14))),
        r1: (q19 + rotate((l21, 0mm), t22)) - (f20 + polar(-l24, t23 + 180deg)),
        v1: velocity((q19 + rotate((l21, 0mm), t22)) - (f20 + polar(-l24, t23 + 180deg))),
        a1: acceleration((q19 + rotate((l21, 0mm), t22)) - (f20 + polar(-l24, t23 + 180deg))),
        r2: (polar(l29, t30) - l32 * dir(t31)) - (q9 - q19),
        v2: velocity((polar(l29, t30) - l32 * dir(t31)) - (q9 - q19)),
        a2: acceleration((polar(l29, t30) - l32 * dir(t31)) - (q9 - q19)),
        r3: (q33 + rotate((s41, l39), t14 + w37)) - (q4 + polar(l38, t40)),
        v3: velocity((q33 + rotate((s41, l39), t14 + w37)) - (q4 + polar(l38, t40))),
        a3: acceleration((q33 + rotate((s41, l39), t14 + w37)) - (q4 + polar(l38, t40))),
        r4: (l49) - (dot(q42 + polar(s47, w46) - q45, dir(w48))),
        v4: velocity((l49) - (dot(q42 + polar(s47, w46) - q45, dir(w48)))),
        a4: acceleration((l49) - (dot(q42 + polar(s47, w46) - q45, dir(w48)))),
        r5: (q42 + polar(l52, t54)) - (q45 + polar(s55, phi1 + w51) + polar(l53, phi1 + w51 + 90deg)),
        v5: velocity((q42 + polar(l52, t54)) - (q45 + polar(s55, phi1 + w51) + polar(l53, phi1 + w51 + 90deg))),
        a5: acceleration((q42 + polar(l52, t54)) - (q45 + polar(s55, phi1 + w51) + polar(l53, phi1 + w51 + 90deg)))
    }
}
}
    position1(0): q56, q50, s55, t54, s47, s41, margin;
    motion1(0): q56, velocity0, acceleration0, jerk0, q50, velocity1, acceleration1, jerk1, s55, velocity2, acceleration2, jerk2, t54, velocity3, acceleration3, jerk3;
    accuracy1(0): q56, e0, v0, m0, w0, q50, e1, v1, m1, w1, s55, e2, v2, m2, w2, t54, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m8 Generated8 [l2, w4, f6.x, f6.y, l7, w9, l10, l15, w16, f18.x, f18.y, w19, f20.x, f20.y, w21, l22, l23, w27, l28, l33, w34, w36, l37, l38, f42.x, f42.y, w44, l45, l46, l50, w51, f53.x, f53.y, l54, l57]
    {
pub struct Generated8 {
    unit cm;
    input phi1 = 0.2234021rad in 0.2231964rad..0.2236079rad;
    param l2 = 40.6709mm;
    let q3 = polar(l2, phi1);
    param w4 = -0.8397694rad;
    let g5 = 2 * phi1 + w4;
    param f6 = (48.7822mm, 0.0000mm);
    param l7 = 26.0285mm;
    let q8 = f6 + polar(l7, g5);
    param w9 = 3.0686935rad;
    param l10 = 80.4623mm;
    const l11 = -39.2197mm;
    unknown t12 = 132deg;
    unknown s13 = 23.6mm;
    loop q3 + polar(s13, w9) + polar(l11, w9 + 90deg) = q8 + polar(l10, t12);
    let q14 = q8 + polar(l10, t12);
    param l15 = 37.5181mm +- 20um;
    param w16 = -1.8627261rad;
    let q17 = q8 + polar(l15, t12 + w16);
    param f18 = (165.8656mm, -33.0693mm);
    param w19 = -0.7430276rad;
    param f20 = (14.8346mm, -21.5446mm);
    param w21 = 1.4961320rad;
    param l22 = 81.0551mm;
    param l23 = -28.5457mm;
    unknown t24 = 64deg;
    unknown s25 = 146.9mm;
    loop q14 + polar(l22, t24) = f20 + dir(w21) * s25 + l23 * dir(90deg + w21);
    let q26 = q14 + polar(l22, t24);
    param w27 = 1.8545070rad;
    param l28 = 72.5801mm +- 20um;
    const l29 = -18.3894mm;
    unknown t30 = 68deg;
    unknown s31 = 84.5mm;
    loop q8 + polar(s31, w27) + polar(l29, w27 + 90deg) = q3 + polar(l28, t30);
    let q32 = q3 + polar(l28, t30);
    param l33 = 48.8946mm +- 20um;
    param w34 = 0.3724928rad;
    let q35 = q3 + polar(l33, t30 + w34);
    param w36 = -1.9788734rad;
    param l37 = 45.5886mm;
    param l38 = 20.7862mm +- 20um;
    unknown t39 = -103deg;
    unknown s40 = 110.1mm;
    loop q26 + dir(w36) * s40 + l38 * dir(90deg + w36) = q35 + polar(l37, t39);
    let q41 = q35 + polar(l37, t39);
    param f42 = (112.9930mm, 30.9087mm);
    const f43 = (-43.8746mm, 71.4677mm);
    param w44 = 1.4652826rad;
    param l45 = 90.7858mm +- 20um;
    param l46 = -24.4623mm +- 20um;
    unknown t47 = 110deg;
    unknown s48 = 66.4mm;
    loop q14 + polar(l45, t47) = f43 + dir(w44) * s48 + l46 * dir(90deg + w44);
    let q49 = q14 + polar(l45, t47);
    param l50 = 27.9804mm;
    param w51 = 2.1185641rad;
    let q52 = q14 + polar(l50, t47 + w51);
    param f53 = (10.6271mm, 122.0371mm);
    param l54 = 110.6623mm;
    unknown t55 = 118deg;
    unknown t56 = 177deg;
    param l57 = 61.6625mm +- 20um;
    loop q52 + polar(l54, t55) = f53 + polar(l57, t56);
    let q58 = q52 + polar(l54, t55);
}

impl Generated8 {
    pub fn position1(phi1) -> Position1 {
        q58,
        q52,
        t56,
        t55,
        s48,
        t47,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q58,
        velocity0: velocity(q58),
        acceleration0: acceleration(q58),
        jerk0: jerk(q58),
        q52,
        velocity1: velocity(q52),
        acceleration1: acceleration(q52),
        jerk1: jerk(q52),
        t56,
        velocity2: velocity(t56),
        acceleration2: acceleration(t56),
        jerk2: jerk(t56),
        t55,
        velocity3: velocity(t55),
        acceleration3: acceleration(t55),
        jerk3: jerk(t55)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q58,
        e0: sensitivity(q58, [f20.y, f53.y]),
        v0: d(q58, phi1),
        m0: d(q58, phi1, f20.y),
        w0: d(q58, f20.y, f53.y),
        q52,
        e1: sensitivity(q52, [f6.x, l45]),
        v1: d(q52, phi1),
        m1: d(q52, phi1, f6.x),
        w1: d(q52, f6.x, l45),
        t56,
        e2: sensitivity(t56, [f53.x, w27]),
        v2: d(t56, phi1),
        m2: d(t56, phi1, f53.x),
        w2: d(t56, f53.x, w27),
        t55,
        e3: sensitivity(t55, [f18.y, l38]),
        v3: d(t55, phi1),
        m3: d(t55, phi1, f18.y),
        w3: d(t55, f18.y, l38)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q3 + polar(s13, w9) + polar(l11, w9 + 90deg)) - (q8 + polar(l10, t12)),
        v0: velocity((q3 + polar(s13, w9) + polar(l11, w9 + 90deg)) - (q8 + polar(l10, t12))),
        a0: acceleration((q3 + polar(s13, w9) + polar(l11, w9 + 90deg)) - (q8 + polar(l10, t12))),
        r1: (q14 + polar(l22, t24)) - (f20 + dir(w21) * s25 + l23 * dir(90deg + w21)),
        v1: velocity((q14 + polar(l22, t24)) - (f20 + dir(w21) * s25 + l23 * dir(90deg + w21))),
        a1: acceleration((q14 + polar(l22, t24)) - (f20 + dir(w21) * s25 + l23 * dir(90deg + w21))),
        r2: (q8 + polar(s31, w27) + polar(l29, w27 + 90deg)) - (q3 + polar(l28, t30)),
        v2: velocity((q8 + polar(s31, w27) + polar(l29, w27 + 90deg)) - (q3 + polar(l28, t30))),
        a2: acceleration((q8 + polar(s31, w27) + polar(l29, w27 + 90deg)) - (q3 + polar(l28, t30))),
        r3: (q26 + dir(w36) * s40 + l38 * dir(90deg + w36)) - (q35 + polar(l37, t39)),
        v3: velocity((q26 + dir(w36) * s40 + l38 * dir(90deg + w36)) - (q35 + polar(l37, t39))),
        a3: acceleration((q26 + dir(w36) * s40 + l38 * dir(90deg + w36)) - (q35 + polar(l37, t39))),
        r4: (q14 + polar(l45, t47)) - (f43 + dir(w44) * s48 + l46 * dir(90deg + w44)),
        v4: velocity((q14 + polar(l45, t47)) - (f43 + dir(w44) * s48 + l46 * dir(90deg + w44))),
        a4: acceleration((q14 + polar(l45, t47)) - (f43 + dir(w44) * s48 + l46 * dir(90deg + w44))),
        r5: (q52 + polar(l54, t55)) - (f53 + polar(l57, t56)),
        v5: velocity((q52 + polar(l54, t55)) - (f53 + polar(l57, t56))),
        a5: acceleration((q52 + polar(l54, t55)) - (f53 + polar(l57, t56)))
    }
}
}
    position1(0): q58, q52, t56, t55, s48, t47, margin;
    motion1(0): q58, velocity0, acceleration0, jerk0, q52, velocity1, acceleration1, jerk1, t56, velocity2, acceleration2, jerk2, t55, velocity3, acceleration3, jerk3;
    accuracy1(0): q58, e0, v0, m0, w0, q52, e1, v1, m1, w1, t56, e2, v2, m2, w2, t55, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m10 Generated10 [f2.x, f2.y, l3, f5.x, f5.y, w6, w7, f11.x, f11.y, w12, l14, f16.x, f16.y, f17.x, f17.y, w18, w19, f20.x, f20.y, w21, w22, f26.x, f26.y, l27, l30, w31, l33, l36]
    {
pub struct Generated10 {
    unit m;
    input phi1 = 2.1188297rad in 2.1182124rad..2.1194470rad;
    param f2 = (-37.3351mm, 18.7494mm);
    param l3 = 23.9292mm;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (-35.0242mm, -11.2053mm);
    param w6 = -1.2739535rad;
    param w7 = 1.0916452rad;
    unknown s8 = 52.6mm;
    unknown s9 = -0.6mm;
    loop f5 + polar(s9, phi1 + w7) = q4 + polar(s8, w6);
    let q10 = q4 + polar(s8, w6);
    param f11 = (42.8842mm, -49.3819mm);
    param w12 = 1.7846988rad;
    unknown s13 = 44.5mm;
    param l14 = 119.1999mm +- 20um;
    loop l14 = distance(f11, q10 + polar(s13, w12));
    let q15 = q10 + polar(s13, w12);
    param f16 = (-88.2602mm, -12.2584mm);
    param f17 = (-88.9576mm, -13.6097mm);
    param w18 = -0.1173596rad;
    param w19 = 2.5476404rad;
    param f20 = (-134.6909mm, 88.7249mm);
    param w21 = 1.0658000rad;
    param w22 = -0.4835844rad;
    unknown s23 = -151.2mm;
    unknown s24 = -182.3mm;
    loop f20 + polar(s24, phi1 + w22) = q4 + polar(s23, w21);
    let q25 = q4 + polar(s23, w21);
    param f26 = (-6.7152mm, -53.2646mm);
    param l27 = 17.7375mm +- 20um;
    unknown t28 = 102deg;
    unknown s29 = 91.6mm;
    loop f26 + s29 * dir(t28) - polar(l27, t28 - 90deg) = q15;
    param l30 = 41.3004mm +- 20um;
    param w31 = 2.1048236rad;
    let q32 = f26 + polar(l30, t28 + w31);
    param l33 = 42.3933mm;
    unknown t34 = -41deg;
    unknown t35 = -117deg;
    param l36 = 123.4442mm +- 20um;
    loop q25 + polar(l33, t34) = q10 + polar(l36, t35);
    let q37 = q25 + polar(l33, t34);
}

impl Generated10 {
    pub fn position1(phi1) -> Position1 {
        q37,
        q32,
        t35,
        t34,
        s29,
        t28,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q37,
        velocity0: velocity(q37),
        acceleration0: acceleration(q37),
        jerk0: jerk(q37),
        q32,
        velocity1: velocity(q32),
        acceleration1: acceleration(q32),
        jerk1: jerk(q32),
        t35,
        velocity2: velocity(t35),
        acceleration2: acceleration(t35),
        jerk2: jerk(t35),
        t34,
        velocity3: velocity(t34),
        acceleration3: acceleration(t34),
        jerk3: jerk(t34)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q37,
        e0: sensitivity(q37, [f2.x, f11.x]),
        v0: d(q37, phi1),
        m0: d(q37, phi1, f2.x),
        w0: d(q37, f2.x, f11.x),
        q32,
        e1: sensitivity(q32, [f5.x, f11.x]),
        v1: d(q32, phi1),
        m1: d(q32, phi1, f5.x),
        w1: d(q32, f5.x, f11.x),
        t35,
        e2: sensitivity(t35, [f26.x, f16.y]),
        v2: d(t35, phi1),
        m2: d(t35, phi1, f26.x),
        w2: d(t35, f26.x, f16.y),
        t34,
        e3: sensitivity(t34, [w19, l27]),
        v3: d(t34, phi1),
        m3: d(t34, phi1, w19),
        w3: d(t34, w19, l27)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f5 + polar(s9, phi1 + w7)) - (q4 + polar(s8, w6)),
        v0: velocity((f5 + polar(s9, phi1 + w7)) - (q4 + polar(s8, w6))),
        a0: acceleration((f5 + polar(s9, phi1 + w7)) - (q4 + polar(s8, w6))),
        r1: (l14) - (distance(f11, q10 + polar(s13, w12))),
        v1: velocity((l14) - (distance(f11, q10 + polar(s13, w12)))),
        a1: acceleration((l14) - (distance(f11, q10 + polar(s13, w12)))),
        r2: (f20 + polar(s24, phi1 + w22)) - (q4 + polar(s23, w21)),
        v2: velocity((f20 + polar(s24, phi1 + w22)) - (q4 + polar(s23, w21))),
        a2: acceleration((f20 + polar(s24, phi1 + w22)) - (q4 + polar(s23, w21))),
        r3: (f26 + s29 * dir(t28) - polar(l27, t28 - 90deg)) - (q15),
        v3: velocity((f26 + s29 * dir(t28) - polar(l27, t28 - 90deg)) - (q15)),
        a3: acceleration((f26 + s29 * dir(t28) - polar(l27, t28 - 90deg)) - (q15)),
        r4: (q25 + polar(l33, t34)) - (q10 + polar(l36, t35)),
        v4: velocity((q25 + polar(l33, t34)) - (q10 + polar(l36, t35))),
        a4: acceleration((q25 + polar(l33, t34)) - (q10 + polar(l36, t35)))
    }
}
}
    position1(0): q37, q32, t35, t34, s29, t28, margin;
    motion1(0): q37, velocity0, acceleration0, jerk0, q32, velocity1, acceleration1, jerk1, t35, velocity2, acceleration2, jerk2, t34, velocity3, acceleration3, jerk3;
    accuracy1(0): q37, e0, v0, m0, w0, q32, e1, v1, m1, w1, t35, e2, v2, m2, w2, t34, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4;
}

corpus! {
    m11 Generated11 [l2, f4.x, f4.y, w5, l6, l7, w12, w14, f16.x, f16.y, l17, f20.x, f20.y, l21, l24, l26, w27, f29.x, f29.y, w30, f34.x, f34.y, l35, l37]
    {
pub struct Generated11 {
    unit mm;
    input phi1 = 0.0279253rad;
    param l2 = 39.1413mm +- 20um;
    let q3 = polar(l2, phi1);
    param f4 = (-62.9636mm, 37.1428mm);
    param w5 = 0.8645530rad;
    param l6 = 84.8608mm +- 20um;
    param l7 = -33.3547mm;
    unknown t8 = 105deg;
    unknown s9 = 85.7mm;
    loop f4 + polar(s9, phi1 + w5) + polar(l7, phi1 + w5 + 90deg) = q3 + polar(l6, t8);
    let q10 = q3 + polar(l6, t8);
    const l11 = 30.8153mm;
    param w12 = 0.1694544rad;
    let q13 = q3 + polar(l11, t8 + w12);
    param w14 = 1.8235670rad;
    unknown t15 = -106deg;
    loop w14 - 2 * (t8) = t15;
    param f16 = (0.0000mm, 0.0000mm);
    param l17 = 45.7863mm;
    unknown p18 = (-12.6mm, -44.0mm);
    loop f16 + polar(l17, t15) = p18;
    let q19 = p18;
    param f20 = (-33.6713mm, -66.7714mm);
    param l21 = 107.8225mm;
    unknown t22 = -117deg;
    unknown t23 = -50deg;
    param l24 = 37.3740mm +- 20um;
    loop q3 + polar(l21, t22) = f20 + polar(l24, t23);
    let q25 = q3 + polar(l21, t22);
    param l26 = 53.0754mm;
    param w27 = -0.0415937rad;
    let q28 = q3 + polar(l26, t22 + w27);
    param f29 = (-68.9707mm, -19.7811mm);
    param w30 = -0.1083782rad;
    unknown s31 = -146.0mm;
    unknown s32 = -95.2mm;
    loop f29 + polar(s32, (-90deg)) = q28 + polar(s31, t23 + w30);
    let q33 = q28 + polar(s31, t23 + w30);
    param f34 = (52.4308mm, -125.3776mm);
    param l35 = 54.3417mm;
    unknown t36 = 34deg;
    param l37 = 62.4881mm;
    loop distance(q25 + polar(l35, t36), f34) = l37;
    let q38 = q25 + polar(l35, t36);
}

impl Generated11 {
    pub fn position1(phi1) -> Position1 {
        q38,
        q33,
        t36,
        s32,
        s31,
        t23,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q38,
        velocity0: velocity(q38),
        acceleration0: acceleration(q38),
        jerk0: jerk(q38),
        q33,
        velocity1: velocity(q33),
        acceleration1: acceleration(q33),
        jerk1: jerk(q33),
        t36,
        velocity2: velocity(t36),
        acceleration2: acceleration(t36),
        jerk2: jerk(t36),
        s32,
        velocity3: velocity(s32),
        acceleration3: acceleration(s32),
        jerk3: jerk(s32)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q38,
        e0: sensitivity(q38, [f29.x, f20.y]),
        v0: d(q38, phi1),
        m0: d(q38, phi1, f29.x),
        w0: d(q38, f29.x, f20.y),
        q33,
        e1: sensitivity(q33, [w30, f4.y]),
        v1: d(q33, phi1),
        m1: d(q33, phi1, w30),
        w1: d(q33, w30, f4.y),
        t36,
        e2: sensitivity(t36, [f29.y, f34.x]),
        v2: d(t36, phi1),
        m2: d(t36, phi1, f29.y),
        w2: d(t36, f29.y, f34.x),
        s32,
        e3: sensitivity(s32, [f20.x, w5]),
        v3: d(s32, phi1),
        m3: d(s32, phi1, f20.x),
        w3: d(s32, f20.x, w5)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f4 + polar(s9, phi1 + w5) + polar(l7, phi1 + w5 + 90deg)) - (q3 + polar(l6, t8)),
        v0: velocity((f4 + polar(s9, phi1 + w5) + polar(l7, phi1 + w5 + 90deg)) - (q3 + polar(l6, t8))),
        a0: acceleration((f4 + polar(s9, phi1 + w5) + polar(l7, phi1 + w5 + 90deg)) - (q3 + polar(l6, t8))),
        r1: (q3 + polar(l21, t22)) - (f20 + polar(l24, t23)),
        v1: velocity((q3 + polar(l21, t22)) - (f20 + polar(l24, t23))),
        a1: acceleration((q3 + polar(l21, t22)) - (f20 + polar(l24, t23))),
        r2: (f29 + polar(s32, (-90deg))) - (q28 + polar(s31, t23 + w30)),
        v2: velocity((f29 + polar(s32, (-90deg))) - (q28 + polar(s31, t23 + w30))),
        a2: acceleration((f29 + polar(s32, (-90deg))) - (q28 + polar(s31, t23 + w30))),
        r3: (distance(q25 + polar(l35, t36), f34)) - (l37),
        v3: velocity((distance(q25 + polar(l35, t36), f34)) - (l37)),
        a3: acceleration((distance(q25 + polar(l35, t36), f34)) - (l37))
    }
}
}
    position1(0): q38, q33, t36, s32, s31, t23, margin;
    motion1(0): q38, velocity0, acceleration0, jerk0, q33, velocity1, acceleration1, jerk1, t36, velocity2, acceleration2, jerk2, s32, velocity3, acceleration3, jerk3;
    accuracy1(0): q38, e0, v0, m0, w0, q33, e1, v1, m1, w1, t36, e2, v2, m2, w2, s32, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3;
}

corpus! {
    m13 Generated13 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f10.x, f10.y, l11, l14, l16, w17]
    {
pub struct Generated13 {
    unit mm;
    input phi1 = -1.2915436rad in -1.3415436rad..-1.2415436rad;
    param f2 = (21.4968mm, -13.7050mm);
    param l3 = 38.9856mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.4050489rad;
    let g6 = w5 - phi1;
    param f7 = (70.2983mm, -13.7050mm);
    param l8 = 39.1636mm;
    let q9 = f7 + polar(l8, g6);
    param f10 = (-0.8302mm, 29.4846mm);
    param l11 = 71.1757mm;
    unknown t12 = -110deg;
    unknown t13 = -60deg;
    param l14 = 82.5520mm +- 20um;
    loop q9 + polar(l11, t12) = f10 + polar(l14, t13);
    let q15 = q9 + polar(l11, t12);
    param l16 = 52.4221mm;
    param w17 = -2.3784962rad;
    let q18 = q9 + polar(l16, t12 + w17);
}

impl Generated13 {
    pub fn position1(phi1) -> Position1 {
        q18,
        q15,
        t13,
        t12,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q18,
        velocity0: velocity(q18),
        acceleration0: acceleration(q18),
        jerk0: jerk(q18),
        q15,
        velocity1: velocity(q15),
        acceleration1: acceleration(q15),
        jerk1: jerk(q15),
        t13,
        velocity2: velocity(t13),
        acceleration2: acceleration(t13),
        jerk2: jerk(t13),
        t12,
        velocity3: velocity(t12),
        acceleration3: acceleration(t12),
        jerk3: jerk(t12)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q18,
        e0: sensitivity(q18, [w17, f7.y]),
        v0: d(q18, phi1),
        m0: d(q18, phi1, w17),
        w0: d(q18, w17, f7.y),
        q15,
        e1: sensitivity(q15, [l11, l8]),
        v1: d(q15, phi1),
        m1: d(q15, phi1, l11),
        w1: d(q15, l11, l8),
        t13,
        e2: sensitivity(t13, [l8, w17]),
        v2: d(t13, phi1),
        m2: d(t13, phi1, l8),
        w2: d(t13, l8, w17),
        t12,
        e3: sensitivity(t12, [f2.y, w5]),
        v3: d(t12, phi1),
        m3: d(t12, phi1, f2.y),
        w3: d(t12, f2.y, w5)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q9 + polar(l11, t12)) - (f10 + polar(l14, t13)),
        v0: velocity((q9 + polar(l11, t12)) - (f10 + polar(l14, t13))),
        a0: acceleration((q9 + polar(l11, t12)) - (f10 + polar(l14, t13)))
    }
}
}
    position1(0): q18, q15, t13, t12, margin;
    motion1(0): q18, velocity0, acceleration0, jerk0, q15, velocity1, acceleration1, jerk1, t13, velocity2, acceleration2, jerk2, t12, velocity3, acceleration3, jerk3;
    accuracy1(0): q18, e0, v0, m0, w0, q15, e1, v1, m1, w1, t13, e2, v2, m2, w2, t12, e3, v3, m3, w3;
    closure1(0): r0, v0, a0;
}

corpus! {
    m14 Generated14 [f2.x, f2.y, f5.x, f5.y, l6, l9, l11, w12, f14.x, f14.y, l15, l18, w19, f21.x, f21.y, w22, w23, w27, l28, l29, l33, w34, f36.x, f36.y, w37, w38, f39.x, f39.y, l40, l43, f45.x, f45.y, l46, l49, w50]
    {
pub struct Generated14 {
    unit mm;
    input phi1 = 0.9930923rad;
    param f2 = (-6.6677mm, -34.2955mm);
    const l3 = 20.4480mm;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (71.4360mm, 25.4096mm);
    param l6 = 104.3893mm;
    unknown t7 = 21deg;
    unknown t8 = -9deg;
    param l9 = 30.6639mm +- 20um;
    loop f5 + polar(l9, t8) = q4 + polar(l6, t7);
    let q10 = q4 + polar(l6, t7);
    param l11 = 55.5886mm;
    param w12 = 2.1447232rad;
    let q13 = q4 + polar(l11, t7 + w12);
    param f14 = (201.2421mm, -12.5879mm);
    param l15 = 19.4979mm;
    unknown t16 = 151deg;
    unknown s17 = 103.1mm;
    loop q10 = f14 + polar(s17, t16) + polar(l15, t16 + 90deg);
    param l18 = 36.7830mm;
    param w19 = -1.8955163rad;
    let q20 = f14 + polar(l18, t16 + w19);
    param f21 = (270.5200mm, -15.9763mm);
    param w22 = 0.8907456rad;
    param w23 = -0.7809774rad;
    unknown s24 = 9.7mm;
    unknown s25 = -50.6mm;
    loop q20 + polar(s24, w22) = f21 + polar(s25, w23);
    let q26 = q20 + polar(s24, w22);
    param w27 = -0.4561550rad;
    param l28 = 95.2980mm;
    param l29 = -24.2237mm +- 20um;
    unknown t30 = -43deg;
    unknown s31 = -32.9mm;
    loop q4 + dir(90deg) * s31 + l29 * dir(90deg + 90deg) = q13 + polar(l28, t30);
    let q32 = q13 + polar(l28, t30);
    param l33 = 25.8471mm +- 20um;
    param w34 = -0.7922656rad;
    let q35 = q13 + polar(l33, t30 + w34);
    param f36 = (215.9824mm, 77.0214mm);
    param w37 = -2.7473167rad;
    param w38 = 0.7170324rad;
    param f39 = (11.5899mm, -37.2255mm);
    param l40 = 72.0769mm +- 20um;
    unknown t41 = -113deg;
    unknown t42 = -153deg;
    param l43 = -88.7345mm;
    loop f39 + polar((-l43), t42) = q35 + polar(l40, t41);
    let q44 = q35 + polar(l40, t41);
    param f45 = (310.6574mm, 40.1560mm);
    param l46 = 27.4487mm;
    unknown t47 = -180deg;
    unknown s48 = 82.4mm;
    loop f45 + polar(s48, t47) + polar(l46, t47 + 90deg) = q20;
    param l49 = 41.1606mm;
    param w50 = -0.2563739rad;
    let q51 = f45 + polar(l49, t47 + w50);
}

impl Generated14 {
    pub fn position1(phi1) -> Position1 {
        q51,
        q44,
        s48,
        t47,
        t42,
        t41,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q51,
        velocity0: velocity(q51),
        acceleration0: acceleration(q51),
        jerk0: jerk(q51),
        q44,
        velocity1: velocity(q44),
        acceleration1: acceleration(q44),
        jerk1: jerk(q44),
        s48,
        velocity2: velocity(s48),
        acceleration2: acceleration(s48),
        jerk2: jerk(s48),
        t47,
        velocity3: velocity(t47),
        acceleration3: acceleration(t47),
        jerk3: jerk(t47)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q51,
        e0: sensitivity(q51, [w37, w23]),
        v0: d(q51, phi1),
        m0: d(q51, phi1, w37),
        w0: d(q51, w37, w23),
        q44,
        e1: sensitivity(q44, [w22, w38]),
        v1: d(q44, phi1),
        m1: d(q44, phi1, w22),
        w1: d(q44, w22, w38),
        s48,
        e2: sensitivity(s48, [l6, f39.x]),
        v2: d(s48, phi1),
        m2: d(s48, phi1, l6),
        w2: d(s48, l6, f39.x),
        t47,
        e3: sensitivity(t47, [w23, f2.y]),
        v3: d(t47, phi1),
        m3: d(t47, phi1, w23),
        w3: d(t47, w23, f2.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f5 + polar(l9, t8)) - (q4 + polar(l6, t7)),
        v0: velocity((f5 + polar(l9, t8)) - (q4 + polar(l6, t7))),
        a0: acceleration((f5 + polar(l9, t8)) - (q4 + polar(l6, t7))),
        r1: (q10) - (f14 + polar(s17, t16) + polar(l15, t16 + 90deg)),
        v1: velocity((q10) - (f14 + polar(s17, t16) + polar(l15, t16 + 90deg))),
        a1: acceleration((q10) - (f14 + polar(s17, t16) + polar(l15, t16 + 90deg))),
        r2: (q20 + polar(s24, w22)) - (f21 + polar(s25, w23)),
        v2: velocity((q20 + polar(s24, w22)) - (f21 + polar(s25, w23))),
        a2: acceleration((q20 + polar(s24, w22)) - (f21 + polar(s25, w23))),
        r3: (q4 + dir(90deg) * s31 + l29 * dir(90deg + 90deg)) - (q13 + polar(l28, t30)),
        v3: velocity((q4 + dir(90deg) * s31 + l29 * dir(90deg + 90deg)) - (q13 + polar(l28, t30))),
        a3: acceleration((q4 + dir(90deg) * s31 + l29 * dir(90deg + 90deg)) - (q13 + polar(l28, t30))),
        r4: (f39 + polar((-l43), t42)) - (q35 + polar(l40, t41)),
        v4: velocity((f39 + polar((-l43), t42)) - (q35 + polar(l40, t41))),
        a4: acceleration((f39 + polar((-l43), t42)) - (q35 + polar(l40, t41))),
        r5: (f45 + polar(s48, t47) + polar(l46, t47 + 90deg)) - (q20),
        v5: velocity((f45 + polar(s48, t47) + polar(l46, t47 + 90deg)) - (q20)),
        a5: acceleration((f45 + polar(s48, t47) + polar(l46, t47 + 90deg)) - (q20))
    }
}
}
    position1(0): q51, q44, s48, t47, t42, t41, margin;
    motion1(0): q51, velocity0, acceleration0, jerk0, q44, velocity1, acceleration1, jerk1, s48, velocity2, acceleration2, jerk2, t47, velocity3, acceleration3, jerk3;
    accuracy1(0): q51, e0, v0, m0, w0, q44, e1, v1, m1, w1, s48, e2, v2, m2, w2, t47, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m16 Generated16 [f2.x, f2.y, l3, f5.x, f5.y, l9, w10, w12, l13, l14, l18, w19, f21.x, f21.y, l23]
    {
pub struct Generated16 {
    unit cm;
    input phi1 = 0.5619960rad in 0.5564405rad..0.5675516rad;
    param f2 = (-10.6622mm, -33.6401mm);
    param l3 = 45.4531mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (72.5413mm, 37.0393mm);
    const l6 = -19.0418mm;
    unknown t7 = 29deg;
    unknown s8 = -61.6mm;
    loop f5 + polar(s8, t7) + polar(l6, t7 + 90deg) = q4;
    param l9 = 54.2327mm +- 20um;
    param w10 = -1.4574230rad;
    let q11 = f5 + polar(l9, t7 + w10);
    param w12 = -0.9909726rad;
    param l13 = 94.9476mm +- 20um;
    param l14 = -32.9014mm;
    unknown t15 = -69deg;
    unknown s16 = 136.0mm;
    loop q11 + polar(l13, t15) = q4 + dir(phi1 + w12) * s16 + l14 * dir(90deg + phi1 + w12);
    let q17 = q11 + polar(l13, t15);
    param l18 = 42.0164mm;
    param w19 = 0.7264318rad;
    let q20 = q11 + polar(l18, t15 + w19);
    param f21 = (209.0860mm, -34.1363mm);
    const l22 = 40.6522mm;
    param l23 = -9.0835mm;
    unknown t24 = -24deg;
    unknown s25 = -30.8mm;
    loop q20 + polar(l22, t24) = f21 + dir(0deg) * s25 + l23 * dir(90deg + 0deg);
    let q26 = q20 + polar(l22, t24);
}

impl Generated16 {
    pub fn position1(phi1) -> Position1 {
        q26,
        q20,
        s25,
        t24,
        s16,
        t15,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q26,
        velocity0: velocity(q26),
        acceleration0: acceleration(q26),
        jerk0: jerk(q26),
        q20,
        velocity1: velocity(q20),
        acceleration1: acceleration(q20),
        jerk1: jerk(q20),
        s25,
        velocity2: velocity(s25),
        acceleration2: acceleration(s25),
        jerk2: jerk(s25),
        t24,
        velocity3: velocity(t24),
        acceleration3: acceleration(t24),
        jerk3: jerk(t24)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q26,
        e0: sensitivity(q26, [w19, w12]),
        v0: d(q26, phi1),
        m0: d(q26, phi1, w19),
        w0: d(q26, w19, w12),
        q20,
        e1: sensitivity(q20, [f21.x, l3]),
        v1: d(q20, phi1),
        m1: d(q20, phi1, f21.x),
        w1: d(q20, f21.x, l3),
        s25,
        e2: sensitivity(s25, [l3, w10]),
        v2: d(s25, phi1),
        m2: d(s25, phi1, l3),
        w2: d(s25, l3, w10),
        t24,
        e3: sensitivity(t24, [f5.y, w10]),
        v3: d(t24, phi1),
        m3: d(t24, phi1, f5.y),
        w3: d(t24, f5.y, w10)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f5 + polar(s8, t7) + polar(l6, t7 + 90deg)) - (q4),
        v0: velocity((f5 + polar(s8, t7) + polar(l6, t7 + 90deg)) - (q4)),
        a0: acceleration((f5 + polar(s8, t7) + polar(l6, t7 + 90deg)) - (q4)),
        r1: (q11 + polar(l13, t15)) - (q4 + dir(phi1 + w12) * s16 + l14 * dir(90deg + phi1 + w12)),
        v1: velocity((q11 + polar(l13, t15)) - (q4 + dir(phi1 + w12) * s16 + l14 * dir(90deg + phi1 + w12))),
        a1: acceleration((q11 + polar(l13, t15)) - (q4 + dir(phi1 + w12) * s16 + l14 * dir(90deg + phi1 + w12))),
        r2: (q20 + polar(l22, t24)) - (f21 + dir(0deg) * s25 + l23 * dir(90deg + 0deg)),
        v2: velocity((q20 + polar(l22, t24)) - (f21 + dir(0deg) * s25 + l23 * dir(90deg + 0deg))),
        a2: acceleration((q20 + polar(l22, t24)) - (f21 + dir(0deg) * s25 + l23 * dir(90deg + 0deg)))
    }
}
}
    position1(0): q26, q20, s25, t24, s16, t15, margin;
    motion1(0): q26, velocity0, acceleration0, jerk0, q20, velocity1, acceleration1, jerk1, s25, velocity2, acceleration2, jerk2, t24, velocity3, acceleration3, jerk3;
    accuracy1(0): q26, e0, v0, m0, w0, q20, e1, v1, m1, w1, s25, e2, v2, m2, w2, t24, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m17 Generated17 [w4, f6.x, f6.y, l7, w9, l12, w15, f17.x, f17.y, l18, w20, f22.x, f22.y, l23]
    {
pub struct Generated17 {
    unit mm;
    input phi1 = -1.7121680rad in -1.7177236rad..-1.7066124rad;
    const l2 = 29.8499mm;
    let q3 = polar(l2, phi1);
    param w4 = 0.3070595rad;
    let g5 = w4 - phi1 / 2;
    param f6 = (51.2682mm, 0.0000mm);
    param l7 = 16.9993mm;
    let q8 = f6 + polar(l7, g5);
    param w9 = -1.3394519rad;
    unknown t10 = -143deg;
    loop w9 - (g5) = t10;
    const f11 = (0.0000mm, 0.0000mm);
    param l12 = 30.2928mm;
    unknown p13 = (-24.3mm, -18.1mm);
    loop p13 = f11 + polar(l12, t10);
    let q14 = p13;
    param w15 = 1.7974257rad;
    unknown t16 = 36deg;
    loop t16 = w15 - (g5);
    param f17 = (0.0000mm, 0.0000mm);
    param l18 = 37.5319mm;
    let q19 = f17 + polar(l18, t16);
    param w20 = 1.0337033rad;
    unknown t21 = -12deg;
    loop t21 = (t10) / 2 + w20;
    param f22 = (0.0000mm, 0.0000mm);
    param l23 = 20.4299mm;
    let q24 = f22 + polar(l23, t21);
}

impl Generated17 {
    pub fn position1(phi1) -> Position1 {
        q24,
        q19,
        t21,
        t16,
        p13,
        t10,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q24,
        velocity0: velocity(q24),
        acceleration0: acceleration(q24),
        jerk0: jerk(q24),
        q19,
        velocity1: velocity(q19),
        acceleration1: acceleration(q19),
        jerk1: jerk(q19),
        t21,
        velocity2: velocity(t21),
        acceleration2: acceleration(t21),
        jerk2: jerk(t21),
        t16,
        velocity3: velocity(t16),
        acceleration3: acceleration(t16),
        jerk3: jerk(t16)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q24,
        e0: sensitivity(q24, [f22.x, l23]),
        v0: d(q24, phi1),
        m0: d(q24, phi1, f22.x),
        w0: d(q24, f22.x, l23),
        q19,
        e1: sensitivity(q19, [l12, w15]),
        v1: d(q19, phi1),
        m1: d(q19, phi1, l12),
        w1: d(q19, l12, w15),
        t21,
        e2: sensitivity(t21, [w15, f22.y]),
        v2: d(t21, phi1),
        m2: d(t21, phi1, w15),
        w2: d(t21, w15, f22.y),
        t16,
        e3: sensitivity(t16, [w15, l7]),
        v3: d(t16, phi1),
        m3: d(t16, phi1, w15),
        w3: d(t16, w15, l7)
    }
}
}
    position1(0): q24, q19, t21, t16, p13, t10, margin;
    motion1(0): q24, velocity0, acceleration0, jerk0, q19, velocity1, acceleration1, jerk1, t21, velocity2, acceleration2, jerk2, t16, velocity3, acceleration3, jerk3;
    accuracy1(0): q24, e0, v0, m0, w0, q19, e1, v1, m1, w1, t21, e2, v2, m2, w2, t16, e3, v3, m3, w3;
}

corpus! {
    m19 Generated19 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f10.x, f10.y, l11, l14, l16, l19, l21, w22, f24.x, f24.y, l27, w28, f30.x, f30.y, l32, l33, l35, l38, l40, w41, w44, l45]
    {
pub struct Generated19 {
    unit mm;
    input phi1 = -2.5865780rad in -2.5867837rad..-2.5863722rad;
    param f2 = (18.8287mm, -30.6698mm);
    param l3 = 30.9081mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.0502137rad;
    let g6 = 2 * phi1 + w5;
    param f7 = (76.6119mm, -30.6698mm);
    param l8 = 36.8230mm;
    let q9 = f7 + polar(l8, g6);
    param f10 = (11.0409mm, -15.8019mm);
    param l11 = 79.6972mm +- 20um;
    unknown t12 = -109deg;
    unknown t13 = -46deg;
    param l14 = 78.3856mm;
    loop q9 + polar(l11, t12) = f10 + polar(l14, t13);
    let q15 = q9 + polar(l11, t12);
    param l16 = 58.5987mm;
    unknown t17 = -86deg;
    unknown t18 = -5deg;
    param l19 = 102.8416mm;
    loop q9 + polar(l16, t17) = q4 + polar(l19, t18);
    let q20 = q9 + polar(l16, t17);
    param l21 = 27.0006mm;
    param w22 = 0.0947202rad;
    let q23 = q9 + polar(l21, t17 + w22);
    param f24 = (-8.0522mm, -145.2421mm);
    unknown t25 = 45deg;
    unknown s26 = 103.5mm;
    loop q15 = f24 + polar(s26, t25);
    param l27 = 31.5095mm +- 20um;
    param w28 = 1.6928456rad;
    let q29 = f24 + polar(l27, t25 + w28);
    param f30 = (42.1746mm, -90.0692mm);
    unknown p31 = (-40.6mm, -200.8mm);
    param l32 = 75.4016mm +- 20um;
    loop l32 = norm(p31 - q29);
    param l33 = 138.2221mm;
    loop l33 = distance(p31, f30);
    let q34 = p31;
    param l35 = 41.1335mm;
    unknown t36 = -4deg;
    unknown t37 = 35deg;
    param l38 = 50.5935mm +- 20um;
    loop q23 + polar(l35, t36) = q20 + polar(l38, t37);
    let q39 = q23 + polar(l35, t36);
    param l40 = 35.6054mm +- 20um;
    param w41 = -1.7395845rad;
    let q42 = q23 + polar(l40, t36 + w41);
    const f43 = (-94.4442mm, -293.1535mm);
    param w44 = -0.9589812rad;
    param l45 = 58.9881mm;
    const l46 = 4.9203mm;
    unknown t47 = -94deg;
    unknown s48 = -59.8mm;
    loop q34 + polar(l45, t47) = f43 + polar(s48, t17 + w44) + polar(l46, t17 + w44 + 90deg);
    let q49 = q34 + polar(l45, t47);
}

impl Generated19 {
    pub fn position1(phi1) -> Position1 {
        q49,
        q42,
        s48,
        t47,
        t37,
        t36,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q49,
        velocity0: velocity(q49),
        acceleration0: acceleration(q49),
        jerk0: jerk(q49),
        q42,
        velocity1: velocity(q42),
        acceleration1: acceleration(q42),
        jerk1: jerk(q42),
        s48,
        velocity2: velocity(s48),
        acceleration2: acceleration(s48),
        jerk2: jerk(s48),
        t47,
        velocity3: velocity(t47),
        acceleration3: acceleration(t47),
        jerk3: jerk(t47)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q49,
        e0: sensitivity(q49, [f10.x, l14]),
        v0: d(q49, phi1),
        m0: d(q49, phi1, f10.x),
        w0: d(q49, f10.x, l14),
        q42,
        e1: sensitivity(q42, [f10.x, f7.x]),
        v1: d(q42, phi1),
        m1: d(q42, phi1, f10.x),
        w1: d(q42, f10.x, f7.x),
        s48,
        e2: sensitivity(s48, [l11, f24.x]),
        v2: d(s48, phi1),
        m2: d(s48, phi1, l11),
        w2: d(s48, l11, f24.x),
        t47,
        e3: sensitivity(t47, [f24.x, f10.x]),
        v3: d(t47, phi1),
        m3: d(t47, phi1, f24.x),
        w3: d(t47, f24.x, f10.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q9 + polar(l11, t12)) - (f10 + polar(l14, t13)),
        v0: velocity((q9 + polar(l11, t12)) - (f10 + polar(l14, t13))),
        a0: acceleration((q9 + polar(l11, t12)) - (f10 + polar(l14, t13))),
        r1: (q9 + polar(l16, t17)) - (q4 + polar(l19, t18)),
        v1: velocity((q9 + polar(l16, t17)) - (q4 + polar(l19, t18))),
        a1: acceleration((q9 + polar(l16, t17)) - (q4 + polar(l19, t18))),
        r2: (q15) - (f24 + polar(s26, t25)),
        v2: velocity((q15) - (f24 + polar(s26, t25))),
        a2: acceleration((q15) - (f24 + polar(s26, t25))),
        r3: (l32) - (norm(p31 - q29)),
        v3: velocity((l32) - (norm(p31 - q29))),
        a3: acceleration((l32) - (norm(p31 - q29))),
        r4: (l33) - (distance(p31, f30)),
        v4: velocity((l33) - (distance(p31, f30))),
        a4: acceleration((l33) - (distance(p31, f30))),
        r5: (q23 + polar(l35, t36)) - (q20 + polar(l38, t37)),
        v5: velocity((q23 + polar(l35, t36)) - (q20 + polar(l38, t37))),
        a5: acceleration((q23 + polar(l35, t36)) - (q20 + polar(l38, t37))),
        r6: (q34 + polar(l45, t47)) - (f43 + polar(s48, t17 + w44) + polar(l46, t17 + w44 + 90deg)),
        v6: velocity((q34 + polar(l45, t47)) - (f43 + polar(s48, t17 + w44) + polar(l46, t17 + w44 + 90deg))),
        a6: acceleration((q34 + polar(l45, t47)) - (f43 + polar(s48, t17 + w44) + polar(l46, t17 + w44 + 90deg)))
    }
}
}
    position1(0): q49, q42, s48, t47, t37, t36, margin;
    motion1(0): q49, velocity0, acceleration0, jerk0, q42, velocity1, acceleration1, jerk1, s48, velocity2, acceleration2, jerk2, t47, velocity3, acceleration3, jerk3;
    accuracy1(0): q49, e0, v0, m0, w0, q42, e1, v1, m1, w1, s48, e2, v2, m2, w2, t47, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5, r6, v6, a6;
}

corpus! {
    m20 Generated20 [l2, w4, f6.x, f6.y, l7, f9.x, f9.y, l10, l13, w14, w16, l17, l18, l22, w23, f25.x, f25.y, l26, l29, w30, f32.x, f32.y, w33, l34, l35, f39.x, f39.y, w40, l41, l46, w47, f49.x, f49.y, l51, l52]
    {
pub struct Generated20 {
    unit m;
    input phi1 = -0.8587020rad in -0.8589078rad..-0.8584962rad;
    param l2 = 27.5558mm;
    let q3 = polar(l2, phi1);
    param w4 = -0.8399405rad;
    let g5 = 2 * phi1 + w4;
    param f6 = (33.7219mm, 0.0000mm);
    param l7 = 24.2107mm;
    let q8 = f6 + polar(l7, g5);
    param f9 = (6.1683mm, -72.3345mm);
    param l10 = -10.1420mm +- 20um;
    unknown t11 = 88deg;
    unknown s12 = 51.8mm;
    loop q3 = f9 + rotate((s12, l10), t11);
    param l13 = 30.3339mm +- 20um;
    param w14 = -1.3586112rad;
    let q15 = f9 + polar(l13, t11 + w14);
    param w16 = 1.2989203rad;
    param l17 = 117.3445mm +- 20um;
    param l18 = -33.7759mm;
    unknown t19 = 33deg;
    unknown s20 = 113.0mm;
    loop q3 + rotate((s20, l18), phi1 + w16) = q15 + polar(l17, t19);
    let q21 = q15 + polar(l17, t19);
    param l22 = 25.0030mm;
    param w23 = -0.4535316rad;
    let q24 = q15 + polar(l22, t19 + w23);
    param f25 = (29.6205mm, -113.5883mm);
    param l26 = -2.7933mm;
    unknown t27 = 235deg;
    unknown s28 = -58.6mm;
    loop f25 + s28 * dir(t27) - polar(l26, t27 - 90deg) = q24;
    param l29 = 57.1515mm;
    param w30 = 1.4831024rad;
    let q31 = f25 + polar(l29, t27 + w30);
    param f32 = (-33.4938mm, -77.8224mm);
    param w33 = -0.9221378rad;
    param l34 = 82.1360mm +- 20um;
    param l35 = 19.5716mm;
    unknown t36 = -160deg;
    unknown s37 = 10.1mm;
    loop f32 + polar(s37, phi1 + w33) + polar(l35, phi1 + w33 + 90deg) = q24 + polar(l34, t36);
    let q38 = q24 + polar(l34, t36);
    param f39 = (32.4525mm, -117.3879mm);
    param w40 = -2.9377003rad;
    param l41 = 105.9044mm;
    const l42 = -2.3123mm;
    unknown t43 = 36deg;
    unknown s44 = -130.4mm;
    loop q31 + polar(l41, t43) = f39 + polar(s44, w40) + polar(l42, w40 + 90deg);
    let q45 = q31 + polar(l41, t43);
    param l46 = 41.2134mm;
    param w47 = 2.4020336rad;
    let q48 = q31 + polar(l46, t43 + w47);
    param f49 = (-46.9067mm, -175.8146mm);
    unknown p50 = (39.9mm, -202.1mm);
    param l51 = 57.2431mm;
    loop norm(p50 - q48) = l51;
    param l52 = 90.6615mm;
    loop norm(f49 - p50) = l52;
    let q53 = p50;
}

impl Generated20 {
    pub fn position1(phi1) -> Position1 {
        q53,
        q48,
        p50,
        s44,
        t43,
        s37,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q53,
        velocity0: velocity(q53),
        acceleration0: acceleration(q53),
        jerk0: jerk(q53),
        q48,
        velocity1: velocity(q48),
        acceleration1: acceleration(q48),
        jerk1: jerk(q48),
        p50,
        velocity2: velocity(p50),
        acceleration2: acceleration(p50),
        jerk2: jerk(p50),
        s44,
        velocity3: velocity(s44),
        acceleration3: acceleration(s44),
        jerk3: jerk(s44)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q53,
        e0: sensitivity(q53, [f39.y, w23]),
        v0: d(q53, phi1),
        m0: d(q53, phi1, f39.y),
        w0: d(q53, f39.y, w23),
        q48,
        e1: sensitivity(q48, [f39.y, l10]),
        v1: d(q48, phi1),
        m1: d(q48, phi1, f39.y),
        w1: d(q48, f39.y, l10),
        p50,
        e2: sensitivity(p50, [f6.y, f39.x]),
        v2: d(p50, phi1),
        m2: d(p50, phi1, f6.y),
        w2: d(p50, f6.y, f39.x),
        s44,
        e3: sensitivity(s44, [l13, l51]),
        v3: d(s44, phi1),
        m3: d(s44, phi1, l13),
        w3: d(s44, l13, l51)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q3) - (f9 + rotate((s12, l10), t11)),
        v0: velocity((q3) - (f9 + rotate((s12, l10), t11))),
        a0: acceleration((q3) - (f9 + rotate((s12, l10), t11))),
        r1: (q3 + rotate((s20, l18), phi1 + w16)) - (q15 + polar(l17, t19)),
        v1: velocity((q3 + rotate((s20, l18), phi1 + w16)) - (q15 + polar(l17, t19))),
        a1: acceleration((q3 + rotate((s20, l18), phi1 + w16)) - (q15 + polar(l17, t19))),
        r2: (f25 + s28 * dir(t27) - polar(l26, t27 - 90deg)) - (q24),
        v2: velocity((f25 + s28 * dir(t27) - polar(l26, t27 - 90deg)) - (q24)),
        a2: acceleration((f25 + s28 * dir(t27) - polar(l26, t27 - 90deg)) - (q24)),
        r3: (f32 + polar(s37, phi1 + w33) + polar(l35, phi1 + w33 + 90deg)) - (q24 + polar(l34, t36)),
        v3: velocity((f32 + polar(s37, phi1 + w33) + polar(l35, phi1 + w33 + 90deg)) - (q24 + polar(l34, t36))),
        a3: acceleration((f32 + polar(s37, phi1 + w33) + polar(l35, phi1 + w33 + 90deg)) - (q24 + polar(l34, t36))),
        r4: (q31 + polar(l41, t43)) - (f39 + polar(s44, w40) + polar(l42, w40 + 90deg)),
        v4: velocity((q31 + polar(l41, t43)) - (f39 + polar(s44, w40) + polar(l42, w40 + 90deg))),
        a4: acceleration((q31 + polar(l41, t43)) - (f39 + polar(s44, w40) + polar(l42, w40 + 90deg))),
        r5: (norm(p50 - q48)) - (l51),
        v5: velocity((norm(p50 - q48)) - (l51)),
        a5: acceleration((norm(p50 - q48)) - (l51)),
        r6: (norm(f49 - p50)) - (l52),
        v6: velocity((norm(f49 - p50)) - (l52)),
        a6: acceleration((norm(f49 - p50)) - (l52))
    }
}
}
    position1(0): q53, q48, p50, s44, t43, s37, margin;
    motion1(0): q53, velocity0, acceleration0, jerk0, q48, velocity1, acceleration1, jerk1, p50, velocity2, acceleration2, jerk2, s44, velocity3, acceleration3, jerk3;
    accuracy1(0): q53, e0, v0, m0, w0, q48, e1, v1, m1, w1, p50, e2, v2, m2, w2, s44, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5, r6, v6, a6;
}

corpus! {
    m22 Generated22 [f2.x, f2.y, l3, w8, l9, w11, f13.x, f13.y, l14, w17, l19, l21, l26, w27, f29.x, f29.y, l31, l32, f34.x, f34.y, l35, l38, w39]
    {
pub struct Generated22 {
    unit mm;
    input phi1 = 1.0698868rad in 1.0696811rad..1.0700926rad;
    param f2 = (22.5169mm, 34.8749mm);
    param l3 = 22.2965mm;
    let q4 = f2 + polar(l3, phi1);
    const f5 = (7.9495mm, 4.7179mm);
    const l6 = 42.3563mm;
    unknown t7 = 124deg;
    param w8 = 4.7117390rad;
    param l9 = -85.0324mm;
    loop l9 = dot(dir(w8), q4 + polar(l6, t7) - f5);
    let q10 = q4 + polar(l6, t7);
    param w11 = 1.2441492rad;
    unknown t12 = 133deg;
    loop (t7) / 2 + w11 = t12;
    param f13 = (0.0000mm, 0.0000mm);
    param l14 = 39.6857mm;
    unknown p15 = (-27.1mm, 29.0mm);
    loop p15 = f13 + polar(l14, t12);
    let q16 = p15;
    param w17 = -0.3713197rad;
    unknown s18 = 85.5mm;
    param l19 = 122.5237mm;
    loop distance(q10, q4 + polar(s18, w17)) = l19;
    let q20 = q4 + polar(s18, w17);
    param l21 = 93.8251mm;
    unknown t22 = -15deg;
    unknown t23 = -44deg;
    const l24 = 57.7169mm;
    loop q16 + polar(l21, t22) = q4 + polar(l24, t22 + t23);
    let q25 = q16 + polar(l21, t22);
    param l26 = 43.2382mm;
    param w27 = -1.5319695rad;
    let q28 = q16 + polar(l26, t22 + w27);
    param f29 = (-112.9895mm, -85.2782mm);
    unknown p30 = (-52.1mm, 9.3mm);
    param l31 = 27.4998mm;
    loop l31 = distance(p30, q28);
    param l32 = 112.4963mm;
    loop norm(p30 - f29) = l32;
    let q33 = p30;
    param f34 = (21.7079mm, -1.4768mm);
    param l35 = -11.9839mm;
    unknown t36 = 90deg;
    unknown s37 = 55.8mm;
    loop f34 + s37 * dir(t36) - polar(l35, t36 - 90deg) = q4;
    param l38 = 51.6512mm;
    param w39 = 1.4877984rad;
    let q40 = f34 + polar(l38, t36 + w39);
}

impl Generated22 {
    pub fn position1(phi1) -> Position1 {
        q40,
        q33,
        s37,
        t36,
        p30,
        t23,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q40,
        velocity0: velocity(q40),
        acceleration0: acceleration(q40),
        jerk0: jerk(q40),
        q33,
        velocity1: velocity(q33),
        acceleration1: acceleration(q33),
        jerk1: jerk(q33),
        s37,
        velocity2: velocity(s37),
        acceleration2: acceleration(s37),
        jerk2: jerk(s37),
        t36,
        velocity3: velocity(t36),
        acceleration3: acceleration(t36),
        jerk3: jerk(t36)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q40,
        e0: sensitivity(q40, [w27, f2.x]),
        v0: d(q40, phi1),
        m0: d(q40, phi1, w27),
        w0: d(q40, w27, f2.x),
        q33,
        e1: sensitivity(q33, [w8, f2.x]),
        v1: d(q33, phi1),
        m1: d(q33, phi1, w8),
        w1: d(q33, w8, f2.x),
        s37,
        e2: sensitivity(s37, [l32, l21]),
        v2: d(s37, phi1),
        m2: d(s37, phi1, l32),
        w2: d(s37, l32, l21),
        t36,
        e3: sensitivity(t36, [w39, f29.x]),
        v3: d(t36, phi1),
        m3: d(t36, phi1, w39),
        w3: d(t36, w39, f29.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (l9) - (dot(dir(w8), q4 + polar(l6, t7) - f5)),
        v0: velocity((l9) - (dot(dir(w8), q4 + polar(l6, t7) - f5))),
        a0: acceleration((l9) - (dot(dir(w8), q4 + polar(l6, t7) - f5))),
        r1: (distance(q10, q4 + polar(s18, w17))) - (l19),
        v1: velocity((distance(q10, q4 + polar(s18, w17))) - (l19)),
        a1: acceleration((distance(q10, q4 + polar(s18, w17))) - (l19)),
        r2: (q16 + polar(l21, t22)) - (q4 + polar(l24, t22 + t23)),
        v2: velocity((q16 + polar(l21, t22)) - (q4 + polar(l24, t22 + t23))),
        a2: acceleration((q16 + polar(l21, t22)) - (q4 + polar(l24, t22 + t23))),
        r3: (l31) - (distance(p30, q28)),
        v3: velocity((l31) - (distance(p30, q28))),
        a3: acceleration((l31) - (distance(p30, q28))),
        r4: (norm(p30 - f29)) - (l32),
        v4: velocity((norm(p30 - f29)) - (l32)),
        a4: acceleration((norm(p30 - f29)) - (l32)),
        r5: (f34 + s37 * dir(t36) - polar(l35, t36 - 90deg)) - (q4),
        v5: velocity((f34 + s37 * dir(t36) - polar(l35, t36 - 90deg)) - (q4)),
        a5: acceleration((f34 + s37 * dir(t36) - polar(l35, t36 - 90deg)) - (q4))
    }
}
}
    position1(0): q40, q33, s37, t36, p30, t23, margin;
    motion1(0): q40, velocity0, acceleration0, jerk0, q33, velocity1, acceleration1, jerk1, s37, velocity2, acceleration2, jerk2, t36, velocity3, acceleration3, jerk3;
    accuracy1(0): q40, e0, v0, m0, w0, q33, e1, v1, m1, w1, s37, e2, v2, m2, w2, t36, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m23 Generated23 [f2.x, f2.y, l3, w5, f7.x, f7.y, f11.x, f11.y, l12, l13, l17, w18, f20.x, f20.y, w21, w23, l24, l25, l29, w30, f32.x, f32.y, l35, w36, f38.x, f38.y, l39, l42, l44, w45]
    {
pub struct Generated23 {
    unit mm;
    input phi1 = 2.6267205rad in 2.6261032rad..2.6273378rad;
    param f2 = (32.7635mm, 7.8809mm);
    param l3 = 20.5009mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 1.2082760rad;
    unknown t6 = 521deg;
    loop 3 * (phi1) + w5 = t6;
    param f7 = (0.0000mm, 0.0000mm);
    const l8 = 35.5691mm;
    unknown p9 = (-33.6mm, 11.7mm);
    loop f7 + polar(l8, t6) = p9;
    let q10 = p9;
    param f11 = (-101.3418mm, -60.9863mm);
    param l12 = 99.1960mm +- 20um;
    param l13 = 17.2752mm;
    unknown t14 = -121deg;
    unknown s15 = 12.7mm;
    loop f11 + rotate((s15, l13), (-90deg)) = q10 + polar(l12, t14);
    let q16 = q10 + polar(l12, t14);
    param l17 = 58.1875mm;
    param w18 = 0.5336823rad;
    let q19 = q10 + polar(l17, t14 + w18);
    param f20 = (-69.3773mm, -103.5713mm);
    param w21 = -0.7705461rad;
    const f22 = (-122.6240mm, -5.0324mm);
    param w23 = -1.6558017rad;
    param l24 = 118.2982mm +- 20um;
    param l25 = -7.9366mm;
    unknown t26 = 139deg;
    unknown s27 = -94.4mm;
    loop f22 + polar(s27, w23) + polar(l25, w23 + 90deg) = q10 + polar(l24, t26);
    let q28 = q10 + polar(l24, t26);
    param l29 = 38.6697mm;
    param w30 = -0.6450205rad;
    let q31 = q10 + polar(l29, t26 + w30);
    param f32 = (-86.5022mm, 1.3551mm);
    unknown t33 = 112deg;
    unknown s34 = 95.4mm;
    loop q28 = f32 + polar(s34, t33);
    param l35 = 32.0758mm;
    param w36 = -0.1774658rad;
    let q37 = f32 + polar(l35, t33 + w36);
    param f38 = (50.2944mm, 2.7616mm);
    param l39 = 88.2574mm +- 20um;
    unknown t40 = 47deg;
    unknown t41 = 106deg;
    param l42 = -116.0423mm;
    loop f38 + polar((-l42), t41) = q31 + polar(l39, t40);
    let q43 = q31 + polar(l39, t40);
    param l44 = 43.0739mm;
    param w45 = -1.6793745rad;
    let q46 = q31 + polar(l44, t40 + w45);
}

impl Generated23 {
    pub fn position1(phi1) -> Position1 {
        q46,
        q43,
        t41,
        t40,
        s34,
        t33,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q46,
        velocity0: velocity(q46),
        acceleration0: acceleration(q46),
        jerk0: jerk(q46),
        q43,
        velocity1: velocity(q43),
        acceleration1: acceleration(q43),
        jerk1: jerk(q43),
        t41,
        velocity2: velocity(t41),
        acceleration2: acceleration(t41),
        jerk2: jerk(t41),
        t40,
        velocity3: velocity(t40),
        acceleration3: acceleration(t40),
        jerk3: jerk(t40)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q46,
        e0: sensitivity(q46, [l25, l29]),
        v0: d(q46, phi1),
        m0: d(q46, phi1, l25),
        w0: d(q46, l25, l29),
        q43,
        e1: sensitivity(q43, [w45, l25]),
        v1: d(q43, phi1),
        m1: d(q43, phi1, w45),
        w1: d(q43, w45, l25),
        t41,
        e2: sensitivity(t41, [l24, f7.y]),
        v2: d(t41, phi1),
        m2: d(t41, phi1, l24),
        w2: d(t41, l24, f7.y),
        t40,
        e3: sensitivity(t40, [w21, w5]),
        v3: d(t40, phi1),
        m3: d(t40, phi1, w21),
        w3: d(t40, w21, w5)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f11 + rotate((s15, l13), (-90deg))) - (q10 + polar(l12, t14)),
        v0: velocity((f11 + rotate((s15, l13), (-90deg))) - (q10 + polar(l12, t14))),
        a0: acceleration((f11 + rotate((s15, l13), (-90deg))) - (q10 + polar(l12, t14))),
        r1: (f22 + polar(s27, w23) + polar(l25, w23 + 90deg)) - (q10 + polar(l24, t26)),
        v1: velocity((f22 + polar(s27, w23) + polar(l25, w23 + 90deg)) - (q10 + polar(l24, t26))),
        a1: acceleration((f22 + polar(s27, w23) + polar(l25, w23 + 90deg)) - (q10 + polar(l24, t26))),
        r2: (q28) - (f32 + polar(s34, t33)),
        v2: velocity((q28) - (f32 + polar(s34, t33))),
        a2: acceleration((q28) - (f32 + polar(s34, t33))),
        r3: (f38 + polar((-l42), t41)) - (q31 + polar(l39, t40)),
        v3: velocity((f38 + polar((-l42), t41)) - (q31 + polar(l39, t40))),
        a3: acceleration((f38 + polar((-l42), t41)) - (q31 + polar(l39, t40)))
    }
}
}
    position1(0): q46, q43, t41, t40, s34, t33, margin;
    motion1(0): q46, velocity0, acceleration0, jerk0, q43, velocity1, acceleration1, jerk1, t41, velocity2, acceleration2, jerk2, t40, velocity3, acceleration3, jerk3;
    accuracy1(0): q46, e0, v0, m0, w0, q43, e1, v1, m1, w1, t41, e2, v2, m2, w2, t40, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3;
}

corpus! {
    m25 Generated25 [f4.x, f4.y, f5.x, f5.y, w6, l11, l14, w15, f17.x, f17.y, w18, l20]
    {
pub struct Generated25 {
    unit mm;
    input phi1 = -0.2460914rad in -0.2516470rad..-0.2405359rad;
    const l2 = 49.5149mm;
    let q3 = polar(l2, phi1);
    param f4 = (53.1326mm, -79.0895mm);
    param f5 = (118.7137mm, -32.6682mm);
    param w6 = 0.2565354rad;
    unknown s7 = 70.7mm;
    unknown s8 = 21.3mm;
    loop q3 + polar(s7, phi1 + w6) = f5 + polar(s8, 90deg);
    let q9 = q3 + polar(s7, phi1 + w6);
    const f10 = (84.8136mm, 43.8771mm);
    param l11 = 6.2318mm;
    unknown t12 = -64deg;
    unknown s13 = 64.5mm;
    loop q9 = f10 + rotate((s13, l11), t12);
    param l14 = 51.5145mm;
    param w15 = -1.4367363rad;
    let q16 = f10 + polar(l14, t12 + w15);
    param f17 = (114.3150mm, 48.5573mm);
    param w18 = -0.4113248rad;
    const l19 = 44.8126mm;
    param l20 = -37.1014mm;
    unknown t21 = 6deg;
    unknown s22 = -14.2mm;
    loop q16 + polar(l19, t21) = f17 + rotate((s22, l20), w18);
    let q23 = q16 + polar(l19, t21);
}

impl Generated25 {
    pub fn position1(phi1) -> Position1 {
        q23,
        q16,
        s22,
        t21,
        s13,
        t12,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q23,
        velocity0: velocity(q23),
        acceleration0: acceleration(q23),
        jerk0: jerk(q23),
        q16,
        velocity1: velocity(q16),
        acceleration1: acceleration(q16),
        jerk1: jerk(q16),
        s22,
        velocity2: velocity(s22),
        acceleration2: acceleration(s22),
        jerk2: jerk(s22),
        t21,
        velocity3: velocity(t21),
        acceleration3: acceleration(t21),
        jerk3: jerk(t21)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q23,
        e0: sensitivity(q23, [w6, w15]),
        v0: d(q23, phi1),
        m0: d(q23, phi1, w6),
        w0: d(q23, w6, w15),
        q16,
        e1: sensitivity(q16, [w6, f17.y]),
        v1: d(q16, phi1),
        m1: d(q16, phi1, w6),
        w1: d(q16, w6, f17.y),
        s22,
        e2: sensitivity(s22, [f5.x, f4.x]),
        v2: d(s22, phi1),
        m2: d(s22, phi1, f5.x),
        w2: d(s22, f5.x, f4.x),
        t21,
        e3: sensitivity(t21, [l11, w6]),
        v3: d(t21, phi1),
        m3: d(t21, phi1, l11),
        w3: d(t21, l11, w6)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q3 + polar(s7, phi1 + w6)) - (f5 + polar(s8, 90deg)),
        v0: velocity((q3 + polar(s7, phi1 + w6)) - (f5 + polar(s8, 90deg))),
        a0: acceleration((q3 + polar(s7, phi1 + w6)) - (f5 + polar(s8, 90deg))),
        r1: (q9) - (f10 + rotate((s13, l11), t12)),
        v1: velocity((q9) - (f10 + rotate((s13, l11), t12))),
        a1: acceleration((q9) - (f10 + rotate((s13, l11), t12))),
        r2: (q16 + polar(l19, t21)) - (f17 + rotate((s22, l20), w18)),
        v2: velocity((q16 + polar(l19, t21)) - (f17 + rotate((s22, l20), w18))),
        a2: acceleration((q16 + polar(l19, t21)) - (f17 + rotate((s22, l20), w18)))
    }
}
}
    position1(0): q23, q16, s22, t21, s13, t12, margin;
    motion1(0): q23, velocity0, acceleration0, jerk0, q16, velocity1, acceleration1, jerk1, s22, velocity2, acceleration2, jerk2, t21, velocity3, acceleration3, jerk3;
    accuracy1(0): q23, e0, v0, m0, w0, q16, e1, v1, m1, w1, s22, e2, v2, m2, w2, t21, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m26 Generated26 [w5, f7.x, f7.y, l8, l11, w13, f15.x, f15.y, f18.x, f18.y, l21, f23.x, f23.y, w24, l25, l26, l30, l33, l35, w36, f38.x, f38.y, w39, l41, w44, l46, l49, l51, l54, l56, w57]
    {
pub struct Generated26 {
    unit m;
    input phi1 = -1.0803588rad in -1.0804617rad..-1.0802559rad;
    input phi10 = 2.1293017rad in 2.1291988rad..2.1294046rad;
    const f2 = (21.1621mm, -3.7190mm);
    const l3 = 28.4918mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = -0.4759871rad;
    let g6 = 2 * phi1 + w5;
    param f7 = (70.4550mm, -3.7190mm);
    param l8 = 35.0541mm;
    let q9 = f7 + polar(l8, g6);
    param l11 = 35.2634mm +- 20um;
    let q12 = polar(l11, phi10);
    param w13 = -0.4071972rad;
    let g14 = w13 - phi10;
    param f15 = (45.6071mm, 0.0000mm);
    const l16 = 16.9500mm;
    let q17 = f15 + polar(l16, g14);
    param f18 = (-57.0913mm, -1.9340mm);
    unknown p19 = (-41.0mm, -25.1mm);
    const l20 = 74.3408mm;
    loop norm(p19 - q17) = l20;
    param l21 = 28.2154mm +- 20um;
    loop distance(p19, f18) = l21;
    let q22 = p19;
    param f23 = (-34.4991mm, -22.8468mm);
    param w24 = 1.9961879rad;
    param l25 = 89.5764mm;
    param l26 = -32.6919mm;
    unknown t27 = -87deg;
    unknown s28 = -98.5mm;
    loop f23 + polar(s28, w24) + polar(l26, w24 + 90deg) = q17 + polar(l25, t27);
    let q29 = q17 + polar(l25, t27);
    param l30 = 105.2979mm;
    unknown t31 = -63deg;
    unknown t32 = -100deg;
    param l33 = -35.8901mm;
    loop q12 + polar(l30, t31) = q4 + polar((-l33), t32);
    let q34 = q12 + polar(l30, t31);
    param l35 = 47.3166mm;
    param w36 = 0.1640460rad;
    let q37 = q12 + polar(l35, t31 + w36);
    param f38 = (79.9182mm, -101.2807mm);
    param w39 = -0.2460139rad;
    unknown s40 = 79.9mm;
    param l41 = 31.4399mm;
    loop l41 = distance(f38, q34 + polar(s40, w39));
    let q42 = q34 + polar(s40, w39);
    const f43 = (182.0900mm, -133.4863mm);
    param w44 = -0.3651326rad;
    const f45 = (106.5279mm, 62.7419mm);
    param l46 = 83.5955mm;
    unknown t47 = 147deg;
    unknown t48 = -169deg;
    param l49 = 147.8950mm;
    loop q17 + polar(l46, t47) = f45 + polar(l49, t48);
    let q50 = q17 + polar(l46, t47);
    param l51 = 79.9095mm;
    unknown t52 = -32deg;
    unknown t53 = 94deg;
    param l54 = 92.2953mm;
    loop q29 - q50 = polar(l51, t52) - l54 * dir(t53);
    let q55 = q50 + polar(l51, t52);
    param l56 = 31.8823mm;
    param w57 = -1.4813810rad;
    let q58 = q50 + polar(l56, t52 + w57);
}

impl Generated26 {
    pub fn position1(phi1) -> Position1 {
        q9,
        q4
    }
    pub fn motion1(phi1) -> Motion1 {
        q9,
        velocity0: velocity(q9),
        acceleration0: acceleration(q9),
        jerk0: jerk(q9),
        q4,
        velocity1: velocity(q4),
        acceleration1: acceleration(q4),
        jerk1: jerk(q4)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q9,
        e0: sensitivity(q9, [l26, w36]),
        v0: d(q9, phi1),
        m0: d(q9, phi1, l26),
        w0: d(q9, l26, w36),
        q4,
        e1: sensitivity(q4, [w13, l46]),
        v1: d(q4, phi1),
        m1: d(q4, phi1, w13),
        w1: d(q4, w13, l46)
    }
    pub fn position2(phi10) -> Position2 {
        q58,
        q55,
        t53,
        t52,
        t48,
        t47,
        margin: margin()
    }
    pub fn motion2(phi10) -> Motion2 {
        q58,
        velocity0: velocity(q58),
        acceleration0: acceleration(q58),
        jerk0: jerk(q58),
        q55,
        velocity1: velocity(q55),
        acceleration1: acceleration(q55),
        jerk1: jerk(q55),
        t53,
        velocity2: velocity(t53),
        acceleration2: acceleration(t53),
        jerk2: jerk(t53),
        t52,
        velocity3: velocity(t52),
        acceleration3: acceleration(t52),
        jerk3: jerk(t52)
    }
    pub fn accuracy2(phi10) -> Accuracy2 {
        q58,
        e0: sensitivity(q58, [l11, l30]),
        v0: d(q58, phi10),
        m0: d(q58, phi10, l11),
        w0: d(q58, l11, l30),
        q55,
        e1: sensitivity(q55, [l46, f38.x]),
        v1: d(q55, phi10),
        m1: d(q55, phi10, l46),
        w1: d(q55, l46, f38.x),
        t53,
        e2: sensitivity(t53, [w36, w44]),
        v2: d(t53, phi10),
        m2: d(t53, phi10, w36),
        w2: d(t53, w36, w44),
        t52,
        e3: sensitivity(t52, [f38.y, f38.x]),
        v3: d(t52, phi10),
        m3: d(t52, phi10, f38.y),
        w3: d(t52, f38.y, f38.x)
    }
    pub fn closure2(phi10) -> Closure2 {
        r0: (norm(p19 - q17)) - (l20),
        v0: velocity((norm(p19 - q17)) - (l20)),
        a0: acceleration((norm(p19 - q17)) - (l20)),
        r1: (distance(p19, f18)) - (l21),
        v1: velocity((distance(p19, f18)) - (l21)),
        a1: acceleration((distance(p19, f18)) - (l21)),
        r2: (f23 + polar(s28, w24) + polar(l26, w24 + 90deg)) - (q17 + polar(l25, t27)),
        v2: velocity((f23 + polar(s28, w24) + polar(l26, w24 + 90deg)) - (q17 + polar(l25, t27))),
        a2: acceleration((f23 + polar(s28, w24) + polar(l26, w24 + 90deg)) - (q17 + polar(l25, t27))),
        r3: (q17 + polar(l46, t47)) - (f45 + polar(l49, t48)),
        v3: velocity((q17 + polar(l46, t47)) - (f45 + polar(l49, t48))),
        a3: acceleration((q17 + polar(l46, t47)) - (f45 + polar(l49, t48))),
        r4: (q29 - q50) - (polar(l51, t52) - l54 * dir(t53)),
        v4: velocity((q29 - q50) - (polar(l51, t52) - l54 * dir(t53))),
        a4: acceleration((q29 - q50) - (polar(l51, t52) - l54 * dir(t53)))
    }
    pub fn position3(phi1, phi10) -> Position3 {
        q42,
        q37,
        s40,
        t32,
        t31,
        margin: margin()
    }
    pub fn motion3(phi1, phi10) -> Motion3 {
        q42,
        velocity0: velocity(q42),
        acceleration0: acceleration(q42),
        q37,
        velocity1: velocity(q37),
        acceleration1: acceleration(q37),
        s40,
        velocity2: velocity(s40),
        acceleration2: acceleration(s40),
        t32,
        velocity3: velocity(t32),
        acceleration3: acceleration(t32)
    }
    pub fn accuracy3(phi1, phi10) -> Accuracy3 {
        q42,
        e0: sensitivity(q42, [f7.y, l49]),
        v0: d(q42, phi10),
        m0: d(q42, phi10, f7.y),
        w0: d(q42, f7.y, l49),
        q37,
        e1: sensitivity(q37, [f18.x, l11]),
        v1: d(q37, phi10),
        m1: d(q37, phi10, f18.x),
        w1: d(q37, f18.x, l11),
        s40,
        e2: sensitivity(s40, [f15.x, f23.x]),
        v2: d(s40, phi10),
        m2: d(s40, phi10, f15.x),
        w2: d(s40, f15.x, f23.x),
        t32,
        e3: sensitivity(t32, [f38.y, l21]),
        v3: d(t32, phi10),
        m3: d(t32, phi10, f38.y),
        w3: d(t32, f38.y, l21)
    }
    pub fn closure3(phi1, phi10) -> Closure3 {
        r0: (q12 + polar(l30, t31)) - (q4 + polar((-l33), t32)),
        v0: velocity((q12 + polar(l30, t31)) - (q4 + polar((-l33), t32))),
        a0: acceleration((q12 + polar(l30, t31)) - (q4 + polar((-l33), t32))),
        r1: (l41) - (distance(f38, q34 + polar(s40, w39))),
        v1: velocity((l41) - (distance(f38, q34 + polar(s40, w39)))),
        a1: acceleration((l41) - (distance(f38, q34 + polar(s40, w39))))
    }
}
}
    position1(0): q9, q4;
    motion1(0): q9, velocity0, acceleration0, jerk0, q4, velocity1, acceleration1, jerk1;
    accuracy1(0): q9, e0, v0, m0, w0, q4, e1, v1, m1, w1;
    position2(1): q58, q55, t53, t52, t48, t47, margin;
    motion2(1): q58, velocity0, acceleration0, jerk0, q55, velocity1, acceleration1, jerk1, t53, velocity2, acceleration2, jerk2, t52, velocity3, acceleration3, jerk3;
    accuracy2(1): q58, e0, v0, m0, w0, q55, e1, v1, m1, w1, t53, e2, v2, m2, w2, t52, e3, v3, m3, w3;
    closure2(1): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4;
    position3(0, 1): q42, q37, s40, t32, t31, margin;
    motion3(0, 1): q42, velocity0, acceleration0, q37, velocity1, acceleration1, s40, velocity2, acceleration2, t32, velocity3, acceleration3;
    accuracy3(0, 1): q42, e0, v0, m0, w0, q37, e1, v1, m1, w1, s40, e2, v2, m2, w2, t32, e3, v3, m3, w3;
    closure3(0, 1): r0, v0, a0, r1, v1, a1;
}

corpus! {
    m28 Generated28 [f2.x, f2.y, l3, l6, l7, w11, f15.x, f15.y, l18, w19, f21.x, f21.y, l22, l23, l27, w28]
    {
pub struct Generated28 {
    unit mm;
    input phi1 = -0.2635447rad in -0.2653966rad..-0.2616929rad;
    param f2 = (5.1129mm, 16.7112mm);
    param l3 = 42.0713mm;
    let q4 = f2 + polar(l3, phi1);
    const f5 = (-8.1582mm, -2.0057mm);
    param l6 = 84.0952mm;
    param l7 = -15.5955mm;
    unknown t8 = 5deg;
    unknown s9 = -137.6mm;
    loop q4 + polar(l6, t8) = f5 + polar(s9, 180deg) + polar(l7, 180deg + 90deg);
    let q10 = q4 + polar(l6, t8);
    param w11 = -1.4958697rad;
    unknown s12 = -8.0mm;
    unknown s13 = -85.1mm;
    loop q10 + polar(s13, 0deg) = q4 + polar(s12, t8 + w11);
    let q14 = q4 + polar(s12, t8 + w11);
    param f15 = (69.5096mm, 87.6175mm);
    unknown t16 = -106deg;
    unknown s17 = 85.2mm;
    loop f15 + polar(s17, t16) = q4;
    param l18 = 53.6645mm;
    param w19 = 2.2973760rad;
    let q20 = f15 + polar(l18, t16 + w19);
    param f21 = (90.5870mm, 56.7470mm);
    param l22 = 90.1940mm;
    param l23 = 25.4570mm;
    unknown t24 = -162deg;
    unknown s25 = -58.2mm;
    loop f21 + polar(s25, 0deg) + polar(l23, 0deg + 90deg) = q20 + polar(l22, t24);
    let q26 = q20 + polar(l22, t24);
    param l27 = 31.5656mm;
    param w28 = -0.7695319rad;
    let q29 = q20 + polar(l27, t24 + w28);
}

impl Generated28 {
    pub fn position1(phi1) -> Position1 {
        q29,
        q26,
        s25,
        t24,
        s17,
        t16,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q29,
        velocity0: velocity(q29),
        acceleration0: acceleration(q29),
        jerk0: jerk(q29),
        q26,
        velocity1: velocity(q26),
        acceleration1: acceleration(q26),
        jerk1: jerk(q26),
        s25,
        velocity2: velocity(s25),
        acceleration2: acceleration(s25),
        jerk2: jerk(s25),
        t24,
        velocity3: velocity(t24),
        acceleration3: acceleration(t24),
        jerk3: jerk(t24)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q29,
        e0: sensitivity(q29, [f2.y, l22]),
        v0: d(q29, phi1),
        m0: d(q29, phi1, f2.y),
        w0: d(q29, f2.y, l22),
        q26,
        e1: sensitivity(q26, [f2.x, f21.y]),
        v1: d(q26, phi1),
        m1: d(q26, phi1, f2.x),
        w1: d(q26, f2.x, f21.y),
        s25,
        e2: sensitivity(s25, [w11, f15.x]),
        v2: d(s25, phi1),
        m2: d(s25, phi1, w11),
        w2: d(s25, w11, f15.x),
        t24,
        e3: sensitivity(t24, [f2.x, f15.x]),
        v3: d(t24, phi1),
        m3: d(t24, phi1, f2.x),
        w3: d(t24, f2.x, f15.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q4 + polar(l6, t8)) - (f5 + polar(s9, 180deg) + polar(l7, 180deg + 90deg)),
        v0: velocity((q4 + polar(l6, t8)) - (f5 + polar(s9, 180deg) + polar(l7, 180deg + 90deg))),
        a0: acceleration((q4 + polar(l6, t8)) - (f5 + polar(s9, 180deg) + polar(l7, 180deg + 90deg))),
        r1: (q10 + polar(s13, 0deg)) - (q4 + polar(s12, t8 + w11)),
        v1: velocity((q10 + polar(s13, 0deg)) - (q4 + polar(s12, t8 + w11))),
        a1: acceleration((q10 + polar(s13, 0deg)) - (q4 + polar(s12, t8 + w11))),
        r2: (f15 + polar(s17, t16)) - (q4),
        v2: velocity((f15 + polar(s17, t16)) - (q4)),
        a2: acceleration((f15 + polar(s17, t16)) - (q4)),
        r3: (f21 + polar(s25, 0deg) + polar(l23, 0deg + 90deg)) - (q20 + polar(l22, t24)),
        v3: velocity((f21 + polar(s25, 0deg) + polar(l23, 0deg + 90deg)) - (q20 + polar(l22, t24))),
        a3: acceleration((f21 + polar(s25, 0deg) + polar(l23, 0deg + 90deg)) - (q20 + polar(l22, t24)))
    }
}
}
    position1(0): q29, q26, s25, t24, s17, t16, margin;
    motion1(0): q29, velocity0, acceleration0, jerk0, q26, velocity1, acceleration1, jerk1, s25, velocity2, acceleration2, jerk2, t24, velocity3, acceleration3, jerk3;
    accuracy1(0): q29, e0, v0, m0, w0, q26, e1, v1, m1, w1, s25, e2, v2, m2, w2, t24, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3;
}

corpus! {
    m29 Generated29 [l2, w4, f6.x, f6.y, l7, l11, l14, l17, w18, w20, f22.x, f22.y]
    {
pub struct Generated29 {
    unit m;
    input phi1 = -1.0855948rad in -1.0939281rad..-1.0772615rad;
    input phi9 = 0.2076942rad in 0.1993608rad..0.2160275rad;
    param l2 = 46.4522mm;
    let q3 = polar(l2, phi1);
    param w4 = 0.8288769rad;
    let g5 = w4 - phi1 / 2;
    param f6 = (55.4133mm, 0.0000mm);
    param l7 = 33.8974mm +- 20um;
    let q8 = f6 + polar(l7, g5);
    const f10 = (6.4307mm, 39.9611mm);
    param l11 = 32.4143mm;
    let q12 = f10 + polar(l11, phi9);
    const f13 = (65.9602mm, 96.1697mm);
    param l14 = 7.9488mm;
    unknown t15 = -127deg;
    unknown s16 = 56.2mm;
    loop q12 = f13 + s16 * dir(t15) - polar(l14, t15 - 90deg);
    param l17 = 43.1891mm +- 20um;
    param w18 = 2.1255609rad;
    let q19 = f13 + polar(l17, t15 + w18);
    param w20 = -1.0806746rad;
    unknown t21 = 0deg;
    loop t21 = w20 - (phi1);
    param f22 = (0.0000mm, 0.0000mm);
    const l23 = 22.3671mm;
    unknown p24 = (22.4mm, 0.1mm);
    loop f22 + polar(l23, t21) = p24;
    let q25 = p24;
}

impl Generated29 {
    pub fn position1(phi1) -> Position1 {
        q25,
        q8,
        p24,
        t21,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q25,
        velocity0: velocity(q25),
        acceleration0: acceleration(q25),
        jerk0: jerk(q25),
        q8,
        velocity1: velocity(q8),
        acceleration1: acceleration(q8),
        jerk1: jerk(q8),
        p24,
        velocity2: velocity(p24),
        acceleration2: acceleration(p24),
        jerk2: jerk(p24),
        t21,
        velocity3: velocity(t21),
        acceleration3: acceleration(t21),
        jerk3: jerk(t21)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q25,
        e0: sensitivity(q25, [w18, l14]),
        v0: d(q25, phi1),
        m0: d(q25, phi1, w18),
        w0: d(q25, w18, l14),
        q8,
        e1: sensitivity(q8, [f6.x, w4]),
        v1: d(q8, phi1),
        m1: d(q8, phi1, f6.x),
        w1: d(q8, f6.x, w4),
        p24,
        e2: sensitivity(p24, [f22.x, l7]),
        v2: d(p24, phi1),
        m2: d(p24, phi1, f22.x),
        w2: d(p24, f22.x, l7),
        t21,
        e3: sensitivity(t21, [l14, w20]),
        v3: d(t21, phi1),
        m3: d(t21, phi1, l14),
        w3: d(t21, l14, w20)
    }
    pub fn position2(phi9) -> Position2 {
        q19,
        q12,
        s16,
        t15,
        margin: margin()
    }
    pub fn motion2(phi9) -> Motion2 {
        q19,
        velocity0: velocity(q19),
        acceleration0: acceleration(q19),
        jerk0: jerk(q19),
        q12,
        velocity1: velocity(q12),
        acceleration1: acceleration(q12),
        jerk1: jerk(q12),
        s16,
        velocity2: velocity(s16),
        acceleration2: acceleration(s16),
        jerk2: jerk(s16),
        t15,
        velocity3: velocity(t15),
        acceleration3: acceleration(t15),
        jerk3: jerk(t15)
    }
    pub fn accuracy2(phi9) -> Accuracy2 {
        q19,
        e0: sensitivity(q19, [l14, w18]),
        v0: d(q19, phi9),
        m0: d(q19, phi9, l14),
        w0: d(q19, l14, w18),
        q12,
        e1: sensitivity(q12, [l2, l7]),
        v1: d(q12, phi9),
        m1: d(q12, phi9, l2),
        w1: d(q12, l2, l7),
        s16,
        e2: sensitivity(s16, [w20, l11]),
        v2: d(s16, phi9),
        m2: d(s16, phi9, w20),
        w2: d(s16, w20, l11),
        t15,
        e3: sensitivity(t15, [w4, l14]),
        v3: d(t15, phi9),
        m3: d(t15, phi9, w4),
        w3: d(t15, w4, l14)
    }
    pub fn closure2(phi9) -> Closure2 {
        r0: (q12) - (f13 + s16 * dir(t15) - polar(l14, t15 - 90deg)),
        v0: velocity((q12) - (f13 + s16 * dir(t15) - polar(l14, t15 - 90deg))),
        a0: acceleration((q12) - (f13 + s16 * dir(t15) - polar(l14, t15 - 90deg)))
    }
}
}
    position1(0): q25, q8, p24, t21, margin;
    motion1(0): q25, velocity0, acceleration0, jerk0, q8, velocity1, acceleration1, jerk1, p24, velocity2, acceleration2, jerk2, t21, velocity3, acceleration3, jerk3;
    accuracy1(0): q25, e0, v0, m0, w0, q8, e1, v1, m1, w1, p24, e2, v2, m2, w2, t21, e3, v3, m3, w3;
    position2(1): q19, q12, s16, t15, margin;
    motion2(1): q19, velocity0, acceleration0, jerk0, q12, velocity1, acceleration1, jerk1, s16, velocity2, acceleration2, jerk2, t15, velocity3, acceleration3, jerk3;
    accuracy2(1): q19, e0, v0, m0, w0, q12, e1, v1, m1, w1, s16, e2, v2, m2, w2, t15, e3, v3, m3, w3;
    closure2(1): r0, v0, a0;
}

corpus! {
    m31 Generated31 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, l12, w14, l17, l19, l22, w23, f25.x, f25.y, l26, l29, f31.x, f31.y, l32, l37, l40, l42, w43, w45, f47.x, f47.y, l48]
    {
pub struct Generated31 {
    unit mm;
    input phi1 = 0.2513274rad in 0.2510188rad..0.2516361rad;
    input phi10 = -2.0472712rad in -2.0475799rad..-2.0469626rad;
    param f2 = (27.2969mm, 19.0098mm);
    param l3 = 35.1455mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.5145692rad;
    let g6 = w5 - phi1;
    param f7 = (66.3560mm, 19.0098mm);
    param l8 = 19.4191mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    const f11 = (-12.3803mm, 34.8038mm);
    param l12 = 25.8257mm;
    let q13 = f11 + polar(l12, phi10);
    param w14 = 0.0429088rad;
    let g15 = w14 - phi10;
    const f16 = (46.0648mm, 34.8038mm);
    param l17 = 21.0590mm;
    let q18 = f16 + polar(l17, g15);
    param l19 = -27.2189mm;
    unknown t20 = -123deg;
    unknown s21 = 67.4mm;
    loop q18 + s21 * dir(t20) - polar(l19, t20 - 90deg) = q13;
    param l22 = 42.4427mm;
    param w23 = 0.0455091rad;
    let q24 = q18 + polar(l22, t20 + w23);
    param f25 = (103.1296mm, 16.9889mm);
    param l26 = 98.0596mm;
    unknown t27 = -10deg;
    unknown t28 = 32deg;
    param l29 = 34.2622mm;
    loop f25 + polar(l29, t28) = q18 + polar(l26, t27);
    let q30 = q18 + polar(l26, t27);
    param f31 = (-11.3960mm, 106.8791mm);
    param l32 = 98.0331mm;
    unknown t33 = 14deg;
    unknown t34 = -43deg;
    const l35 = 137.9999mm;
    loop q24 + polar(l32, t33) = f31 + polar(l35, t33 + t34);
    let q36 = q24 + polar(l32, t33);
    param l37 = 47.1288mm;
    unknown t38 = -71deg;
    unknown t39 = -33deg;
    param l40 = 106.1693mm +- 20um;
    loop q18 + polar(-l40, t39 + 180deg) = q36 + rotate((l37, 0mm), t38);
    let q41 = q36 + polar(l37, t38);
    param l42 = 35.8227mm;
    param w43 = -1.5214995rad;
    let q44 = q36 + polar(l42, t38 + w43);
    param w45 = -1.6374605rad;
    unknown t46 = -306deg;
    loop t46 = 3 * (t38) + w45;
    param f47 = (0.0000mm, 0.0000mm);
    param l48 = 39.5403mm;
    let q49 = f47 + polar(l48, t46);
}

impl Generated31 {
    pub fn position1(phi1) -> Position1 {
        q9,
        q4
    }
    pub fn motion1(phi1) -> Motion1 {
        q9,
        velocity0: velocity(q9),
        acceleration0: acceleration(q9),
        jerk0: jerk(q9),
        q4,
        velocity1: velocity(q4),
        acceleration1: acceleration(q4),
        jerk1: jerk(q4)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q9,
        e0: sensitivity(q9, [l48, l40]),
        v0: d(q9, phi1),
        m0: d(q9, phi1, l48),
        w0: d(q9, l48, l40),
        q4,
        e1: sensitivity(q4, [f47.y, f2.x]),
        v1: d(q4, phi1),
        m1: d(q4, phi1, f47.y),
        w1: d(q4, f47.y, f2.x)
    }
    pub fn position2(phi10) -> Position2 {
        q49,
        q44,
        t46,
        t39,
        t38,
        t34,
        margin: margin()
    }
    pub fn motion2(phi10) -> Motion2 {
        q49,
        velocity0: velocity(q49),
        acceleration0: acceleration(q49),
        jerk0: jerk(q49),
        q44,
        velocity1: velocity(q44),
        acceleration1: acceleration(q44),
        jerk1: jerk(q44),
        t46,
        velocity2: velocity(t46),
        acceleration2: acceleration(t46),
        jerk2: jerk(t46),
        t39,
        velocity3: velocity(t39),
        acceleration3: acceleration(t39),
        jerk3: jerk(t39)
    }
    pub fn accuracy2(phi10) -> Accuracy2 {
        q49,
        e0: sensitivity(q49, [l32, l40]),
        v0: d(q49, phi10),
        m0: d(q49, phi10, l32),
        w0: d(q49, l32, l40),
        q44,
        e1: sensitivity(q44, [f2.y, l37]),
        v1: d(q44, phi10),
        m1: d(q44, phi10, f2.y),
        w1: d(q44, f2.y, l37),
        t46,
        e2: sensitivity(t46, [w45, w14]),
        v2: d(t46, phi10),
        m2: d(t46, phi10, w45),
        w2: d(t46, w45, w14),
        t39,
        e3: sensitivity(t39, [l12, w45]),
        v3: d(t39, phi10),
        m3: d(t39, phi10, l12),
        w3: d(t39, l12, w45)
    }
    pub fn closure2(phi10) -> Closure2 {
        r0: (q18 + s21 * dir(t20) - polar(l19, t20 - 90deg)) - (q13),
        v0: velocity((q18 + s21 * dir(t20) - polar(l19, t20 - 90deg)) - (q13)),
        a0: acceleration((q18 + s21 * dir(t20) - polar(l19, t20 - 90deg)) - (q13)),
        r1: (f25 + polar(l29, t28)) - (q18 + polar(l26, t27)),
        v1: velocity((f25 + polar(l29, t28)) - (q18 + polar(l26, t27))),
        a1: acceleration((f25 + polar(l29, t28)) - (q18 + polar(l26, t27))),
        r2: (q24 + polar(l32, t33)) - (f31 + polar(l35, t33 + t34)),
        v2: velocity((q24 + polar(l32, t33)) - (f31 + polar(l35, t33 + t34))),
        a2: acceleration((q24 + polar(l32, t33)) - (f31 + polar(l35, t33 + t34))),
        r3: (q18 + polar(-l40, t39 + 180deg)) - (q36 + rotate((l37, 0mm), t38)),
        v3: velocity((q18 + polar(-l40, t39 + 180deg)) - (q36 + rotate((l37, 0mm), t38))),
        a3: acceleration((q18 + polar(-l40, t39 + 180deg)) - (q36 + rotate((l37, 0mm), t38)))
    }
}
}
    position1(0): q9, q4;
    motion1(0): q9, velocity0, acceleration0, jerk0, q4, velocity1, acceleration1, jerk1;
    accuracy1(0): q9, e0, v0, m0, w0, q4, e1, v1, m1, w1;
    position2(1): q49, q44, t46, t39, t38, t34, margin;
    motion2(1): q49, velocity0, acceleration0, jerk0, q44, velocity1, acceleration1, jerk1, t46, velocity2, acceleration2, jerk2, t39, velocity3, acceleration3, jerk3;
    accuracy2(1): q49, e0, v0, m0, w0, q44, e1, v1, m1, w1, t46, e2, v2, m2, w2, t39, e3, v3, m3, w3;
    closure2(1): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3;
}

corpus! {
    m32 Generated32 [f2.x, f2.y, l3, f5.x, f5.y, l6, l9, l11, w12, f14.x, f14.y, f15.x, f15.y, l16, l19, l21, w22, l27, l29, l31, f33.x, f33.y, w34, l36]
    {
pub struct Generated32 {
    unit m;
    input phi1 = 1.3526302rad;
    param f2 = (33.4125mm, 7.5227mm);
    param l3 = 28.5414mm;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (125.9746mm, 64.9562mm);
    param l6 = 104.9995mm;
    unknown t7 = 40deg;
    unknown t8 = 99deg;
    param l9 = 38.9023mm;
    loop q4 + polar(l6, t7) = f5 + polar(l9, t8);
    let q10 = q4 + polar(l6, t7);
    param l11 = 32.8030mm;
    param w12 = -2.0716668rad;
    let q13 = q4 + polar(l11, t7 + w12);
    param f14 = (120.2839mm, 51.8118mm);
    param f15 = (96.5501mm, 154.0229mm);
    param l16 = 48.2279mm;
    unknown t17 = -160deg;
    unknown t18 = -108deg;
    param l19 = 70.9465mm;
    loop f15 + polar(l19, t18) = q10 + polar(l16, t17);
    let q20 = q10 + polar(l16, t17);
    param l21 = 41.2040mm;
    param w22 = -1.8343051rad;
    let q23 = q10 + polar(l21, t17 + w22);
    const l24 = 43.3670mm;
    unknown t25 = 159deg;
    unknown t26 = -84deg;
    param l27 = 120.5756mm;
    loop q10 + polar(l24, t25) = q13 + polar(l27, t25 + t26);
    let q28 = q10 + polar(l24, t25);
    param l29 = 61.8240mm;
    unknown t30 = -164deg;
    param l31 = 67.5326mm;
    loop l31 = distance(q23 + polar(l29, t30), q10);
    let q32 = q23 + polar(l29, t30);
    param f33 = (154.7909mm, 81.8688mm);
    param w34 = -2.7318896rad;
    unknown s35 = 82.4mm;
    param l36 = 118.2518mm;
    loop distance(f33, q23 + polar(s35, w34)) = l36;
    let q37 = q23 + polar(s35, w34);
}

impl Generated32 {
    pub fn position1(phi1) -> Position1 {
        q37,
        q32,
        s35,
        t30,
        t26,
        t25,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q37,
        velocity0: velocity(q37),
        acceleration0: acceleration(q37),
        jerk0: jerk(q37),
        q32,
        velocity1: velocity(q32),
        acceleration1: acceleration(q32),
        jerk1: jerk(q32),
        s35,
        velocity2: velocity(s35),
        acceleration2: acceleration(s35),
        jerk2: jerk(s35),
        t30,
        velocity3: velocity(t30),
        acceleration3: acceleration(t30),
        jerk3: jerk(t30)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q37,
        e0: sensitivity(q37, [f33.x, l19]),
        v0: d(q37, phi1),
        m0: d(q37, phi1, f33.x),
        w0: d(q37, f33.x, l19),
        q32,
        e1: sensitivity(q32, [f2.y, l6]),
        v1: d(q32, phi1),
        m1: d(q32, phi1, f2.y),
        w1: d(q32, f2.y, l6),
        s35,
        e2: sensitivity(s35, [l16, f14.y]),
        v2: d(s35, phi1),
        m2: d(s35, phi1, l16),
        w2: d(s35, l16, f14.y),
        t30,
        e3: sensitivity(t30, [w22, f2.x]),
        v3: d(t30, phi1),
        m3: d(t30, phi1, w22),
        w3: d(t30, w22, f2.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q4 + polar(l6, t7)) - (f5 + polar(l9, t8)),
        v0: velocity((q4 + polar(l6, t7)) - (f5 + polar(l9, t8))),
        a0: acceleration((q4 + polar(l6, t7)) - (f5 + polar(l9, t8))),
        r1: (f15 + polar(l19, t18)) - (q10 + polar(l16, t17)),
        v1: velocity((f15 + polar(l19, t18)) - (q10 + polar(l16, t17))),
        a1: acceleration((f15 + polar(l19, t18)) - (q10 + polar(l16, t17))),
        r2: (q10 + polar(l24, t25)) - (q13 + polar(l27, t25 + t26)),
        v2: velocity((q10 + polar(l24, t25)) - (q13 + polar(l27, t25 + t26))),
        a2: acceleration((q10 + polar(l24, t25)) - (q13 + polar(l27, t25 + t26))),
        r3: (l31) - (distance(q23 + polar(l29, t30), q10)),
        v3: velocity((l31) - (distance(q23 + polar(l29, t30), q10))),
        a3: acceleration((l31) - (distance(q23 + polar(l29, t30), q10))),
        r4: (distance(f33, q23 + polar(s35, w34))) - (l36),
        v4: velocity((distance(f33, q23 + polar(s35, w34))) - (l36)),
        a4: acceleration((distance(f33, q23 + polar(s35, w34))) - (l36))
    }
}
}
    position1(0): q37, q32, s35, t30, t26, t25, margin;
    motion1(0): q37, velocity0, acceleration0, jerk0, q32, velocity1, acceleration1, jerk1, s35, velocity2, acceleration2, jerk2, t30, velocity3, acceleration3, jerk3;
    accuracy1(0): q37, e0, v0, m0, w0, q32, e1, v1, m1, w1, s35, e2, v2, m2, w2, t30, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4;
}

corpus! {
    m34 Generated34 [l2, w4, l7, f9.x, f9.y, l10, l13, l15, w16, f18.x, f18.y, l19, l22, w23, f25.x, f25.y, l26, l29, w31, f33.x, f33.y, l34]
    {
pub struct Generated34 {
    unit cm;
    input phi1 = 0.3682645rad in 0.3664126rad..0.3701163rad;
    param l2 = 33.5837mm +- 20um;
    let q3 = polar(l2, phi1);
    param w4 = -0.8254951rad;
    let g5 = w4 - phi1 / 2;
    const f6 = (57.3513mm, 0.0000mm);
    param l7 = 28.4988mm;
    let q8 = f6 + polar(l7, g5);
    param f9 = (101.2955mm, 77.3558mm);
    param l10 = 73.4567mm +- 20um;
    unknown t11 = -0deg;
    unknown t12 = -87deg;
    param l13 = 65.9256mm +- 20um;
    loop f9 + polar(-l13, t12 + 180deg) = q3 + rotate((l10, 0mm), t11);
    let q14 = q3 + polar(l10, t11);
    param l15 = 30.2064mm;
    param w16 = -0.2337876rad;
    let q17 = q3 + polar(l15, t11 + w16);
    param f18 = (92.9375mm, -92.6672mm);
    param l19 = 23.9259mm;
    unknown t20 = 87deg;
    unknown s21 = 67.4mm;
    loop q8 = f18 + polar(s21, t20) + polar(l19, t20 + 90deg);
    param l22 = 33.5264mm +- 20um;
    param w23 = 1.3522766rad;
    let q24 = f18 + polar(l22, t20 + w23);
    param f25 = (148.4548mm, -38.9950mm);
    param l26 = 45.6061mm;
    unknown t27 = -7deg;
    unknown t28 = 88deg;
    param l29 = 45.3351mm;
    loop q14 + polar(l26, t27) = f25 + polar(l29, t28);
    let q30 = q14 + polar(l26, t27);
    param w31 = -0.0717828rad;
    unknown t32 = 83deg;
    loop t32 = w31 - (t12);
    param f33 = (0.0000mm, 0.0000mm);
    param l34 = 24.3826mm;
    unknown p35 = (3.0mm, 24.2mm);
    loop f33 + polar(l34, t32) = p35;
    let q36 = p35;
}

impl Generated34 {
    pub fn position1(phi1) -> Position1 {
        q36,
        q30,
        p35,
        t32,
        t28,
        t27,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q36,
        velocity0: velocity(q36),
        acceleration0: acceleration(q36),
        jerk0: jerk(q36),
        q30,
        velocity1: velocity(q30),
        acceleration1: acceleration(q30),
        jerk1: jerk(q30),
        p35,
        velocity2: velocity(p35),
        acceleration2: acceleration(p35),
        jerk2: jerk(p35),
        t32,
        velocity3: velocity(t32),
        acceleration3: acceleration(t32),
        jerk3: jerk(t32)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q36,
        e0: sensitivity(q36, [f18.x, f33.y]),
        v0: d(q36, phi1),
        m0: d(q36, phi1, f18.x),
        w0: d(q36, f18.x, f33.y),
        q30,
        e1: sensitivity(q30, [f33.x, l2]),
        v1: d(q30, phi1),
        m1: d(q30, phi1, f33.x),
        w1: d(q30, f33.x, l2),
        p35,
        e2: sensitivity(p35, [f25.x, l15]),
        v2: d(p35, phi1),
        m2: d(p35, phi1, f25.x),
        w2: d(p35, f25.x, l15),
        t32,
        e3: sensitivity(t32, [l29, l15]),
        v3: d(t32, phi1),
        m3: d(t32, phi1, l29),
        w3: d(t32, l29, l15)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f9 + polar(-l13, t12 + 180deg)) - (q3 + rotate((l10, 0mm), t11)),
        v0: velocity((f9 + polar(-l13, t12 + 180deg)) - (q3 + rotate((l10, 0mm), t11))),
        a0: acceleration((f9 + polar(-l13, t12 + 180deg)) - (q3 + rotate((l10, 0mm), t11))),
        r1: (q8) - (f18 + polar(s21, t20) + polar(l19, t20 + 90deg)),
        v1: velocity((q8) - (f18 + polar(s21, t20) + polar(l19, t20 + 90deg))),
        a1: acceleration((q8) - (f18 + polar(s21, t20) + polar(l19, t20 + 90deg))),
        r2: (q14 + polar(l26, t27)) - (f25 + polar(l29, t28)),
        v2: velocity((q14 + polar(l26, t27)) - (f25 + polar(l29, t28))),
        a2: acceleration((q14 + polar(l26, t27)) - (f25 + polar(l29, t28)))
    }
}
}
    position1(0): q36, q30, p35, t32, t28, t27, margin;
    motion1(0): q36, velocity0, acceleration0, jerk0, q30, velocity1, acceleration1, jerk1, p35, velocity2, acceleration2, jerk2, t32, velocity3, acceleration3, jerk3;
    accuracy1(0): q36, e0, v0, m0, w0, q30, e1, v1, m1, w1, p35, e2, v2, m2, w2, t32, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m35 Generated35 [f2.x, f2.y, l3, f5.x, f5.y, l6, l9, l13, l14, f16.x, f16.y, w17, l19, f21.x, f21.y, l22, l24]
    {
pub struct Generated35 {
    unit cm;
    input phi1 = -0.8429940rad in -0.8448459rad..-0.8411422rad;
    param f2 = (-15.8243mm, 8.2963mm);
    param l3 = 44.0672mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (-55.3042mm, 17.1864mm);
    param l6 = 77.8556mm;
    unknown t7 = -102deg;
    unknown t8 = -66deg;
    param l9 = 129.0041mm +- 20um;
    loop q4 + polar(l6, t7) = f5 + polar(l9, t8);
    let q10 = q4 + polar(l6, t7);
    const f11 = (-38.4914mm, -29.0686mm);
    unknown p12 = (-0.4mm, 16.2mm);
    param l13 = 43.0949mm +- 20um;
    loop distance(p12, q4) = l13;
    param l14 = 59.1750mm +- 20um;
    loop norm(p12 - f11) = l14;
    let q15 = p12;
    param f16 = (95.2749mm, 45.4971mm);
    param w17 = 0.3913409rad;
    unknown s18 = 37.0mm;
    param l19 = 63.2937mm;
    loop l19 = distance(f16, q15 + polar(s18, w17));
    let q20 = q15 + polar(s18, w17);
    param f21 = (-111.4760mm, -106.8120mm);
    param l22 = 76.3809mm;
    unknown t23 = -118deg;
    param l24 = 95.5542mm +- 20um;
    loop distance(q10 + polar(l22, t23), f21) = l24;
    let q25 = q10 + polar(l22, t23);
}

impl Generated35 {
    pub fn position1(phi1) -> Position1 {
        q25,
        q20,
        t23,
        s18,
        p12,
        t8,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q25,
        velocity0: velocity(q25),
        acceleration0: acceleration(q25),
        jerk0: jerk(q25),
        q20,
        velocity1: velocity(q20),
        acceleration1: acceleration(q20),
        jerk1: jerk(q20),
        t23,
        velocity2: velocity(t23),
        acceleration2: acceleration(t23),
        jerk2: jerk(t23),
        s18,
        velocity3: velocity(s18),
        acceleration3: acceleration(s18),
        jerk3: jerk(s18)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q25,
        e0: sensitivity(q25, [l19, f21.y]),
        v0: d(q25, phi1),
        m0: d(q25, phi1, l19),
        w0: d(q25, l19, f21.y),
        q20,
        e1: sensitivity(q20, [l14, l3]),
        v1: d(q20, phi1),
        m1: d(q20, phi1, l14),
        w1: d(q20, l14, l3),
        t23,
        e2: sensitivity(t23, [l14, l22]),
        v2: d(t23, phi1),
        m2: d(t23, phi1, l14),
        w2: d(t23, l14, l22),
        s18,
        e3: sensitivity(s18, [l14, f16.y]),
        v3: d(s18, phi1),
        m3: d(s18, phi1, l14),
        w3: d(s18, l14, f16.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q4 + polar(l6, t7)) - (f5 + polar(l9, t8)),
        v0: velocity((q4 + polar(l6, t7)) - (f5 + polar(l9, t8))),
        a0: acceleration((q4 + polar(l6, t7)) - (f5 + polar(l9, t8))),
        r1: (distance(p12, q4)) - (l13),
        v1: velocity((distance(p12, q4)) - (l13)),
        a1: acceleration((distance(p12, q4)) - (l13)),
        r2: (norm(p12 - f11)) - (l14),
        v2: velocity((norm(p12 - f11)) - (l14)),
        a2: acceleration((norm(p12 - f11)) - (l14)),
        r3: (l19) - (distance(f16, q15 + polar(s18, w17))),
        v3: velocity((l19) - (distance(f16, q15 + polar(s18, w17)))),
        a3: acceleration((l19) - (distance(f16, q15 + polar(s18, w17)))),
        r4: (distance(q10 + polar(l22, t23), f21)) - (l24),
        v4: velocity((distance(q10 + polar(l22, t23), f21)) - (l24)),
        a4: acceleration((distance(q10 + polar(l22, t23), f21)) - (l24))
    }
}
}
    position1(0): q25, q20, t23, s18, p12, t8, margin;
    motion1(0): q25, velocity0, acceleration0, jerk0, q20, velocity1, acceleration1, jerk1, t23, velocity2, acceleration2, jerk2, s18, velocity3, acceleration3, jerk3;
    accuracy1(0): q25, e0, v0, m0, w0, q20, e1, v1, m1, w1, t23, e2, v2, m2, w2, s18, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4;
}

corpus! {
    m37 Generated37 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, f10.x, f10.y, w11, w13, l14, l16, f18.x, f18.y, f18.z, f19.x, f19.y, f19.z, l21, l22, l23, l26, f28.x, f28.y, f28.z, d29.x, d29.y, d29.z, w32, w33, f34.x, f34.y, f34.z, l35, f37.x, f37.y, f37.z, v38.x, v38.y, v38.z, l41]
    {
pub struct Generated37 {
    unit mm;
    input phi1 = -2.9181905rad;
    param f2 = (22.3967mm, 17.0016mm);
    param l3 = 41.8218mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = -0.1510075rad;
    let g6 = w5 - phi1;
    param f7 = (75.6322mm, 17.0016mm);
    param l8 = 38.9929mm;
    let q9 = f7 + polar(l8, g6);
    param f10 = (-15.3778mm, 72.3173mm);
    param w11 = 0.0920239rad;
    unknown s12 = 70.8mm;
    param w13 = -0.1859787rad;
    param l14 = 129.4393mm;
    loop l14 = dot(q9 + polar(s12, w11) - f10, dir(w13));
    let q15 = q9 + polar(s12, w11);
    param l16 = 31.1170mm;
    let q17 = (q4.x, q4.y, l16);
    param f18 = (14.1667mm, -28.2970mm, 46.6095mm);
    param f19 = (-35.8114mm, -10.2435mm, 108.2729mm);
    unknown p20 = (-5.0mm, 31.6mm, 96.0mm);
    param l21 = 70.4066mm;
    loop distance(p20, q17) = l21;
    param l22 = 79.9279mm;
    loop l22 * l22 = dot(f18 - p20, f18 - p20);
    param l23 = 53.3871mm +- 20um;
    loop l23 = distance(p20, f19);
    let q24 = p20;
    let q25 = (q24.x, q24.y);
    param l26 = 28.1968mm;
    let q27 = (q25.x, q25.y, l26);
    param f28 = (-79.6284mm, 10.5902mm, 13.4697mm);
    param d29 = (0.8759715, 0.4740172, -0.0893399);
    unknown n31 = (-0.65, -0.62, 0.44);
    loop 1 = dot(n31, n31);
    param w32 = 1.7004456rad;
    loop cos(w32) = dot(n31, unit(turn((0, 1, 0), d29, g6)));
    param w33 = 1.1576215rad;
    loop cos(w33) = dot(n31, unit((-0.8561942, -0.1110387, -0.5045810)));
    param f34 = (33.9015mm, -18.9395mm, 9.5907mm);
    param l35 = 37.4245mm;
    let q36 = f34 + l35 * n31;
    param f37 = (8.2850mm, 49.2433mm, -3.2173mm);
    param v38 = (23.7376mm, 54.6301mm, -7.2162mm);
    unknown t39 = 140deg;
    let q40 = f37 + turn(v38, (0, 0, 1), t39);
    param l41 = 92.1157mm;
    loop norm(q36 - q40) = l41;
    let q42 = (q40.x, q40.y);
}

impl Generated37 {
    pub fn position1(phi1) -> Position1 {
        q42,
        q25,
        q40,
        t39,
        n31,
        p20,
        s12,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q42,
        velocity0: velocity(q42),
        acceleration0: acceleration(q42),
        jerk0: jerk(q42),
        q25,
        velocity1: velocity(q25),
        acceleration1: acceleration(q25),
        jerk1: jerk(q25),
        q40,
        velocity2: velocity(q40),
        acceleration2: acceleration(q40),
        jerk2: jerk(q40),
        t39,
        velocity3: velocity(t39),
        acceleration3: acceleration(t39),
        jerk3: jerk(t39)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q42,
        e0: sensitivity(q42, [f19.y, f37.y]),
        v0: d(q42, phi1),
        m0: d(q42, phi1, f19.y),
        w0: d(q42, f19.y, f37.y),
        q25,
        e1: sensitivity(q25, [l8, f7.y]),
        v1: d(q25, phi1),
        m1: d(q25, phi1, l8),
        w1: d(q25, l8, f7.y),
        q40,
        e2: sensitivity(q40, [f37.z, v38.z]),
        v2: d(q40, phi1),
        m2: d(q40, phi1, f37.z),
        w2: d(q40, f37.z, v38.z),
        t39,
        e3: sensitivity(t39, [v38.z, f28.z]),
        v3: d(t39, phi1),
        m3: d(t39, phi1, v38.z),
        w3: d(t39, v38.z, f28.z)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (l14) - (dot(q9 + polar(s12, w11) - f10, dir(w13))),
        v0: velocity((l14) - (dot(q9 + polar(s12, w11) - f10, dir(w13)))),
        a0: acceleration((l14) - (dot(q9 + polar(s12, w11) - f10, dir(w13)))),
        r1: (distance(p20, q17)) - (l21),
        v1: velocity((distance(p20, q17)) - (l21)),
        a1: acceleration((distance(p20, q17)) - (l21)),
        r2: (l22 * l22) - (dot(f18 - p20, f18 - p20)),
        v2: velocity((l22 * l22) - (dot(f18 - p20, f18 - p20))),
        a2: acceleration((l22 * l22) - (dot(f18 - p20, f18 - p20))),
        r3: (l23) - (distance(p20, f19)),
        v3: velocity((l23) - (distance(p20, f19))),
        a3: acceleration((l23) - (distance(p20, f19))),
        r4: (1) - (dot(n31, n31)),
        v4: velocity((1) - (dot(n31, n31))),
        a4: acceleration((1) - (dot(n31, n31))),
        r5: (cos(w32)) - (dot(n31, unit(turn((0, 1, 0), d29, g6)))),
        v5: velocity((cos(w32)) - (dot(n31, unit(turn((0, 1, 0), d29, g6))))),
        a5: acceleration((cos(w32)) - (dot(n31, unit(turn((0, 1, 0), d29, g6))))),
        r6: (cos(w33)) - (dot(n31, unit((-0.8561942, -0.1110387, -0.5045810)))),
        v6: velocity((cos(w33)) - (dot(n31, unit((-0.8561942, -0.1110387, -0.5045810))))),
        a6: acceleration((cos(w33)) - (dot(n31, unit((-0.8561942, -0.1110387, -0.5045810))))),
        r7: (norm(q36 - q40)) - (l41),
        v7: velocity((norm(q36 - q40)) - (l41)),
        a7: acceleration((norm(q36 - q40)) - (l41))
    }
}
}
    position1(0): q42, q25, q40, t39, n31, p20, s12, margin;
    motion1(0): q42, velocity0, acceleration0, jerk0, q25, velocity1, acceleration1, jerk1, q40, velocity2, acceleration2, jerk2, t39, velocity3, acceleration3, jerk3;
    accuracy1(0): q42, e0, v0, m0, w0, q25, e1, v1, m1, w1, q40, e2, v2, m2, w2, t39, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5, r6, v6, a6, r7, v7, a7;
}

corpus! {
    m38 Generated38 [f2.x, f2.y, l3, f6.x, f6.y, l7, f9.x, f9.y, w10, w11, l15, d19.x, d19.y, d19.z, f20.x, f20.y, f20.z, v21.x, v21.y, v21.z, f26.x, f26.y, f26.z, l28, d31.x, d31.y, d31.z, d32.x, d32.y, d32.z, w38, f39.x, f39.y, f39.z, l40]
    {
pub struct Generated38 {
    unit mm;
    input phi1 = -1.7296213rad;
    input phi5 = -1.7575466rad;
    param f2 = (33.4397mm, -39.4155mm);
    param l3 = 22.3777mm;
    let q4 = f2 + polar(l3, phi1);
    param f6 = (-6.4524mm, 33.7687mm);
    param l7 = 37.4480mm;
    let q8 = f6 + polar(l7, phi5);
    param f9 = (-18.7652mm, -88.8748mm);
    param w10 = -0.6279044rad;
    param w11 = 0.0667966rad;
    unknown s12 = 70.4mm;
    unknown s13 = 21.1mm;
    loop f9 + polar(s13, phi5 + w11) = q4 + polar(s12, phi5 + w10);
    let q14 = q4 + polar(s12, phi5 + w10);
    param l15 = 1.7541mm;
    let q16 = (q4.x, q4.y, l15);
    param d19 = (-0.9795735, 0.1361638, 0.1479703);
    param f20 = (-38.7414mm, -68.0090mm, -30.7202mm);
    param v21 = (16.2798mm, 38.9890mm, 42.6008mm);
    unknown s22 = 54.6mm;
    unknown s23 = 9.0mm;
    unknown t24 = -10deg;
    loop f20 + turn(v21, d19, t24) = q16 + s22 * unit((-0.9160594, 0.3665166, 0.1627903)) + s23 * unit(turn((0.8513091, 0.5104835, 0.1211588), (0, 1, 0), phi5));
    let q25 = f20 + turn(v21, d19, t24);
    param f26 = (88.9130mm, 7.3095mm, 21.5496mm);
    unknown s27 = 52.9mm;
    param l28 = 116.1757mm;
    loop norm(q16 - (f26 + s27 * unit((0, 0, 1)))) = l28;
    let q29 = f26 + s27 * unit((0, 0, 1));
    let q30 = (q29.x, q29.y);
    param d31 = (-0.1884291, 0.2411759, -1.9764434);
    param d32 = (-0.1033353, -0.4071079, 0.9075158);
    const d35 = (0.4493504, -0.8933541, 0.0016234);
    unknown t37 = 67deg;
    param w38 = 1.2102688rad;
    loop cos(w38) = dot(unit(turn((0, 1, 0), (-0.1273192, -0.8294161, 0.5439290), phi1)), turn(unit((1.7356369, 0.4177134, -0.9017096)), d35, t37));
    param f39 = (-27.9155mm, 9.3406mm, 27.0828mm);
    param l40 = 59.9239mm;
    let q41 = f39 + l40 * turn(unit((1.7356369, 0.4177134, -0.9017096)), d35, t37);
}

impl Generated38 {
    pub fn position1(phi1) -> Position1 {
        q30,
        q4,
        q41,
        t37,
        s27,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q30,
        velocity0: velocity(q30),
        acceleration0: acceleration(q30),
        jerk0: jerk(q30),
        q4,
        velocity1: velocity(q4),
        acceleration1: acceleration(q4),
        jerk1: jerk(q4),
        q41,
        velocity2: velocity(q41),
        acceleration2: acceleration(q41),
        jerk2: jerk(q41),
        t37,
        velocity3: velocity(t37),
        acceleration3: acceleration(t37),
        jerk3: jerk(t37)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q30,
        e0: sensitivity(q30, [f20.y, f20.z]),
        v0: d(q30, phi1),
        m0: d(q30, phi1, f20.y),
        w0: d(q30, f20.y, f20.z),
        q4,
        e1: sensitivity(q4, [f20.x, d32.x]),
        v1: d(q4, phi1),
        m1: d(q4, phi1, f20.x),
        w1: d(q4, f20.x, d32.x),
        q41,
        e2: sensitivity(q41, [d32.x, f6.y]),
        v2: d(q41, phi1),
        m2: d(q41, phi1, d32.x),
        w2: d(q41, d32.x, f6.y),
        t37,
        e3: sensitivity(t37, [l28, f6.y]),
        v3: d(t37, phi1),
        m3: d(t37, phi1, l28),
        w3: d(t37, l28, f6.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (norm(q16 - (f26 + s27 * unit((0, 0, 1))))) - (l28),
        v0: velocity((norm(q16 - (f26 + s27 * unit((0, 0, 1))))) - (l28)),
        a0: acceleration((norm(q16 - (f26 + s27 * unit((0, 0, 1))))) - (l28)),
        r1: (cos(w38)) - (dot(unit(turn((0, 1, 0), (-0.1273192, -0.8294161, 0.5439290), phi1)), turn(unit((1.7356369, 0.4177134, -0.9017096)), d35, t37))),
        v1: velocity((cos(w38)) - (dot(unit(turn((0, 1, 0), (-0.1273192, -0.8294161, 0.5439290), phi1)), turn(unit((1.7356369, 0.4177134, -0.9017096)), d35, t37)))),
        a1: acceleration((cos(w38)) - (dot(unit(turn((0, 1, 0), (-0.1273192, -0.8294161, 0.5439290), phi1)), turn(unit((1.7356369, 0.4177134, -0.9017096)), d35, t37))))
    }
    pub fn position2(phi5) -> Position2 {
        q8
    }
    pub fn motion2(phi5) -> Motion2 {
        q8,
        velocity0: velocity(q8),
        acceleration0: acceleration(q8),
        jerk0: jerk(q8)
    }
    pub fn accuracy2(phi5) -> Accuracy2 {
        q8,
        e0: sensitivity(q8, [l15, f26.z]),
        v0: d(q8, phi5),
        m0: d(q8, phi5, l15),
        w0: d(q8, l15, f26.z)
    }
    pub fn position3(phi1, phi5) -> Position3 {
        q14,
        q25,
        t24,
        s23,
        s22,
        s13,
        margin: margin()
    }
    pub fn motion3(phi1, phi5) -> Motion3 {
        q14,
        velocity0: velocity(q14),
        acceleration0: acceleration(q14),
        q25,
        velocity1: velocity(q25),
        acceleration1: acceleration(q25),
        t24,
        velocity2: velocity(t24),
        acceleration2: acceleration(t24),
        s23,
        velocity3: velocity(s23),
        acceleration3: acceleration(s23)
    }
    pub fn accuracy3(phi1, phi5) -> Accuracy3 {
        q14,
        e0: sensitivity(q14, [d19.y, w10]),
        v0: d(q14, phi1),
        m0: d(q14, phi1, d19.y),
        w0: d(q14, d19.y, w10),
        q25,
        e1: sensitivity(q25, [f26.y, f6.y]),
        v1: d(q25, phi1),
        m1: d(q25, phi1, f26.y),
        w1: d(q25, f26.y, f6.y),
        t24,
        e2: sensitivity(t24, [f39.y, v21.z]),
        v2: d(t24, phi1),
        m2: d(t24, phi1, f39.y),
        w2: d(t24, f39.y, v21.z),
        s23,
        e3: sensitivity(s23, [d32.y, l40]),
        v3: d(s23, phi1),
        m3: d(s23, phi1, d32.y),
        w3: d(s23, d32.y, l40)
    }
    pub fn closure3(phi1, phi5) -> Closure3 {
        r0: (f9 + polar(s13, phi5 + w11)) - (q4 + polar(s12, phi5 + w10)),
        v0: velocity((f9 + polar(s13, phi5 + w11)) - (q4 + polar(s12, phi5 + w10))),
        a0: acceleration((f9 + polar(s13, phi5 + w11)) - (q4 + polar(s12, phi5 + w10))),
        r1: (f20 + turn(v21, d19, t24)) - (q16 + s22 * unit((-0.9160594, 0.3665166, 0.1627903)) + s23 * unit(turn((0.8513091, 0.5104835, 0.1211588), (0, 1, 0), phi5))),
        v1: velocity((f20 + turn(v21, d19, t24)) - (q16 + s22 * unit((-0.9160594, 0.3665166, 0.1627903)) + s23 * unit(turn((0.8513091, 0.5104835, 0.1211588), (0, 1, 0), phi5)))),
        a1: acceleration((f20 + turn(v21, d19, t24)) - (q16 + s22 * unit((-0.9160594, 0.3665166, 0.1627903)) + s23 * unit(turn((0.8513091, 0.5104835, 0.1211588), (0, 1, 0), phi5))))
    }
}
}
    position1(0): q30, q4, q41, t37, s27, margin;
    motion1(0): q30, velocity0, acceleration0, jerk0, q4, velocity1, acceleration1, jerk1, q41, velocity2, acceleration2, jerk2, t37, velocity3, acceleration3, jerk3;
    accuracy1(0): q30, e0, v0, m0, w0, q4, e1, v1, m1, w1, q41, e2, v2, m2, w2, t37, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1;
    position2(1): q8;
    motion2(1): q8, velocity0, acceleration0, jerk0;
    accuracy2(1): q8, e0, v0, m0, w0;
    position3(0, 1): q14, q25, t24, s23, s22, s13, margin;
    motion3(0, 1): q14, velocity0, acceleration0, q25, velocity1, acceleration1, t24, velocity2, acceleration2, s23, velocity3, acceleration3;
    accuracy3(0, 1): q14, e0, v0, m0, w0, q25, e1, v1, m1, w1, t24, e2, v2, m2, w2, s23, e3, v3, m3, w3;
    closure3(0, 1): r0, v0, a0, r1, v1, a1;
}

corpus! {
    m40 Generated40 [f2.x, f2.y, l3, l5, l10, f11.x, f11.y, f11.z, l12, f13.x, f13.y, f13.z, l14, w19, w20, f21.x, f21.y, f21.z, l22]
    {
pub struct Generated40 {
    unit mm;
    input phi1 = -2.8797933rad;
    param f2 = (-22.9313mm, 37.7924mm);
    param l3 = 39.6505mm;
    let q4 = f2 + polar(l3, phi1);
    param l5 = 18.4063mm;
    let q6 = (q4.x, q4.y, l5);
    const d7 = (-0.2062754, -0.9074212, 0.3661110);
    const d8 = (0.3971449, 1.1811604, -1.5643325);
    unknown p9 = (-126.8mm, 14.2mm, -14.4mm);
    param l10 = 74.5050mm;
    loop distance(p9, q6) = l10;
    param f11 = (-27.6112mm, 66.7010mm, 9.1766mm);
    param l12 = -57.9366mm +- 20um;
    loop l12 = dot(unit(turn(d8, d7, phi1)), p9 - f11);
    param f13 = (-53.5288mm, 25.0853mm, -18.3431mm);
    param l14 = 3.9782mm;
    loop l14 = dot(unit((0, 0, 1)), p9 - f13);
    let q15 = p9;
    let q16 = (q15.x, q15.y);
    unknown n18 = (-0.36, 0.64, -0.68);
    loop 1 = norm(n18);
    param w19 = 1.2329161rad;
    loop cos(w19) = dot(n18, unit(turn((1, 0, 0), (0.2007909, 0.9705341, 0.1332163), phi1)));
    param w20 = 0.8757331rad;
    loop cos(w20) = dot(n18, unit((0, 1, 0)));
    param f21 = (34.8470mm, -19.6191mm, 0.8835mm);
    param l22 = 49.6564mm +- 20um;
    let q23 = f21 + l22 * n18;
}

impl Generated40 {
    pub fn position1(phi1) -> Position1 {
        q16,
        q4,
        q23,
        n18,
        p9,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q16,
        velocity0: velocity(q16),
        acceleration0: acceleration(q16),
        jerk0: jerk(q16),
        q4,
        velocity1: velocity(q4),
        acceleration1: acceleration(q4),
        jerk1: jerk(q4),
        q23,
        velocity2: velocity(q23),
        acceleration2: acceleration(q23),
        jerk2: jerk(q23),
        n18,
        velocity3: velocity(n18),
        acceleration3: acceleration(n18),
        jerk3: jerk(n18)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q16,
        e0: sensitivity(q16, [f21.x, l22]),
        v0: d(q16, phi1),
        m0: d(q16, phi1, f21.x),
        w0: d(q16, f21.x, l22),
        q4,
        e1: sensitivity(q4, [f2.y, l5]),
        v1: d(q4, phi1),
        m1: d(q4, phi1, f2.y),
        w1: d(q4, f2.y, l5),
        q23,
        e2: sensitivity(q23, [f13.y, l12]),
        v2: d(q23, phi1),
        m2: d(q23, phi1, f13.y),
        w2: d(q23, f13.y, l12),
        n18,
        e3: sensitivity(n18, [f2.y, l22]),
        v3: d(n18, phi1),
        m3: d(n18, phi1, f2.y),
        w3: d(n18, f2.y, l22)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (distance(p9, q6)) - (l10),
        v0: velocity((distance(p9, q6)) - (l10)),
        a0: acceleration((distance(p9, q6)) - (l10)),
        r1: (l12) - (dot(unit(turn(d8, d7, phi1)), p9 - f11)),
        v1: velocity((l12) - (dot(unit(turn(d8, d7, phi1)), p9 - f11))),
        a1: acceleration((l12) - (dot(unit(turn(d8, d7, phi1)), p9 - f11))),
        r2: (l14) - (dot(unit((0, 0, 1)), p9 - f13)),
        v2: velocity((l14) - (dot(unit((0, 0, 1)), p9 - f13))),
        a2: acceleration((l14) - (dot(unit((0, 0, 1)), p9 - f13))),
        r3: (1) - (norm(n18)),
        v3: velocity((1) - (norm(n18))),
        a3: acceleration((1) - (norm(n18))),
        r4: (cos(w19)) - (dot(n18, unit(turn((1, 0, 0), (0.2007909, 0.9705341, 0.1332163), phi1)))),
        v4: velocity((cos(w19)) - (dot(n18, unit(turn((1, 0, 0), (0.2007909, 0.9705341, 0.1332163), phi1))))),
        a4: acceleration((cos(w19)) - (dot(n18, unit(turn((1, 0, 0), (0.2007909, 0.9705341, 0.1332163), phi1))))),
        r5: (cos(w20)) - (dot(n18, unit((0, 1, 0)))),
        v5: velocity((cos(w20)) - (dot(n18, unit((0, 1, 0))))),
        a5: acceleration((cos(w20)) - (dot(n18, unit((0, 1, 0)))))
    }
}
}
    position1(0): q16, q4, q23, n18, p9, margin;
    motion1(0): q16, velocity0, acceleration0, jerk0, q4, velocity1, acceleration1, jerk1, q23, velocity2, acceleration2, jerk2, n18, velocity3, acceleration3, jerk3;
    accuracy1(0): q16, e0, v0, m0, w0, q4, e1, v1, m1, w1, q23, e2, v2, m2, w2, n18, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m41 Generated41 [f2.x, f2.y, l3, l7, w9, f11.x, f11.y, l12, l14, f16.x, f16.y, f16.z, f17.x, f17.y, f17.z, l19, l20, l21, v27.x, v27.y, v27.z, f32.x, f32.y, f32.z, d34.x, d34.y, d34.z, f40.x, f40.y, f40.z, f41.x, f41.y, f41.z, l43, l44]
    {
pub struct Generated41 {
    unit cm;
    input phi1 = 0.7452556rad in 0.7443297rad..0.7461815rad;
    input phi5 = -1.5166911rad in -1.5176170rad..-1.5157652rad;
    param f2 = (-34.5135mm, 7.8711mm);
    param l3 = 23.2367mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    const f6 = (-21.5677mm, 19.2117mm);
    param l7 = 25.4946mm;
    let q8 = f6 + polar(l7, phi5);
    param w9 = 0.3973057rad;
    let g10 = w9 - phi5;
    param f11 = (12.2334mm, 19.2117mm);
    param l12 = 18.7683mm;
    let q13 = f11 + polar(l12, g10);
    param l14 = 8.2918mm;
    let q15 = (q8.x, q8.y, l14);
    param f16 = (80.4745mm, 15.6151mm, 66.9238mm);
    param f17 = (-52.2160mm, -86.0837mm, 3.2555mm);
    unknown p18 = (-38.9mm, -29.8mm, 111.3mm);
    param l19 = 107.3485mm +- 20um;
    loop l19 = norm(p18 - q15);
    param l20 = 135.2013mm;
    loop l20 = norm(p18 - f16);
    param l21 = 122.5747mm +- 20um;
    loop l21 = distance(p18, f17);
    let q22 = p18;
    let q23 = (q22.x, q22.y);
    const d24 = (-0.3804600, 0.7147424, 0.5868504);
    const d25 = (0.3613940, -1.3300038, 1.4493048);
    const f26 = (33.5720mm, -57.8957mm, 65.4506mm);
    param v27 = (11.6989mm, -44.0462mm, -39.0265mm);
    unknown s28 = 5.2mm;
    unknown s29 = -42.7mm;
    unknown t30 = -116deg;
    loop q22 + s28 * unit((0, 1, 0)) + s29 * unit(d24) = f26 + turn(v27, d25, t30);
    let q31 = f26 + turn(v27, d25, t30);
    param f32 = (32.7800mm, 23.9332mm, 39.3744mm);
    const d33 = (0.8170673, -0.5708761, -0.0806317);
    param d34 = (0.5969810, -1.3662459, -1.3330363);
    const d35 = (-0.0372790, 0.4392804, -0.8975762);
    unknown s36 = 85.8mm;
    unknown s37 = 19.9mm;
    unknown s38 = 117.7mm;
    loop q22 + s36 * unit(turn(d33, (1, 0, 0), t30)) + s37 * unit(d34) = f32 - s38 * unit(d35);
    let q39 = q22 + s36 * unit(turn(d33, (1, 0, 0), t30));
    param f40 = (-20.6322mm, -118.1963mm, 115.2363mm);
    param f41 = (63.3170mm, -23.8266mm, 58.5380mm);
    unknown p42 = (-12.4mm, -46.5mm, 139.4mm);
    param l43 = 54.7800mm;
    loop norm(p42 - q31) = l43;
    param l44 = 76.0785mm;
    loop dot(f40 - p42, f40 - p42) = l44 * l44;
    const l45 = 113.0571mm;
    loop distance(p42, f41) = l45;
    let q46 = p42;
    let q47 = (q46.x, q46.y);
}

impl Generated41 {
    pub fn position1(phi1) -> Position1 {
        q4
    }
    pub fn motion1(phi1) -> Motion1 {
        q4,
        velocity0: velocity(q4),
        acceleration0: acceleration(q4),
        jerk0: jerk(q4)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q4,
        e0: sensitivity(q4, [w9, d34.x]),
        v0: d(q4, phi1),
        m0: d(q4, phi1, w9),
        w0: d(q4, w9, d34.x)
    }
    pub fn position2(phi5) -> Position2 {
        q47,
        q23,
        q46,
        p42,
        s38,
        s37,
        s36,
        margin: margin()
    }
    pub fn motion2(phi5) -> Motion2 {
        q47,
        velocity0: velocity(q47),
        acceleration0: acceleration(q47),
        jerk0: jerk(q47),
        q23,
        velocity1: velocity(q23),
        acceleration1: acceleration(q23),
        jerk1: jerk(q23),
        q46,
        velocity2: velocity(q46),
        acceleration2: acceleration(q46),
        jerk2: jerk(q46),
        p42,
        velocity3: velocity(p42),
        acceleration3: acceleration(p42),
        jerk3: jerk(p42)
    }
    pub fn accuracy2(phi5) -> Accuracy2 {
        q47,
        e0: sensitivity(q47, [d34.y, f11.y]),
        v0: d(q47, phi5),
        m0: d(q47, phi5, d34.y),
        w0: d(q47, d34.y, f11.y),
        q23,
        e1: sensitivity(q23, [f2.x, f16.y]),
        v1: d(q23, phi5),
        m1: d(q23, phi5, f2.x),
        w1: d(q23, f2.x, f16.y),
        q46,
        e2: sensitivity(q46, [f2.y, l20]),
        v2: d(q46, phi5),
        m2: d(q46, phi5, f2.y),
        w2: d(q46, f2.y, l20),
        p42,
        e3: sensitivity(p42, [f41.x, w9]),
        v3: d(p42, phi5),
        m3: d(p42, phi5, f41.x),
        w3: d(p42, f41.x, w9)
    }
    pub fn closure2(phi5) -> Closure2 {
        r0: (l19) - (norm(p18 - q15)),
        v0: velocity((l19) - (norm(p18 - q15))),
        a0: acceleration((l19) - (norm(p18 - q15))),
        r1: (l20) - (norm(p18 - f16)),
        v1: velocity((l20) - (norm(p18 - f16))),
        a1: acceleration((l20) - (norm(p18 - f16))),
        r2: (l21) - (distance(p18, f17)),
        v2: velocity((l21) - (distance(p18, f17))),
        a2: acceleration((l21) - (distance(p18, f17))),
        r3: (q22 + s28 * unit((0, 1, 0)) + s29 * unit(d24)) - (f26 + turn(v27, d25, t30)),
        v3: velocity((q22 + s28 * unit((0, 1, 0)) + s29 * unit(d24)) - (f26 + turn(v27, d25, t30))),
        a3: acceleration((q22 + s28 * unit((0, 1, 0)) + s29 * unit(d24)) - (f26 + turn(v27, d25, t30))),
        r4: (q22 + s36 * unit(turn(d33, (1, 0, 0), t30)) + s37 * unit(d34)) - (f32 - s38 * unit(d35)),
        v4: velocity((q22 + s36 * unit(turn(d33, (1, 0, 0), t30)) + s37 * unit(d34)) - (f32 - s38 * unit(d35))),
        a4: acceleration((q22 + s36 * unit(turn(d33, (1, 0, 0), t30)) + s37 * unit(d34)) - (f32 - s38 * unit(d35))),
        r5: (norm(p42 - q31)) - (l43),
        v5: velocity((norm(p42 - q31)) - (l43)),
        a5: acceleration((norm(p42 - q31)) - (l43)),
        r6: (dot(f40 - p42, f40 - p42)) - (l44 * l44),
        v6: velocity((dot(f40 - p42, f40 - p42)) - (l44 * l44)),
        a6: acceleration((dot(f40 - p42, f40 - p42)) - (l44 * l44)),
        r7: (distance(p42, f41)) - (l45),
        v7: velocity((distance(p42, f41)) - (l45)),
        a7: acceleration((distance(p42, f41)) - (l45))
    }
}
}
    position1(0): q4;
    motion1(0): q4, velocity0, acceleration0, jerk0;
    accuracy1(0): q4, e0, v0, m0, w0;
    position2(1): q47, q23, q46, p42, s38, s37, s36, margin;
    motion2(1): q47, velocity0, acceleration0, jerk0, q23, velocity1, acceleration1, jerk1, q46, velocity2, acceleration2, jerk2, p42, velocity3, acceleration3, jerk3;
    accuracy2(1): q47, e0, v0, m0, w0, q23, e1, v1, m1, w1, q46, e2, v2, m2, w2, p42, e3, v3, m3, w3;
    closure2(1): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5, r6, v6, a6, r7, v7, a7;
}

corpus! {
    m43 Generated43 [w4, f6.x, f6.y, l7, l9, f11.x, f11.y, f11.z, d12.x, d12.y, d12.z, l14, l15, f16.x, f16.y, f16.z]
    {
pub struct Generated43 {
    unit mm;
    input phi1 = 2.0490165rad;
    const l2 = 32.9813mm;
    let q3 = polar(l2, phi1);
    param w4 = 0.7669167rad;
    let g5 = w4 - phi1 / 2;
    param f6 = (35.4062mm, 0.0000mm);
    param l7 = 18.0026mm;
    let q8 = f6 + polar(l7, g5);
    param l9 = 37.3617mm;
    let q10 = (q3.x, q3.y, l9);
    param f11 = (-2.9607mm, 40.7949mm, 79.8780mm);
    param d12 = (0.6420549, -0.7404687, -0.1986745);
    unknown p13 = (37.1mm, 62.7mm, 27.1mm);
    param l14 = 62.9431mm;
    loop l14 = distance(p13, q10);
    param l15 = 69.8511mm;
    loop l15 = norm(p13 - f11);
    param f16 = (24.2817mm, 78.4592mm, 136.5326mm);
    const l17 = 1.0426mm;
    loop l17 = dot(unit(turn((0, 1, 0), d12, g5)), p13 - f16);
    let q18 = p13;
    let q19 = (q18.x, q18.y);
}

impl Generated43 {
    pub fn position1(phi1) -> Position1 {
        q19,
        q8,
        q18,
        p13,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q19,
        velocity0: velocity(q19),
        acceleration0: acceleration(q19),
        jerk0: jerk(q19),
        q8,
        velocity1: velocity(q8),
        acceleration1: acceleration(q8),
        jerk1: jerk(q8),
        q18,
        velocity2: velocity(q18),
        acceleration2: acceleration(q18),
        jerk2: jerk(q18),
        p13,
        velocity3: velocity(p13),
        acceleration3: acceleration(p13),
        jerk3: jerk(p13)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q19,
        e0: sensitivity(q19, [f11.y, f16.z]),
        v0: d(q19, phi1),
        m0: d(q19, phi1, f11.y),
        w0: d(q19, f11.y, f16.z),
        q8,
        e1: sensitivity(q8, [l14, f16.x]),
        v1: d(q8, phi1),
        m1: d(q8, phi1, l14),
        w1: d(q8, l14, f16.x),
        q18,
        e2: sensitivity(q18, [d12.y, f6.x]),
        v2: d(q18, phi1),
        m2: d(q18, phi1, d12.y),
        w2: d(q18, d12.y, f6.x),
        p13,
        e3: sensitivity(p13, [f16.z, f16.x]),
        v3: d(p13, phi1),
        m3: d(p13, phi1, f16.z),
        w3: d(p13, f16.z, f16.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (l14) - (distance(p13, q10)),
        v0: velocity((l14) - (distance(p13, q10))),
        a0: acceleration((l14) - (distance(p13, q10))),
        r1: (l15) - (norm(p13 - f11)),
        v1: velocity((l15) - (norm(p13 - f11))),
        a1: acceleration((l15) - (norm(p13 - f11))),
        r2: (l17) - (dot(unit(turn((0, 1, 0), d12, g5)), p13 - f16)),
        v2: velocity((l17) - (dot(unit(turn((0, 1, 0), d12, g5)), p13 - f16))),
        a2: acceleration((l17) - (dot(unit(turn((0, 1, 0), d12, g5)), p13 - f16)))
    }
}
}
    position1(0): q19, q8, q18, p13, margin;
    motion1(0): q19, velocity0, acceleration0, jerk0, q8, velocity1, acceleration1, jerk1, q18, velocity2, acceleration2, jerk2, p13, velocity3, acceleration3, jerk3;
    accuracy1(0): q19, e0, v0, m0, w0, q8, e1, v1, m1, w1, q18, e2, v2, m2, w2, p13, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m44 Generated44 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, l12, w14, f16.x, f16.y, d19.x, d19.y, d19.z, d20.x, d20.y, d20.z, w23, w24, f25.x, f25.y, f25.z, l26]
    {
pub struct Generated44 {
    unit m;
    input phi1 = 1.7435839rad in 1.7185839rad..1.7685839rad;
    input phi10 = 2.4731316rad in 2.4481316rad..2.4981316rad;
    param f2 = (38.5219mm, 5.3030mm);
    param l3 = 31.6698mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.9937381rad;
    let g6 = w5 - phi1;
    param f7 = (81.1573mm, 5.3030mm);
    param l8 = 39.8213mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    const f11 = (-36.9398mm, -3.7262mm);
    param l12 = 48.2140mm +- 20um;
    let q13 = f11 + polar(l12, phi10);
    param w14 = -0.3888047rad;
    let g15 = w14 - phi10;
    param f16 = (20.5278mm, -3.7262mm);
    const l17 = 33.7493mm;
    let q18 = f16 + polar(l17, g15);
    param d19 = (-0.2216737, -0.7833011, 0.5807755);
    param d20 = (0.2823662, -0.6942230, -0.6620602);
    const d21 = (0.4099071, 0.8905948, 0.1970205);
    unknown n22 = (0.89, 0.45, -0.08);
    loop dot(n22, n22) = 1;
    param w23 = 1.5757687rad;
    loop cos(w23) = dot(n22, unit(turn(d19, (1, 0, 0), phi10)));
    param w24 = 1.1501832rad;
    loop cos(w24) = dot(n22, unit(turn(d21, d20, g6)));
    param f25 = (-7.7945mm, -24.0298mm, -31.0131mm);
    param l26 = 55.5653mm;
    let q27 = f25 + l26 * n22;
}

impl Generated44 {
    pub fn position1(phi1) -> Position1 {
        q9,
        q4
    }
    pub fn motion1(phi1) -> Motion1 {
        q9,
        velocity0: velocity(q9),
        acceleration0: acceleration(q9),
        jerk0: jerk(q9),
        q4,
        velocity1: velocity(q4),
        acceleration1: acceleration(q4),
        jerk1: jerk(q4)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q9,
        e0: sensitivity(q9, [d19.z, d20.x]),
        v0: d(q9, phi1),
        m0: d(q9, phi1, d19.z),
        w0: d(q9, d19.z, d20.x),
        q4,
        e1: sensitivity(q4, [d19.z, f2.y]),
        v1: d(q4, phi1),
        m1: d(q4, phi1, d19.z),
        w1: d(q4, d19.z, f2.y)
    }
    pub fn position2(phi10) -> Position2 {
        q18,
        q13
    }
    pub fn motion2(phi10) -> Motion2 {
        q18,
        velocity0: velocity(q18),
        acceleration0: acceleration(q18),
        jerk0: jerk(q18),
        q13,
        velocity1: velocity(q13),
        acceleration1: acceleration(q13),
        jerk1: jerk(q13)
    }
    pub fn accuracy2(phi10) -> Accuracy2 {
        q18,
        e0: sensitivity(q18, [w14, f7.x]),
        v0: d(q18, phi10),
        m0: d(q18, phi10, w14),
        w0: d(q18, w14, f7.x),
        q13,
        e1: sensitivity(q13, [d20.z, f7.x]),
        v1: d(q13, phi10),
        m1: d(q13, phi10, d20.z),
        w1: d(q13, d20.z, f7.x)
    }
    pub fn position3(phi1, phi10) -> Position3 {
        q27,
        n22,
        margin: margin()
    }
    pub fn motion3(phi1, phi10) -> Motion3 {
        q27,
        velocity0: velocity(q27),
        acceleration0: acceleration(q27),
        n22,
        velocity1: velocity(n22),
        acceleration1: acceleration(n22)
    }
    pub fn accuracy3(phi1, phi10) -> Accuracy3 {
        q27,
        e0: sensitivity(q27, [f2.x, d20.y]),
        v0: d(q27, phi1),
        m0: d(q27, phi1, f2.x),
        w0: d(q27, f2.x, d20.y),
        n22,
        e1: sensitivity(n22, [f7.x, l26]),
        v1: d(n22, phi1),
        m1: d(n22, phi1, f7.x),
        w1: d(n22, f7.x, l26)
    }
    pub fn closure3(phi1, phi10) -> Closure3 {
        r0: (dot(n22, n22)) - (1),
        v0: velocity((dot(n22, n22)) - (1)),
        a0: acceleration((dot(n22, n22)) - (1)),
        r1: (cos(w23)) - (dot(n22, unit(turn(d19, (1, 0, 0), phi10)))),
        v1: velocity((cos(w23)) - (dot(n22, unit(turn(d19, (1, 0, 0), phi10))))),
        a1: acceleration((cos(w23)) - (dot(n22, unit(turn(d19, (1, 0, 0), phi10))))),
        r2: (cos(w24)) - (dot(n22, unit(turn(d21, d20, g6)))),
        v2: velocity((cos(w24)) - (dot(n22, unit(turn(d21, d20, g6))))),
        a2: acceleration((cos(w24)) - (dot(n22, unit(turn(d21, d20, g6)))))
    }
}
}
    position1(0): q9, q4;
    motion1(0): q9, velocity0, acceleration0, jerk0, q4, velocity1, acceleration1, jerk1;
    accuracy1(0): q9, e0, v0, m0, w0, q4, e1, v1, m1, w1;
    position2(1): q18, q13;
    motion2(1): q18, velocity0, acceleration0, jerk0, q13, velocity1, acceleration1, jerk1;
    accuracy2(1): q18, e0, v0, m0, w0, q13, e1, v1, m1, w1;
    position3(0, 1): q27, n22, margin;
    motion3(0, 1): q27, velocity0, acceleration0, n22, velocity1, acceleration1;
    accuracy3(0, 1): q27, e0, v0, m0, w0, n22, e1, v1, m1, w1;
    closure3(0, 1): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

/// The seed of each mechanism and the results of all its functions.
pub(crate) const ALL: &[(u64, crate::Results)] = &[
    (1, m1::results),
    (2, m2::results),
    (4, m4::results),
    (5, m5::results),
    (7, m7::results),
    (8, m8::results),
    (10, m10::results),
    (11, m11::results),
    (13, m13::results),
    (14, m14::results),
    (16, m16::results),
    (17, m17::results),
    (19, m19::results),
    (20, m20::results),
    (22, m22::results),
    (23, m23::results),
    (25, m25::results),
    (26, m26::results),
    (28, m28::results),
    (29, m29::results),
    (31, m31::results),
    (32, m32::results),
    (34, m34::results),
    (35, m35::results),
    (37, m37::results),
    (38, m38::results),
    (40, m40::results),
    (41, m41::results),
    (43, m43::results),
    (44, m44::results),
];

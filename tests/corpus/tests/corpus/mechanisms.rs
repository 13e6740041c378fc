//! Generated: `UPDATE=1 cargo test -p linkage-corpus --test corpus` writes it anew.

use crate::corpus;

corpus! {
    m0 Generated0 [l2, f5.x, f5.y, l6, w8, l14, w15]
    {
pub struct Generated0 {
    unit cm;
    input phi1 = 2.9199358rad in 2.8949358rad..2.9449358rad;
    input phi4 = 0.1483530rad in 0.1233530rad..0.1733530rad;
    param l2 = 20.7930mm +- 20um;
    let q3 = polar(l2, phi1);
    param f5 = (36.1625mm, -8.2826mm);
    param l6 = 42.8310mm;
    let q7 = f5 + polar(l6, phi4);
    param w8 = -0.7403586rad;
    const l9 = 85.0007mm;
    const l10 = -31.9190mm;
    unknown t11 = -87deg;
    unknown s12 = -133.7mm;
    loop q3 + polar(s12, phi1 + w8) + polar(l10, phi1 + w8 + 90deg) = q7 + polar(l9, t11);
    let q13 = q7 + polar(l9, t11);
    param l14 = 36.4153mm;
    param w15 = -0.1704342rad;
    let q16 = q7 + polar(l14, t11 + w15);
}

impl Generated0 {
    pub fn position1(phi1) -> Position1 {
        q3
    }
    pub fn motion1(phi1) -> Motion1 {
        q3,
        velocity0: velocity(q3),
        acceleration0: acceleration(q3),
        jerk0: jerk(q3)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q3,
        e0: sensitivity(q3, [l14, w15]),
        v0: d(q3, phi1),
        m0: d(q3, phi1, l14),
        w0: d(q3, l14, w15)
    }
    pub fn position2(phi4) -> Position2 {
        q7
    }
    pub fn motion2(phi4) -> Motion2 {
        q7,
        velocity0: velocity(q7),
        acceleration0: acceleration(q7),
        jerk0: jerk(q7)
    }
    pub fn accuracy2(phi4) -> Accuracy2 {
        q7,
        e0: sensitivity(q7, [l6, f5.x]),
        v0: d(q7, phi4),
        m0: d(q7, phi4, l6),
        w0: d(q7, l6, f5.x)
    }
    pub fn position3(phi1, phi4) -> Position3 {
        q16,
        q13,
        s12,
        t11,
        margin: margin()
    }
    pub fn motion3(phi1, phi4) -> Motion3 {
        q16,
        velocity0: velocity(q16),
        acceleration0: acceleration(q16),
        q13,
        velocity1: velocity(q13),
        acceleration1: acceleration(q13),
        s12,
        velocity2: velocity(s12),
        acceleration2: acceleration(s12),
        t11,
        velocity3: velocity(t11),
        acceleration3: acceleration(t11)
    }
    pub fn accuracy3(phi1, phi4) -> Accuracy3 {
        q16,
        e0: sensitivity(q16, [l6, l2]),
        v0: d(q16, phi1),
        m0: d(q16, phi1, l6),
        w0: d(q16, l6, l2),
        q13,
        e1: sensitivity(q13, [l14, l2]),
        v1: d(q13, phi1),
        m1: d(q13, phi1, l14),
        w1: d(q13, l14, l2),
        s12,
        e2: sensitivity(s12, [w15, f5.y]),
        v2: d(s12, phi1),
        m2: d(s12, phi1, w15),
        w2: d(s12, w15, f5.y),
        t11,
        e3: sensitivity(t11, [f5.x, w15]),
        v3: d(t11, phi1),
        m3: d(t11, phi1, f5.x),
        w3: d(t11, f5.x, w15)
    }
    pub fn closure3(phi1, phi4) -> Closure3 {
        r0: (q3 + polar(s12, phi1 + w8) + polar(l10, phi1 + w8 + 90deg)) - (q7 + polar(l9, t11)),
        v0: velocity((q3 + polar(s12, phi1 + w8) + polar(l10, phi1 + w8 + 90deg)) - (q7 + polar(l9, t11))),
        a0: acceleration((q3 + polar(s12, phi1 + w8) + polar(l10, phi1 + w8 + 90deg)) - (q7 + polar(l9, t11)))
    }
}
}
    position1(0): q3;
    motion1(0): q3, velocity0, acceleration0, jerk0;
    accuracy1(0): q3, e0, v0, m0, w0;
    position2(1): q7;
    motion2(1): q7, velocity0, acceleration0, jerk0;
    accuracy2(1): q7, e0, v0, m0, w0;
    position3(0, 1): q16, q13, s12, t11, margin;
    motion3(0, 1): q16, velocity0, acceleration0, q13, velocity1, acceleration1, s12, velocity2, acceleration2, t11, velocity3, acceleration3;
    accuracy3(0, 1): q16, e0, v0, m0, w0, q13, e1, v1, m1, w1, s12, e2, v2, m2, w2, t11, e3, v3, m3, w3;
    closure3(0, 1): r0, v0, a0;
}

corpus! {
    m3 Generated3 [f2.x, f2.y, l3, f5.x, f5.y, l6, l9, l11, w12]
    {
pub struct Generated3 {
    unit mm;
    input phi1 = -2.6476645rad;
    param f2 = (-30.9240mm, 16.0235mm);
    param l3 = 38.3892mm;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (-90.6455mm, 87.1831mm);
    param l6 = 66.2647mm +- 20um;
    unknown t7 = 75deg;
    unknown t8 = -30deg;
    param l9 = 50.4270mm;
    loop q4 + polar(l6, t7) = f5 + polar(l9, t8);
    let q10 = q4 + polar(l6, t7);
    param l11 = 45.6487mm;
    param w12 = 1.8596540rad;
    let q13 = q4 + polar(l11, t7 + w12);
}

impl Generated3 {
    pub fn position1(phi1) -> Position1 {
        q13,
        q10,
        t8,
        t7,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q13,
        velocity0: velocity(q13),
        acceleration0: acceleration(q13),
        jerk0: jerk(q13),
        q10,
        velocity1: velocity(q10),
        acceleration1: acceleration(q10),
        jerk1: jerk(q10),
        t8,
        velocity2: velocity(t8),
        acceleration2: acceleration(t8),
        jerk2: jerk(t8),
        t7,
        velocity3: velocity(t7),
        acceleration3: acceleration(t7),
        jerk3: jerk(t7)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q13,
        e0: sensitivity(q13, [l11, f2.y]),
        v0: d(q13, phi1),
        m0: d(q13, phi1, l11),
        w0: d(q13, l11, f2.y),
        q10,
        e1: sensitivity(q10, [w12, f2.x]),
        v1: d(q10, phi1),
        m1: d(q10, phi1, w12),
        w1: d(q10, w12, f2.x),
        t8,
        e2: sensitivity(t8, [w12, f2.x]),
        v2: d(t8, phi1),
        m2: d(t8, phi1, w12),
        w2: d(t8, w12, f2.x),
        t7,
        e3: sensitivity(t7, [l9, l11]),
        v3: d(t7, phi1),
        m3: d(t7, phi1, l9),
        w3: d(t7, l9, l11)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q4 + polar(l6, t7)) - (f5 + polar(l9, t8)),
        v0: velocity((q4 + polar(l6, t7)) - (f5 + polar(l9, t8))),
        a0: acceleration((q4 + polar(l6, t7)) - (f5 + polar(l9, t8)))
    }
}
}
    position1(0): q13, q10, t8, t7, margin;
    motion1(0): q13, velocity0, acceleration0, jerk0, q10, velocity1, acceleration1, jerk1, t8, velocity2, acceleration2, jerk2, t7, velocity3, acceleration3, jerk3;
    accuracy1(0): q13, e0, v0, m0, w0, q10, e1, v1, m1, w1, t8, e2, v2, m2, w2, t7, e3, v3, m3, w3;
    closure1(0): r0, v0, a0;
}

corpus! {
    m6 Generated6 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, w10, l12, w14, l15, l16, f20.x, f20.y, l22]
    {
pub struct Generated6 {
    unit mm;
    input phi1 = -2.4452063rad in -2.4507618rad..-2.4396507rad;
    param f2 = (19.1854mm, -4.2949mm);
    param l3 = 21.6903mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.8174900rad;
    let g6 = w5 - phi1;
    param f7 = (64.1278mm, -4.2949mm);
    param l8 = 37.1868mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    param w10 = -3.0281681rad;
    unknown s11 = 42.1mm;
    param l12 = 67.9997mm;
    loop l12 = distance(q9, q4 + polar(s11, w10));
    let q13 = q4 + polar(s11, w10);
    param w14 = -2.7534926rad;
    param l15 = 64.4067mm;
    param l16 = -37.1258mm;
    unknown t17 = 179deg;
    unknown s18 = 99.6mm;
    loop q4 + dir(w14) * s18 + l16 * dir(90deg + w14) = q13 + polar(l15, t17);
    let q19 = q13 + polar(l15, t17);
    param f20 = (11.6140mm, -25.5168mm);
    const l21 = 86.7923mm;
    param l22 = -2.7808mm;
    unknown t23 = 56deg;
    unknown s24 = -74.8mm;
    loop f20 + polar(s24, (-90deg)) + polar(l22, (-90deg) + 90deg) = q13 + polar(l21, t23);
    let q25 = q13 + polar(l21, t23);
}

impl Generated6 {
    pub fn position1(phi1) -> Position1 {
        q25,
        q19,
        s24,
        t23,
        s18,
        t17,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q25,
        velocity0: velocity(q25),
        acceleration0: acceleration(q25),
        jerk0: jerk(q25),
        q19,
        velocity1: velocity(q19),
        acceleration1: acceleration(q19),
        jerk1: jerk(q19),
        s24,
        velocity2: velocity(s24),
        acceleration2: acceleration(s24),
        jerk2: jerk(s24),
        t23,
        velocity3: velocity(t23),
        acceleration3: acceleration(t23),
        jerk3: jerk(t23)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q25,
        e0: sensitivity(q25, [l12, f20.x]),
        v0: d(q25, phi1),
        m0: d(q25, phi1, l12),
        w0: d(q25, l12, f20.x),
        q19,
        e1: sensitivity(q19, [l16, l12]),
        v1: d(q19, phi1),
        m1: d(q19, phi1, l16),
        w1: d(q19, l16, l12),
        s24,
        e2: sensitivity(s24, [w14, f7.y]),
        v2: d(s24, phi1),
        m2: d(s24, phi1, w14),
        w2: d(s24, w14, f7.y),
        t23,
        e3: sensitivity(t23, [l12, f7.y]),
        v3: d(t23, phi1),
        m3: d(t23, phi1, l12),
        w3: d(t23, l12, f7.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (l12) - (distance(q9, q4 + polar(s11, w10))),
        v0: velocity((l12) - (distance(q9, q4 + polar(s11, w10)))),
        a0: acceleration((l12) - (distance(q9, q4 + polar(s11, w10)))),
        r1: (q4 + dir(w14) * s18 + l16 * dir(90deg + w14)) - (q13 + polar(l15, t17)),
        v1: velocity((q4 + dir(w14) * s18 + l16 * dir(90deg + w14)) - (q13 + polar(l15, t17))),
        a1: acceleration((q4 + dir(w14) * s18 + l16 * dir(90deg + w14)) - (q13 + polar(l15, t17))),
        r2: (f20 + polar(s24, (-90deg)) + polar(l22, (-90deg) + 90deg)) - (q13 + polar(l21, t23)),
        v2: velocity((f20 + polar(s24, (-90deg)) + polar(l22, (-90deg) + 90deg)) - (q13 + polar(l21, t23))),
        a2: acceleration((f20 + polar(s24, (-90deg)) + polar(l22, (-90deg) + 90deg)) - (q13 + polar(l21, t23)))
    }
}
}
    position1(0): q25, q19, s24, t23, s18, t17, margin;
    motion1(0): q25, velocity0, acceleration0, jerk0, q19, velocity1, acceleration1, jerk1, s24, velocity2, acceleration2, jerk2, t23, velocity3, acceleration3, jerk3;
    accuracy1(0): q25, e0, v0, m0, w0, q19, e1, v1, m1, w1, s24, e2, v2, m2, w2, t23, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m9 Generated9 [l3, w5, f7.x, f7.y, l8, f10.x, f10.y, l11, l14, w15]
    {
pub struct Generated9 {
    unit mm;
    input phi1 = 1.7662732rad in 1.7162732rad..1.8162732rad;
    const f2 = (14.5890mm, 20.0556mm);
    param l3 = 27.9597mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.5783220rad;
    let g6 = 2 * phi1 + w5;
    param f7 = (51.0321mm, 20.0556mm);
    param l8 = 21.0080mm;
    let q9 = f7 + polar(l8, g6);
    param f10 = (64.5897mm, -7.5678mm);
    param l11 = 10.4840mm;
    unknown t12 = 127deg;
    unknown s13 = 77.4mm;
    loop q4 = f10 + polar(s13, t12) + polar(l11, t12 + 90deg);
    param l14 = 22.3148mm;
    param w15 = 1.7666917rad;
    let q16 = f10 + polar(l14, t12 + w15);
}

impl Generated9 {
    pub fn position1(phi1) -> Position1 {
        q16,
        q9,
        s13,
        t12,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q16,
        velocity0: velocity(q16),
        acceleration0: acceleration(q16),
        jerk0: jerk(q16),
        q9,
        velocity1: velocity(q9),
        acceleration1: acceleration(q9),
        jerk1: jerk(q9),
        s13,
        velocity2: velocity(s13),
        acceleration2: acceleration(s13),
        jerk2: jerk(s13),
        t12,
        velocity3: velocity(t12),
        acceleration3: acceleration(t12),
        jerk3: jerk(t12)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q16,
        e0: sensitivity(q16, [f7.y, f7.x]),
        v0: d(q16, phi1),
        m0: d(q16, phi1, f7.y),
        w0: d(q16, f7.y, f7.x),
        q9,
        e1: sensitivity(q9, [l11, f7.y]),
        v1: d(q9, phi1),
        m1: d(q9, phi1, l11),
        w1: d(q9, l11, f7.y),
        s13,
        e2: sensitivity(s13, [l14, f7.x]),
        v2: d(s13, phi1),
        m2: d(s13, phi1, l14),
        w2: d(s13, l14, f7.x),
        t12,
        e3: sensitivity(t12, [w15, f10.y]),
        v3: d(t12, phi1),
        m3: d(t12, phi1, w15),
        w3: d(t12, w15, f10.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q4) - (f10 + polar(s13, t12) + polar(l11, t12 + 90deg)),
        v0: velocity((q4) - (f10 + polar(s13, t12) + polar(l11, t12 + 90deg))),
        a0: acceleration((q4) - (f10 + polar(s13, t12) + polar(l11, t12 + 90deg)))
    }
}
}
    position1(0): q16, q9, s13, t12, margin;
    motion1(0): q16, velocity0, acceleration0, jerk0, q9, velocity1, acceleration1, jerk1, s13, velocity2, acceleration2, jerk2, t12, velocity3, acceleration3, jerk3;
    accuracy1(0): q16, e0, v0, m0, w0, q9, e1, v1, m1, w1, s13, e2, v2, m2, w2, t12, e3, v3, m3, w3;
    closure1(0): r0, v0, a0;
}

corpus! {
    m12 Generated12 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, l10, l12, w14, l16, l20, w21, f23.x, f23.y, l24, l27, l29, w30, f32.x, f32.y, l33, l36, w37, l40, l41]
    {
pub struct Generated12 {
    unit mm;
    input phi1 = 2.5097835rad in 2.5091662rad..2.5104007rad;
    param f2 = (6.3281mm, 35.1571mm);
    param l3 = 27.0422mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = -0.7198971rad;
    let g6 = w5 - phi1;
    param f7 = (56.6271mm, 35.1571mm);
    param l8 = 16.6753mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    param l10 = 63.6417mm;
    unknown t11 = 101deg;
    param l12 = 64.9188mm;
    loop distance(q9 + polar(l10, t11), q4) = l12;
    let q13 = q9 + polar(l10, t11);
    param w14 = 1.1177218rad;
    const l15 = 55.6646mm;
    param l16 = 27.4117mm +- 20um;
    unknown t17 = 119deg;
    unknown s18 = 94.1mm;
    loop q4 + rotate((s18, l16), w14) = q13 + polar(l15, t17);
    let q19 = q13 + polar(l15, t17);
    param l20 = 52.5533mm +- 20um;
    param w21 = 0.1093701rad;
    let q22 = q13 + polar(l20, t17 + w21);
    param f23 = (-26.6492mm, 188.1922mm);
    param l24 = 31.8407mm +- 20um;
    unknown t25 = 39deg;
    unknown t26 = -28deg;
    param l27 = 55.6661mm +- 20um;
    loop polar(l24, t25) - l27 * dir(t26) = f23 - q22;
    let q28 = q22 + polar(l24, t25);
    param l29 = 21.3850mm;
    param w30 = -0.1509197rad;
    let q31 = q22 + polar(l29, t25 + w30);
    param f32 = (-29.2394mm, 190.9318mm);
    param l33 = 23.5978mm;
    unknown t34 = -53deg;
    unknown s35 = 54.4mm;
    loop f32 + s35 * dir(t34) - polar(l33, t34 - 90deg) = q28;
    param l36 = 42.7826mm +- 20um;
    param w37 = -0.7904126rad;
    let q38 = f32 + polar(l36, t34 + w37);
    unknown p39 = (52.8mm, 113.4mm);
    param l40 = 94.7629mm +- 20um;
    loop l40 = norm(q38 - p39);
    param l41 = 77.8404mm;
    loop norm(q9 - p39) = l41;
    let q42 = p39;
}

impl Generated12 {
    pub fn position1(phi1) -> Position1 {
        q42,
        q38,
        p39,
        s35,
        t34,
        t26,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q42,
        velocity0: velocity(q42),
        acceleration0: acceleration(q42),
        jerk0: jerk(q42),
        q38,
        velocity1: velocity(q38),
        acceleration1: acceleration(q38),
        jerk1: jerk(q38),
        p39,
        velocity2: velocity(p39),
        acceleration2: acceleration(p39),
        jerk2: jerk(p39),
        s35,
        velocity3: velocity(s35),
        acceleration3: acceleration(s35),
        jerk3: jerk(s35)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q42,
        e0: sensitivity(q42, [l10, f7.y]),
        v0: d(q42, phi1),
        m0: d(q42, phi1, l10),
        w0: d(q42, l10, f7.y),
        q38,
        e1: sensitivity(q38, [f23.x, w5]),
        v1: d(q38, phi1),
        m1: d(q38, phi1, f23.x),
        w1: d(q38, f23.x, w5),
        p39,
        e2: sensitivity(p39, [l27, l10]),
        v2: d(p39, phi1),
        m2: d(p39, phi1, l27),
        w2: d(p39, l27, l10),
        s35,
        e3: sensitivity(s35, [l36, w21]),
        v3: d(s35, phi1),
        m3: d(s35, phi1, l36),
        w3: d(s35, l36, w21)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (distance(q9 + polar(l10, t11), q4)) - (l12),
        v0: velocity((distance(q9 + polar(l10, t11), q4)) - (l12)),
        a0: acceleration((distance(q9 + polar(l10, t11), q4)) - (l12)),
        r1: (q4 + rotate((s18, l16), w14)) - (q13 + polar(l15, t17)),
        v1: velocity((q4 + rotate((s18, l16), w14)) - (q13 + polar(l15, t17))),
        a1: acceleration((q4 + rotate((s18, l16), w14)) - (q13 + polar(l15, t17))),
        r2: (polar(l24, t25) - l27 * dir(t26)) - (f23 - q22),
        v2: velocity((polar(l24, t25) - l27 * dir(t26)) - (f23 - q22)),
        a2: acceleration((polar(l24, t25) - l27 * dir(t26)) - (f23 - q22)),
        r3: (f32 + s35 * dir(t34) - polar(l33, t34 - 90deg)) - (q28),
        v3: velocity((f32 + s35 * dir(t34) - polar(l33, t34 - 90deg)) - (q28)),
        a3: acceleration((f32 + s35 * dir(t34) - polar(l33, t34 - 90deg)) - (q28)),
        r4: (l40) - (norm(q38 - p39)),
        v4: velocity((l40) - (norm(q38 - p39))),
        a4: acceleration((l40) - (norm(q38 - p39))),
        r5: (norm(q9 - p39)) - (l41),
        v5: velocity((norm(q9 - p39)) - (l41)),
        a5: acceleration((norm(q9 - p39)) - (l41))
    }
}
}
    position1(0): q42, q38, p39, s35, t34, t26, margin;
    motion1(0): q42, velocity0, acceleration0, jerk0, q38, velocity1, acceleration1, jerk1, p39, velocity2, acceleration2, jerk2, s35, velocity3, acceleration3, jerk3;
    accuracy1(0): q42, e0, v0, m0, w0, q38, e1, v1, m1, w1, p39, e2, v2, m2, w2, s35, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m15 Generated15 [l2, f4.x, f4.y, f5.x, f5.y, w6, l7, w16, l18, l21, l23, w24]
    {
pub struct Generated15 {
    unit m;
    input phi1 = -1.7610372rad in -1.7665928rad..-1.7554817rad;
    param l2 = 36.8154mm;
    let q3 = polar(l2, phi1);
    param f4 = (28.7938mm, -80.6639mm);
    param f5 = (-49.6313mm, -113.7041mm);
    param w6 = -0.8845081rad;
    param l7 = 97.2876mm +- 20um;
    const l8 = 7.6287mm;
    unknown t9 = -101deg;
    unknown s10 = 29.6mm;
    loop f5 + rotate((s10, l8), w6) = q3 + polar(l7, t9);
    let q11 = q3 + polar(l7, t9);
    const f12 = (-10.4691mm, -211.3202mm);
    unknown t13 = -101deg;
    unknown s14 = 97.3mm;
    loop q3 + polar(s14, t13) = q11;
    const l15 = 55.9666mm;
    param w16 = -1.4347599rad;
    let q17 = q3 + polar(l15, t13 + w16);
    param l18 = 44.7509mm;
    unknown t19 = -152deg;
    unknown t20 = -55deg;
    param l21 = 28.7032mm +- 20um;
    loop q17 + polar(l21, t20) = q3 + polar(l18, t19);
    let q22 = q3 + polar(l18, t19);
    param l23 = 29.0671mm;
    param w24 = -2.3488688rad;
    let q25 = q3 + polar(l23, t19 + w24);
}

impl Generated15 {
    pub fn position1(phi1) -> Position1 {
        q25,
        q22,
        t20,
        t19,
        s14,
        t13,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q25,
        velocity0: velocity(q25),
        acceleration0: acceleration(q25),
        jerk0: jerk(q25),
        q22,
        velocity1: velocity(q22),
        acceleration1: acceleration(q22),
        jerk1: jerk(q22),
        t20,
        velocity2: velocity(t20),
        acceleration2: acceleration(t20),
        jerk2: jerk(t20),
        t19,
        velocity3: velocity(t19),
        acceleration3: acceleration(t19),
        jerk3: jerk(t19)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q25,
        e0: sensitivity(q25, [f4.x, l7]),
        v0: d(q25, phi1),
        m0: d(q25, phi1, f4.x),
        w0: d(q25, f4.x, l7),
        q22,
        e1: sensitivity(q22, [w6, f5.x]),
        v1: d(q22, phi1),
        m1: d(q22, phi1, w6),
        w1: d(q22, w6, f5.x),
        t20,
        e2: sensitivity(t20, [w16, w24]),
        v2: d(t20, phi1),
        m2: d(t20, phi1, w16),
        w2: d(t20, w16, w24),
        t19,
        e3: sensitivity(t19, [w6, l2]),
        v3: d(t19, phi1),
        m3: d(t19, phi1, w6),
        w3: d(t19, w6, l2)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f5 + rotate((s10, l8), w6)) - (q3 + polar(l7, t9)),
        v0: velocity((f5 + rotate((s10, l8), w6)) - (q3 + polar(l7, t9))),
        a0: acceleration((f5 + rotate((s10, l8), w6)) - (q3 + polar(l7, t9))),
        r1: (q3 + polar(s14, t13)) - (q11),
        v1: velocity((q3 + polar(s14, t13)) - (q11)),
        a1: acceleration((q3 + polar(s14, t13)) - (q11)),
        r2: (q17 + polar(l21, t20)) - (q3 + polar(l18, t19)),
        v2: velocity((q17 + polar(l21, t20)) - (q3 + polar(l18, t19))),
        a2: acceleration((q17 + polar(l21, t20)) - (q3 + polar(l18, t19)))
    }
}
}
    position1(0): q25, q22, t20, t19, s14, t13, margin;
    motion1(0): q25, velocity0, acceleration0, jerk0, q22, velocity1, acceleration1, jerk1, t20, velocity2, acceleration2, jerk2, t19, velocity3, acceleration3, jerk3;
    accuracy1(0): q25, e0, v0, m0, w0, q22, e1, v1, m1, w1, t20, e2, v2, m2, w2, t19, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m18 Generated18 [l2, w4, f6.x, f6.y, f9.x, f9.y, w11, w13, l14, w16, l19, f22.x, f22.y, l23, l25, l28, w30, l31, f33.x, f33.y, w34, l36, l40, w41]
    {
pub struct Generated18 {
    unit mm;
    input phi1 = 1.2618730rad in 1.2612558rad..1.2624903rad;
    param l2 = 32.9159mm;
    let q3 = polar(l2, phi1);
    param w4 = 0.4208151rad;
    let g5 = w4 - phi1;
    param f6 = (41.6924mm, 0.0000mm);
    const l7 = 35.7057mm;
    let q8 = f6 + polar(l7, g5);
    param f9 = (31.2065mm, 115.5208mm);
    const f10 = (27.7416mm, 54.5288mm);
    param w11 = -0.3486382rad;
    unknown s12 = 51.2mm;
    param w13 = 0.3219578rad;
    param l14 = 50.2464mm;
    loop l14 = dot(q8 + polar(s12, w11) - f10, dir(w13));
    let q15 = q8 + polar(s12, w11);
    param w16 = 1.5919010rad;
    unknown t17 = 308deg;
    loop t17 = 3 * (phi1) + w16;
    const f18 = (0.0000mm, 0.0000mm);
    param l19 = 21.0100mm +- 20um;
    unknown p20 = (13.0mm, -16.5mm);
    loop f18 + polar(l19, t17) = p20;
    let q21 = p20;
    param f22 = (61.4598mm, 42.7680mm);
    param l23 = 36.0806mm;
    unknown t24 = 129deg;
    param l25 = 45.4497mm +- 20um;
    loop l25 = distance(q8 + polar(l23, t24), f22);
    let q26 = q8 + polar(l23, t24);
    const f27 = (94.5401mm, -68.3229mm);
    param l28 = 63.6196mm;
    unknown t29 = -160deg;
    param w30 = -1.7555018rad;
    param l31 = -26.9074mm;
    loop dot(dir(w30), q26 + polar(l28, t29) - f27) = l31;
    let q32 = q26 + polar(l28, t29);
    param f33 = (31.2374mm, -123.2843mm);
    param w34 = -2.6300126rad;
    const l35 = 106.4025mm;
    param l36 = -10.6323mm;
    unknown t37 = -30deg;
    unknown s38 = -90.8mm;
    loop f33 + polar(s38, w34) + polar(l36, w34 + 90deg) = q21 + polar(l35, t37);
    let q39 = q21 + polar(l35, t37);
    param l40 = 22.0081mm;
    param w41 = -1.0255213rad;
    let q42 = q21 + polar(l40, t37 + w41);
}

impl Generated18 {
    pub fn position1(phi1) -> Position1 {
        q42,
        q39,
        s38,
        t37,
        t29,
        t24,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q42,
        velocity0: velocity(q42),
        acceleration0: acceleration(q42),
        jerk0: jerk(q42),
        q39,
        velocity1: velocity(q39),
        acceleration1: acceleration(q39),
        jerk1: jerk(q39),
        s38,
        velocity2: velocity(s38),
        acceleration2: acceleration(s38),
        jerk2: jerk(s38),
        t37,
        velocity3: velocity(t37),
        acceleration3: acceleration(t37),
        jerk3: jerk(t37)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q42,
        e0: sensitivity(q42, [l2, w16]),
        v0: d(q42, phi1),
        m0: d(q42, phi1, l2),
        w0: d(q42, l2, w16),
        q39,
        e1: sensitivity(q39, [f9.x, f6.x]),
        v1: d(q39, phi1),
        m1: d(q39, phi1, f9.x),
        w1: d(q39, f9.x, f6.x),
        s38,
        e2: sensitivity(s38, [w11, l31]),
        v2: d(s38, phi1),
        m2: d(s38, phi1, w11),
        w2: d(s38, w11, l31),
        t37,
        e3: sensitivity(t37, [f33.x, w34]),
        v3: d(t37, phi1),
        m3: d(t37, phi1, f33.x),
        w3: d(t37, f33.x, w34)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (l14) - (dot(q8 + polar(s12, w11) - f10, dir(w13))),
        v0: velocity((l14) - (dot(q8 + polar(s12, w11) - f10, dir(w13)))),
        a0: acceleration((l14) - (dot(q8 + polar(s12, w11) - f10, dir(w13)))),
        r1: (l25) - (distance(q8 + polar(l23, t24), f22)),
        v1: velocity((l25) - (distance(q8 + polar(l23, t24), f22))),
        a1: acceleration((l25) - (distance(q8 + polar(l23, t24), f22))),
        r2: (dot(dir(w30), q26 + polar(l28, t29) - f27)) - (l31),
        v2: velocity((dot(dir(w30), q26 + polar(l28, t29) - f27)) - (l31)),
        a2: acceleration((dot(dir(w30), q26 + polar(l28, t29) - f27)) - (l31)),
        r3: (f33 + polar(s38, w34) + polar(l36, w34 + 90deg)) - (q21 + polar(l35, t37)),
        v3: velocity((f33 + polar(s38, w34) + polar(l36, w34 + 90deg)) - (q21 + polar(l35, t37))),
        a3: acceleration((f33 + polar(s38, w34) + polar(l36, w34 + 90deg)) - (q21 + polar(l35, t37)))
    }
}
}
    position1(0): q42, q39, s38, t37, t29, t24, margin;
    motion1(0): q42, velocity0, acceleration0, jerk0, q39, velocity1, acceleration1, jerk1, s38, velocity2, acceleration2, jerk2, t37, velocity3, acceleration3, jerk3;
    accuracy1(0): q42, e0, v0, m0, w0, q39, e1, v1, m1, w1, s38, e2, v2, m2, w2, t37, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3;
}

corpus! {
    m21 Generated21 [l2, w4, f6.x, f6.y, l7, f9.x, f9.y, w10, l11, l12, l16, w17, l19, l22, w23, w25, w26]
    {
pub struct Generated21 {
    unit mm;
    input phi1 = 0.9372418rad;
    param l2 = 35.7492mm;
    let q3 = polar(l2, phi1);
    param w4 = -0.2830364rad;
    let g5 = w4 - phi1;
    param f6 = (52.8276mm, 0.0000mm);
    param l7 = 31.4290mm;
    let q8 = f6 + polar(l7, g5);
    param f9 = (39.3965mm, -99.9607mm);
    param w10 = 0.4737189rad;
    param l11 = 73.8067mm +- 20um;
    param l12 = 21.4169mm;
    unknown t13 = 3deg;
    unknown s14 = 121.0mm;
    loop q8 + polar(l11, t13) = f9 + dir(w10) * s14 + l12 * dir(90deg + w10);
    let q15 = q8 + polar(l11, t13);
    param l16 = 58.9041mm +- 20um;
    param w17 = -2.3337954rad;
    let q18 = q8 + polar(l16, t13 + w17);
    param l19 = 35.2444mm;
    unknown t20 = -68deg;
    unknown s21 = -96.8mm;
    loop q3 = q18 + s21 * dir(t20) - polar(l19, t20 - 90deg);
    param l22 = 52.8489mm;
    param w23 = 0.5892108rad;
    let q24 = q18 + polar(l22, t20 + w23);
    param w25 = 2.0113124rad;
    param w26 = 0.5574351rad;
    unknown s27 = 36.0mm;
    unknown s28 = 68.8mm;
    loop q8 + polar(s28, w26) = q15 + polar(s27, w25);
    let q29 = q15 + polar(s27, w25);
}

impl Generated21 {
    pub fn position1(phi1) -> Position1 {
        q29,
        q24,
        s28,
        s27,
        s21,
        t20,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q29,
        velocity0: velocity(q29),
        acceleration0: acceleration(q29),
        jerk0: jerk(q29),
        q24,
        velocity1: velocity(q24),
        acceleration1: acceleration(q24),
        jerk1: jerk(q24),
        s28,
        velocity2: velocity(s28),
        acceleration2: acceleration(s28),
        jerk2: jerk(s28),
        s27,
        velocity3: velocity(s27),
        acceleration3: acceleration(s27),
        jerk3: jerk(s27)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q29,
        e0: sensitivity(q29, [w4, l7]),
        v0: d(q29, phi1),
        m0: d(q29, phi1, w4),
        w0: d(q29, w4, l7),
        q24,
        e1: sensitivity(q24, [f9.x, l16]),
        v1: d(q24, phi1),
        m1: d(q24, phi1, f9.x),
        w1: d(q24, f9.x, l16),
        s28,
        e2: sensitivity(s28, [f9.x, l11]),
        v2: d(s28, phi1),
        m2: d(s28, phi1, f9.x),
        w2: d(s28, f9.x, l11),
        s27,
        e3: sensitivity(s27, [w17, f9.x]),
        v3: d(s27, phi1),
        m3: d(s27, phi1, w17),
        w3: d(s27, w17, f9.x)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q8 + polar(l11, t13)) - (f9 + dir(w10) * s14 + l12 * dir(90deg + w10)),
        v0: velocity((q8 + polar(l11, t13)) - (f9 + dir(w10) * s14 + l12 * dir(90deg + w10))),
        a0: acceleration((q8 + polar(l11, t13)) - (f9 + dir(w10) * s14 + l12 * dir(90deg + w10))),
        r1: (q3) - (q18 + s21 * dir(t20) - polar(l19, t20 - 90deg)),
        v1: velocity((q3) - (q18 + s21 * dir(t20) - polar(l19, t20 - 90deg))),
        a1: acceleration((q3) - (q18 + s21 * dir(t20) - polar(l19, t20 - 90deg))),
        r2: (q8 + polar(s28, w26)) - (q15 + polar(s27, w25)),
        v2: velocity((q8 + polar(s28, w26)) - (q15 + polar(s27, w25))),
        a2: acceleration((q8 + polar(s28, w26)) - (q15 + polar(s27, w25)))
    }
}
}
    position1(0): q29, q24, s28, s27, s21, t20, margin;
    motion1(0): q29, velocity0, acceleration0, jerk0, q24, velocity1, acceleration1, jerk1, s28, velocity2, acceleration2, jerk2, s27, velocity3, acceleration3, jerk3;
    accuracy1(0): q29, e0, v0, m0, w0, q24, e1, v1, m1, w1, s28, e2, v2, m2, w2, s27, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m24 Generated24 [f2.x, f2.y, l3, w6, f7.x, f7.y, l11, f13.x, f13.y, w14, l15, l16, l20, w21, w24, l25, l26, l30, w31, l33, l36, w38, w39]
    {
pub struct Generated24 {
    unit mm;
    input phi1 = 0.4084070rad in 0.4077898rad..0.4090243rad;
    param f2 = (13.3701mm, 11.6925mm);
    param l3 = 20.8371mm;
    let q4 = f2 + polar(l3, phi1);
    const f5 = (110.9538mm, 76.3216mm);
    param w6 = -0.8841865rad;
    param f7 = (98.5953mm, 26.1814mm);
    const l8 = 121.9573mm;
    unknown t9 = -51deg;
    unknown t10 = -84deg;
    param l11 = 101.4941mm;
    loop polar(l8, t9) - l11 * dir(t10) = f7 - q4;
    let q12 = q4 + polar(l8, t9);
    param f13 = (140.1681mm, -117.3313mm);
    param w14 = 1.1911778rad;
    param l15 = 47.3234mm;
    param l16 = 11.1596mm +- 20um;
    unknown t17 = -67deg;
    unknown s18 = -5.5mm;
    loop q12 + polar(l15, t17) = f13 + rotate((s18, l16), w14);
    let q19 = q12 + polar(l15, t17);
    param l20 = 39.4391mm;
    param w21 = 0.4725950rad;
    let q22 = q12 + polar(l20, t17 + w21);
    const f23 = (145.0952mm, -45.6804mm);
    param w24 = 0.5311038rad;
    param l25 = 95.4907mm;
    param l26 = 12.1520mm;
    unknown t27 = 78deg;
    unknown s28 = 39.6mm;
    loop q22 + polar(l25, t27) = f23 + rotate((s28, l26), phi1 + w24);
    let q29 = q22 + polar(l25, t27);
    param l30 = 28.8730mm +- 20um;
    param w31 = 1.4207860rad;
    let q32 = q22 + polar(l30, t27 + w31);
    param l33 = 99.9082mm;
    unknown t34 = -150deg;
    unknown t35 = 147deg;
    param l36 = -79.5671mm;
    loop q29 + polar(l33, t34) = q22 + polar((-l36), t35);
    let q37 = q29 + polar(l33, t34);
    param w38 = -1.5890420rad;
    param w39 = -0.9439259rad;
    unknown s40 = -21.3mm;
    unknown s41 = 68.9mm;
    loop q4 + polar(s41, w39) = q37 + polar(s40, w38);
    let q42 = q37 + polar(s40, w38);
}

impl Generated24 {
    pub fn position1(phi1) -> Position1 {
        q42,
        q37,
        s41,
        s40,
        t35,
        t34,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q42,
        velocity0: velocity(q42),
        acceleration0: acceleration(q42),
        jerk0: jerk(q42),
        q37,
        velocity1: velocity(q37),
        acceleration1: acceleration(q37),
        jerk1: jerk(q37),
        s41,
        velocity2: velocity(s41),
        acceleration2: acceleration(s41),
        jerk2: jerk(s41),
        s40,
        velocity3: velocity(s40),
        acceleration3: acceleration(s40),
        jerk3: jerk(s40)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q42,
        e0: sensitivity(q42, [l26, f2.y]),
        v0: d(q42, phi1),
        m0: d(q42, phi1, l26),
        w0: d(q42, l26, f2.y),
        q37,
        e1: sensitivity(q37, [l3, l30]),
        v1: d(q37, phi1),
        m1: d(q37, phi1, l3),
        w1: d(q37, l3, l30),
        s41,
        e2: sensitivity(s41, [f7.y, l15]),
        v2: d(s41, phi1),
        m2: d(s41, phi1, f7.y),
        w2: d(s41, f7.y, l15),
        s40,
        e3: sensitivity(s40, [f2.x, w39]),
        v3: d(s40, phi1),
        m3: d(s40, phi1, f2.x),
        w3: d(s40, f2.x, w39)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (polar(l8, t9) - l11 * dir(t10)) - (f7 - q4),
        v0: velocity((polar(l8, t9) - l11 * dir(t10)) - (f7 - q4)),
        a0: acceleration((polar(l8, t9) - l11 * dir(t10)) - (f7 - q4)),
        r1: (q12 + polar(l15, t17)) - (f13 + rotate((s18, l16), w14)),
        v1: velocity((q12 + polar(l15, t17)) - (f13 + rotate((s18, l16), w14))),
        a1: acceleration((q12 + polar(l15, t17)) - (f13 + rotate((s18, l16), w14))),
        r2: (q22 + polar(l25, t27)) - (f23 + rotate((s28, l26), phi1 + w24)),
        v2: velocity((q22 + polar(l25, t27)) - (f23 + rotate((s28, l26), phi1 + w24))),
        a2: acceleration((q22 + polar(l25, t27)) - (f23 + rotate((s28, l26), phi1 + w24))),
        r3: (q29 + polar(l33, t34)) - (q22 + polar((-l36), t35)),
        v3: velocity((q29 + polar(l33, t34)) - (q22 + polar((-l36), t35))),
        a3: acceleration((q29 + polar(l33, t34)) - (q22 + polar((-l36), t35))),
        r4: (q4 + polar(s41, w39)) - (q37 + polar(s40, w38)),
        v4: velocity((q4 + polar(s41, w39)) - (q37 + polar(s40, w38))),
        a4: acceleration((q4 + polar(s41, w39)) - (q37 + polar(s40, w38)))
    }
}
}
    position1(0): q42, q37, s41, s40, t35, t34, margin;
    motion1(0): q42, velocity0, acceleration0, jerk0, q37, velocity1, acceleration1, jerk1, s41, velocity2, acceleration2, jerk2, s40, velocity3, acceleration3, jerk3;
    accuracy1(0): q42, e0, v0, m0, w0, q37, e1, v1, m1, w1, s41, e2, v2, m2, w2, s40, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4;
}

corpus! {
    m27 Generated27 [l3, w5, f7.x, f7.y, l8, f10.x, f10.y, l11, l14, w15, f17.x, f17.y, l18, l19, l23, w24, f26.x, f26.y, l29, w30, l35, l37, w38, w40, f42.x, f42.y, l43, w47, l48, l49, l53, w54]
    {
pub struct Generated27 {
    unit cm;
    input phi1 = 0.9756391rad in 0.9754333rad..0.9758448rad;
    const f2 = (7.2830mm, 13.7403mm);
    param l3 = 22.9580mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.2663070rad;
    let g6 = w5 - phi1 / 2;
    param f7 = (48.6725mm, 13.7403mm);
    param l8 = 26.2940mm +- 20um;
    let q9 = f7 + polar(l8, g6);
    param f10 = (82.7147mm, 6.4344mm);
    param l11 = 18.6777mm;
    unknown t12 = 141deg;
    unknown s13 = 65.2mm;
    loop q4 = f10 + s13 * dir(t12) - polar(l11, t12 - 90deg);
    param l14 = 40.4628mm;
    param w15 = 0.7659855rad;
    let q16 = f10 + polar(l14, t12 + w15);
    param f17 = (-52.2799mm, 75.5227mm);
    param l18 = 90.7701mm;
    param l19 = 34.7545mm;
    unknown t20 = 59deg;
    unknown s21 = 119.6mm;
    loop f17 + polar(s21, 0deg) + polar(l19, 0deg + 90deg) = q4 + polar(l18, t20);
    let q22 = q4 + polar(l18, t20);
    param l23 = 20.2159mm;
    param w24 = 1.0120227rad;
    let q25 = q4 + polar(l23, t20 + w24);
    param f26 = (163.8698mm, 104.7222mm);
    unknown t27 = 177deg;
    unknown s28 = 96.7mm;
    loop f26 + polar(s28, t27) = q22;
    param l29 = 35.1878mm;
    param w30 = 1.1760881rad;
    let q31 = f26 + polar(l29, t27 + w30);
    const l32 = 47.2885mm;
    unknown t33 = -145deg;
    unknown t34 = 100deg;
    param l35 = 81.7400mm;
    loop q16 + polar(l35, t34) = q22 + polar(l32, t33);
    let q36 = q22 + polar(l32, t33);
    param l37 = 28.3971mm;
    param w38 = -2.1338664rad;
    let q39 = q22 + polar(l37, t33 + w38);
    param w40 = 1.5306150rad;
    unknown t41 = 255deg;
    loop 3 * (phi1) + w40 = t41;
    param f42 = (0.0000mm, 0.0000mm);
    param l43 = 41.6167mm +- 20um;
    unknown p44 = (-10.5mm, -40.3mm);
    loop p44 = f42 + polar(l43, t41);
    let q45 = p44;
    const f46 = (-28.7170mm, 11.1043mm);
    param w47 = -1.1239492rad;
    param l48 = 59.2273mm;
    param l49 = 24.2986mm;
    unknown t50 = 85deg;
    unknown s51 = 3.2mm;
    loop f46 + rotate((s51, l49), w47) = q45 + polar(l48, t50);
    let q52 = q45 + polar(l48, t50);
    param l53 = 37.9024mm +- 20um;
    param w54 = 1.2312419rad;
    let q55 = q45 + polar(l53, t50 + w54);
}

impl Generated27 {
    pub fn position1(phi1) -> Position1 {
        q55,
        q52,
        s51,
        t50,
        p44,
        t41,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q55,
        velocity0: velocity(q55),
        acceleration0: acceleration(q55),
        jerk0: jerk(q55),
        q52,
        velocity1: velocity(q52),
        acceleration1: acceleration(q52),
        jerk1: jerk(q52),
        s51,
        velocity2: velocity(s51),
        acceleration2: acceleration(s51),
        jerk2: jerk(s51),
        t50,
        velocity3: velocity(t50),
        acceleration3: acceleration(t50),
        jerk3: jerk(t50)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q55,
        e0: sensitivity(q55, [f10.y, w54]),
        v0: d(q55, phi1),
        m0: d(q55, phi1, f10.y),
        w0: d(q55, f10.y, w54),
        q52,
        e1: sensitivity(q52, [w40, w30]),
        v1: d(q52, phi1),
        m1: d(q52, phi1, w40),
        w1: d(q52, w40, w30),
        s51,
        e2: sensitivity(s51, [l48, f42.y]),
        v2: d(s51, phi1),
        m2: d(s51, phi1, l48),
        w2: d(s51, l48, f42.y),
        t50,
        e3: sensitivity(t50, [w40, f42.y]),
        v3: d(t50, phi1),
        m3: d(t50, phi1, w40),
        w3: d(t50, w40, f42.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q4) - (f10 + s13 * dir(t12) - polar(l11, t12 - 90deg)),
        v0: velocity((q4) - (f10 + s13 * dir(t12) - polar(l11, t12 - 90deg))),
        a0: acceleration((q4) - (f10 + s13 * dir(t12) - polar(l11, t12 - 90deg))),
        r1: (f17 + polar(s21, 0deg) + polar(l19, 0deg + 90deg)) - (q4 + polar(l18, t20)),
        v1: velocity((f17 + polar(s21, 0deg) + polar(l19, 0deg + 90deg)) - (q4 + polar(l18, t20))),
        a1: acceleration((f17 + polar(s21, 0deg) + polar(l19, 0deg + 90deg)) - (q4 + polar(l18, t20))),
        r2: (f26 + polar(s28, t27)) - (q22),
        v2: velocity((f26 + polar(s28, t27)) - (q22)),
        a2: acceleration((f26 + polar(s28, t27)) - (q22)),
        r3: (q16 + polar(l35, t34)) - (q22 + polar(l32, t33)),
        v3: velocity((q16 + polar(l35, t34)) - (q22 + polar(l32, t33))),
        a3: acceleration((q16 + polar(l35, t34)) - (q22 + polar(l32, t33))),
        r4: (f46 + rotate((s51, l49), w47)) - (q45 + polar(l48, t50)),
        v4: velocity((f46 + rotate((s51, l49), w47)) - (q45 + polar(l48, t50))),
        a4: acceleration((f46 + rotate((s51, l49), w47)) - (q45 + polar(l48, t50)))
    }
}
}
    position1(0): q55, q52, s51, t50, p44, t41, margin;
    motion1(0): q55, velocity0, acceleration0, jerk0, q52, velocity1, acceleration1, jerk1, s51, velocity2, acceleration2, jerk2, t50, velocity3, acceleration3, jerk3;
    accuracy1(0): q55, e0, v0, m0, w0, q52, e1, v1, m1, w1, s51, e2, v2, m2, w2, t50, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4;
}

corpus! {
    m30 Generated30 [f2.x, f2.y, l3, w5, f7.x, f7.y, l8, l10, l13, w14, w16, l17, l18, w23]
    {
pub struct Generated30 {
    unit mm;
    input phi1 = -1.1362093rad in -1.1528760rad..-1.1195427rad;
    param f2 = (12.7909mm, 17.6263mm);
    param l3 = 41.5189mm +- 20um;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.2447213rad;
    let g6 = w5 - phi1 / 2;
    param f7 = (47.6109mm, 17.6263mm);
    param l8 = 34.4387mm;
    let q9 = f7 + polar(l8, g6);
    param l10 = 29.9285mm;
    unknown t11 = 33deg;
    unknown s12 = 68.7mm;
    loop q9 = q4 + polar(s12, t11) + polar(l10, t11 + 90deg);
    param l13 = 54.5265mm;
    param w14 = 0.7690662rad;
    let q15 = q4 + polar(l13, t11 + w14);
    param w16 = 0.1246168rad;
    param l17 = 98.8002mm;
    param l18 = -6.8361mm +- 20um;
    unknown t19 = 103deg;
    unknown s20 = -54.9mm;
    loop q15 + dir(phi1 + w16) * s20 + l18 * dir(90deg + phi1 + w16) = q4 + polar(l17, t19);
    let q21 = q4 + polar(l17, t19);
    const l22 = 32.6114mm;
    param w23 = 0.1555811rad;
    let q24 = q4 + polar(l22, t19 + w23);
}

impl Generated30 {
    pub fn position1(phi1) -> Position1 {
        q24,
        q21,
        s20,
        t19,
        s12,
        t11,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q24,
        velocity0: velocity(q24),
        acceleration0: acceleration(q24),
        jerk0: jerk(q24),
        q21,
        velocity1: velocity(q21),
        acceleration1: acceleration(q21),
        jerk1: jerk(q21),
        s20,
        velocity2: velocity(s20),
        acceleration2: acceleration(s20),
        jerk2: jerk(s20),
        t19,
        velocity3: velocity(t19),
        acceleration3: acceleration(t19),
        jerk3: jerk(t19)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q24,
        e0: sensitivity(q24, [l10, l13]),
        v0: d(q24, phi1),
        m0: d(q24, phi1, l10),
        w0: d(q24, l10, l13),
        q21,
        e1: sensitivity(q21, [f2.x, f7.y]),
        v1: d(q21, phi1),
        m1: d(q21, phi1, f2.x),
        w1: d(q21, f2.x, f7.y),
        s20,
        e2: sensitivity(s20, [w5, l8]),
        v2: d(s20, phi1),
        m2: d(s20, phi1, w5),
        w2: d(s20, w5, l8),
        t19,
        e3: sensitivity(t19, [l13, l8]),
        v3: d(t19, phi1),
        m3: d(t19, phi1, l13),
        w3: d(t19, l13, l8)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q9) - (q4 + polar(s12, t11) + polar(l10, t11 + 90deg)),
        v0: velocity((q9) - (q4 + polar(s12, t11) + polar(l10, t11 + 90deg))),
        a0: acceleration((q9) - (q4 + polar(s12, t11) + polar(l10, t11 + 90deg))),
        r1: (q15 + dir(phi1 + w16) * s20 + l18 * dir(90deg + phi1 + w16)) - (q4 + polar(l17, t19)),
        v1: velocity((q15 + dir(phi1 + w16) * s20 + l18 * dir(90deg + phi1 + w16)) - (q4 + polar(l17, t19))),
        a1: acceleration((q15 + dir(phi1 + w16) * s20 + l18 * dir(90deg + phi1 + w16)) - (q4 + polar(l17, t19)))
    }
}
}
    position1(0): q24, q21, s20, t19, s12, t11, margin;
    motion1(0): q24, velocity0, acceleration0, jerk0, q21, velocity1, acceleration1, jerk1, s20, velocity2, acceleration2, jerk2, t19, velocity3, acceleration3, jerk3;
    accuracy1(0): q24, e0, v0, m0, w0, q21, e1, v1, m1, w1, s20, e2, v2, m2, w2, t19, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1;
}

corpus! {
    m33 Generated33 [l3, f5.x, f5.y, w6, w7, f11.x, f11.y, l12, l15, w18, f20.x, f20.y, l22, l25]
    {
pub struct Generated33 {
    unit mm;
    input phi1 = -2.1135937rad in -2.1191493rad..-2.1080382rad;
    const f2 = (-26.2328mm, -33.9814mm);
    param l3 = 28.9447mm;
    let q4 = f2 + polar(l3, phi1);
    param f5 = (-90.0116mm, -139.3643mm);
    param w6 = -1.0330414rad;
    param w7 = -0.1366975rad;
    unknown s8 = 13.5mm;
    unknown s9 = -88.7mm;
    loop f5 + polar(s9, phi1 + w7) = q4 + polar(s8, w6);
    let q10 = q4 + polar(s8, w6);
    param f11 = (-121.9367mm, -97.0024mm);
    param l12 = 89.2117mm +- 20um;
    unknown t13 = -130deg;
    unknown t14 = -52deg;
    param l15 = 37.9672mm;
    loop q4 + polar(l12, t13) = f11 + polar(l15, t14);
    let q16 = q4 + polar(l12, t13);
    const l17 = 40.2549mm;
    param w18 = -1.5368488rad;
    let q19 = q4 + polar(l17, t13 + w18);
    param f20 = (-197.6351mm, -174.7628mm);
    const f21 = (-138.2604mm, -78.7060mm);
    param l22 = 85.1297mm;
    unknown t23 = 163deg;
    unknown t24 = 103deg;
    param l25 = 71.2241mm;
    loop q19 + polar(l22, t23) = f21 + polar(l25, t24);
    let q26 = q19 + polar(l22, t23);
}

impl Generated33 {
    pub fn position1(phi1) -> Position1 {
        q26,
        q19,
        t24,
        t23,
        t14,
        t13,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q26,
        velocity0: velocity(q26),
        acceleration0: acceleration(q26),
        jerk0: jerk(q26),
        q19,
        velocity1: velocity(q19),
        acceleration1: acceleration(q19),
        jerk1: jerk(q19),
        t24,
        velocity2: velocity(t24),
        acceleration2: acceleration(t24),
        jerk2: jerk(t24),
        t23,
        velocity3: velocity(t23),
        acceleration3: acceleration(t23),
        jerk3: jerk(t23)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q26,
        e0: sensitivity(q26, [f5.x, l15]),
        v0: d(q26, phi1),
        m0: d(q26, phi1, f5.x),
        w0: d(q26, f5.x, l15),
        q19,
        e1: sensitivity(q19, [f11.x, f20.x]),
        v1: d(q19, phi1),
        m1: d(q19, phi1, f11.x),
        w1: d(q19, f11.x, f20.x),
        t24,
        e2: sensitivity(t24, [l12, f5.x]),
        v2: d(t24, phi1),
        m2: d(t24, phi1, l12),
        w2: d(t24, l12, f5.x),
        t23,
        e3: sensitivity(t23, [l25, w18]),
        v3: d(t23, phi1),
        m3: d(t23, phi1, l25),
        w3: d(t23, l25, w18)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (f5 + polar(s9, phi1 + w7)) - (q4 + polar(s8, w6)),
        v0: velocity((f5 + polar(s9, phi1 + w7)) - (q4 + polar(s8, w6))),
        a0: acceleration((f5 + polar(s9, phi1 + w7)) - (q4 + polar(s8, w6))),
        r1: (q4 + polar(l12, t13)) - (f11 + polar(l15, t14)),
        v1: velocity((q4 + polar(l12, t13)) - (f11 + polar(l15, t14))),
        a1: acceleration((q4 + polar(l12, t13)) - (f11 + polar(l15, t14))),
        r2: (q19 + polar(l22, t23)) - (f21 + polar(l25, t24)),
        v2: velocity((q19 + polar(l22, t23)) - (f21 + polar(l25, t24))),
        a2: acceleration((q19 + polar(l22, t23)) - (f21 + polar(l25, t24)))
    }
}
}
    position1(0): q26, q19, t24, t23, t14, t13, margin;
    motion1(0): q26, velocity0, acceleration0, jerk0, q19, velocity1, acceleration1, jerk1, t24, velocity2, acceleration2, jerk2, t23, velocity3, acceleration3, jerk3;
    accuracy1(0): q26, e0, v0, m0, w0, q19, e1, v1, m1, w1, t24, e2, v2, m2, w2, t23, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2;
}

corpus! {
    m36 Generated36 [f2.x, f2.y, l3, l5, l9, f10.x, f10.y, f10.z, l11, f12.x, f12.y, f12.z, l13, w18, w19, f20.x, f20.y, f20.z, l21]
    {
pub struct Generated36 {
    unit m;
    input phi1 = -0.9302605rad in -0.9469272rad..-0.9135938rad;
    param f2 = (33.0311mm, -12.8933mm);
    param l3 = 28.8611mm;
    let q4 = f2 + polar(l3, phi1);
    param l5 = 31.6731mm +- 20um;
    let q6 = (q4.x, q4.y, l5);
    const d7 = (1.8786269, 0.2252243, 0.6481012);
    unknown p8 = (74.1mm, -15.0mm, -16.5mm);
    param l9 = 57.7624mm;
    loop norm(p8 - q6) = l9;
    param f10 = (110.1728mm, -42.9358mm, -0.7056mm);
    param l11 = -36.0239mm;
    loop dot(unit((1, 0, 0)), p8 - f10) = l11;
    param f12 = (12.9913mm, -41.4112mm, -82.5440mm);
    param l13 = 43.1115mm +- 20um;
    loop dot(unit(turn(d7, (0, 0, 1), phi1)), p8 - f12) = l13;
    let q14 = p8;
    let q15 = (q14.x, q14.y);
    const d16 = (0.1557312, -1.2777865, 1.5306892);
    unknown n17 = (-0.61, 0.40, -0.69);
    loop norm(n17) = 1;
    param w18 = 1.8413785rad;
    loop dot(n17, unit(turn(d16, (0, 1, 0), phi1))) = cos(w18);
    param w19 = 1.1583957rad;
    loop cos(w19) = dot(n17, unit((0, 1, 0)));
    param f20 = (-39.9232mm, 2.4598mm, 0.2947mm);
    param l21 = 43.2565mm;
    let q22 = f20 + l21 * n17;
}

impl Generated36 {
    pub fn position1(phi1) -> Position1 {
        q15,
        q4,
        q22,
        n17,
        p8,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q15,
        velocity0: velocity(q15),
        acceleration0: acceleration(q15),
        jerk0: jerk(q15),
        q4,
        velocity1: velocity(q4),
        acceleration1: acceleration(q4),
        jerk1: jerk(q4),
        q22,
        velocity2: velocity(q22),
        acceleration2: acceleration(q22),
        jerk2: jerk(q22),
        n17,
        velocity3: velocity(n17),
        acceleration3: acceleration(n17),
        jerk3: jerk(n17)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q15,
        e0: sensitivity(q15, [l3, w19]),
        v0: d(q15, phi1),
        m0: d(q15, phi1, l3),
        w0: d(q15, l3, w19),
        q4,
        e1: sensitivity(q4, [f12.z, f12.x]),
        v1: d(q4, phi1),
        m1: d(q4, phi1, f12.z),
        w1: d(q4, f12.z, f12.x),
        q22,
        e2: sensitivity(q22, [w19, f10.z]),
        v2: d(q22, phi1),
        m2: d(q22, phi1, w19),
        w2: d(q22, w19, f10.z),
        n17,
        e3: sensitivity(n17, [f12.x, l9]),
        v3: d(n17, phi1),
        m3: d(n17, phi1, f12.x),
        w3: d(n17, f12.x, l9)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (norm(p8 - q6)) - (l9),
        v0: velocity((norm(p8 - q6)) - (l9)),
        a0: acceleration((norm(p8 - q6)) - (l9)),
        r1: (dot(unit((1, 0, 0)), p8 - f10)) - (l11),
        v1: velocity((dot(unit((1, 0, 0)), p8 - f10)) - (l11)),
        a1: acceleration((dot(unit((1, 0, 0)), p8 - f10)) - (l11)),
        r2: (dot(unit(turn(d7, (0, 0, 1), phi1)), p8 - f12)) - (l13),
        v2: velocity((dot(unit(turn(d7, (0, 0, 1), phi1)), p8 - f12)) - (l13)),
        a2: acceleration((dot(unit(turn(d7, (0, 0, 1), phi1)), p8 - f12)) - (l13)),
        r3: (norm(n17)) - (1),
        v3: velocity((norm(n17)) - (1)),
        a3: acceleration((norm(n17)) - (1)),
        r4: (dot(n17, unit(turn(d16, (0, 1, 0), phi1)))) - (cos(w18)),
        v4: velocity((dot(n17, unit(turn(d16, (0, 1, 0), phi1)))) - (cos(w18))),
        a4: acceleration((dot(n17, unit(turn(d16, (0, 1, 0), phi1)))) - (cos(w18))),
        r5: (cos(w19)) - (dot(n17, unit((0, 1, 0)))),
        v5: velocity((cos(w19)) - (dot(n17, unit((0, 1, 0))))),
        a5: acceleration((cos(w19)) - (dot(n17, unit((0, 1, 0)))))
    }
}
}
    position1(0): q15, q4, q22, n17, p8, margin;
    motion1(0): q15, velocity0, acceleration0, jerk0, q4, velocity1, acceleration1, jerk1, q22, velocity2, acceleration2, jerk2, n17, velocity3, acceleration3, jerk3;
    accuracy1(0): q15, e0, v0, m0, w0, q4, e1, v1, m1, w1, q22, e2, v2, m2, w2, n17, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5;
}

corpus! {
    m39 Generated39 [f2.x, f2.y, l3, w5, l8, l10, f12.x, f12.y, f12.z, d14.x, d14.y, d14.z, l16, l19, w20]
    {
pub struct Generated39 {
    unit mm;
    input phi1 = 0.8203047rad;
    param f2 = (24.5048mm, 31.8893mm);
    param l3 = 31.1984mm;
    let q4 = f2 + polar(l3, phi1);
    param w5 = 0.5008702rad;
    let g6 = 2 * phi1 + w5;
    const f7 = (55.9281mm, 31.8893mm);
    param l8 = 38.3484mm;
    let q9 = f7 + polar(l8, g6);
    param l10 = -20.5724mm;
    let q11 = (q9.x, q9.y, l10);
    param f12 = (25.7938mm, 97.2295mm, 16.2787mm);
    const d13 = (-0.8804039, 0.1355047, 0.4544530);
    param d14 = (-1.4905797, 1.2203097, 0.5376027);
    const f15 = (80.3880mm, 114.1785mm);
    param l16 = -14.4672mm;
    unknown t17 = -120deg;
    unknown s18 = 65.8mm;
    loop q9 = f15 + polar(s18, t17) + polar(l16, t17 + 90deg);
    param l19 = 24.3281mm +- 20um;
    param w20 = 0.8735394rad;
    let q21 = f15 + polar(l19, t17 + w20);
}

impl Generated39 {
    pub fn position1(phi1) -> Position1 {
        q21,
        q9,
        q11,
        s18,
        t17,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q21,
        velocity0: velocity(q21),
        acceleration0: acceleration(q21),
        jerk0: jerk(q21),
        q9,
        velocity1: velocity(q9),
        acceleration1: acceleration(q9),
        jerk1: jerk(q9),
        q11,
        velocity2: velocity(q11),
        acceleration2: acceleration(q11),
        jerk2: jerk(q11),
        s18,
        velocity3: velocity(s18),
        acceleration3: acceleration(s18),
        jerk3: jerk(s18)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q21,
        e0: sensitivity(q21, [l8, l16]),
        v0: d(q21, phi1),
        m0: d(q21, phi1, l8),
        w0: d(q21, l8, l16),
        q9,
        e1: sensitivity(q9, [l19, l3]),
        v1: d(q9, phi1),
        m1: d(q9, phi1, l19),
        w1: d(q9, l19, l3),
        q11,
        e2: sensitivity(q11, [w5, f12.z]),
        v2: d(q11, phi1),
        m2: d(q11, phi1, w5),
        w2: d(q11, w5, f12.z),
        s18,
        e3: sensitivity(s18, [w5, f2.y]),
        v3: d(s18, phi1),
        m3: d(s18, phi1, w5),
        w3: d(s18, w5, f2.y)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (q9) - (f15 + polar(s18, t17) + polar(l16, t17 + 90deg)),
        v0: velocity((q9) - (f15 + polar(s18, t17) + polar(l16, t17 + 90deg))),
        a0: acceleration((q9) - (f15 + polar(s18, t17) + polar(l16, t17 + 90deg)))
    }
}
}
    position1(0): q21, q9, q11, s18, t17, margin;
    motion1(0): q21, velocity0, acceleration0, jerk0, q9, velocity1, acceleration1, jerk1, q11, velocity2, acceleration2, jerk2, s18, velocity3, acceleration3, jerk3;
    accuracy1(0): q21, e0, v0, m0, w0, q9, e1, v1, m1, w1, q11, e2, v2, m2, w2, s18, e3, v3, m3, w3;
    closure1(0): r0, v0, a0;
}

corpus! {
    m42 Generated42 [l2, w8, w9, f10.x, f10.y, f10.z, l11, f13.x, f13.y, l14, l17, l19, d22.x, d22.y, d22.z, l24, l26, f27.x, f27.y, f27.z]
    {
pub struct Generated42 {
    unit mm;
    input phi1 = -0.9651671rad in -0.9707226rad..-0.9596115rad;
    param l2 = 28.3580mm +- 20um;
    let q3 = polar(l2, phi1);
    const d4 = (-0.0100397, -0.9068093, 0.4214215);
    const d5 = (0.2419861, -0.8600234, -0.4492242);
    const d6 = (0.7306472, 0.3156214, 0.6054236);
    unknown n7 = (0.54, -0.84, 0.06);
    loop dot(n7, n7) = 1;
    param w8 = 1.1775120rad;
    loop cos(w8) = dot(n7, unit(turn(d5, d4, phi1)));
    param w9 = 2.1723189rad;
    loop cos(w9) = dot(n7, unit(turn((0, 0, 1), d6, phi1)));
    param f10 = (0.3996mm, 38.5079mm, -10.8158mm);
    param l11 = 35.6549mm +- 20um;
    let q12 = f10 + l11 * n7;
    param f13 = (20.1652mm, -75.0941mm);
    param l14 = 36.4772mm +- 20um;
    unknown t15 = -179deg;
    unknown t16 = 128deg;
    param l17 = 65.1683mm;
    loop q3 + polar(l14, t15) = f13 + polar(l17, t16);
    let q18 = q3 + polar(l14, t15);
    param l19 = -3.5049mm;
    let q20 = (q18.x, q18.y, l19);
    const d21 = (-0.4669297, 0.5283857, 0.7090735);
    param d22 = (-0.3760873, 0.9039622, 0.2034961);
    unknown p23 = (123.6mm, 6.0mm, 47.6mm);
    param l24 = 118.2203mm;
    loop l24 * l24 = dot(q12 - p23, q12 - p23);
    const f25 = (83.4452mm, 5.7601mm, 28.4660mm);
    param l26 = -5.0193mm;
    loop l26 = dot(unit(d21), p23 - f25);
    param f27 = (58.8631mm, -89.3733mm, 17.0489mm);
    const l28 = 68.1271mm;
    loop l28 = dot(unit(d22), p23 - f27);
    let q29 = p23;
    let q30 = (q29.x, q29.y);
}

impl Generated42 {
    pub fn position1(phi1) -> Position1 {
        q30,
        q18,
        q29,
        p23,
        t16,
        t15,
        n7,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q30,
        velocity0: velocity(q30),
        acceleration0: acceleration(q30),
        jerk0: jerk(q30),
        q18,
        velocity1: velocity(q18),
        acceleration1: acceleration(q18),
        jerk1: jerk(q18),
        q29,
        velocity2: velocity(q29),
        acceleration2: acceleration(q29),
        jerk2: jerk(q29),
        p23,
        velocity3: velocity(p23),
        acceleration3: acceleration(p23),
        jerk3: jerk(p23)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q30,
        e0: sensitivity(q30, [f27.x, f27.y]),
        v0: d(q30, phi1),
        m0: d(q30, phi1, f27.x),
        w0: d(q30, f27.x, f27.y),
        q18,
        e1: sensitivity(q18, [l19, d22.y]),
        v1: d(q18, phi1),
        m1: d(q18, phi1, l19),
        w1: d(q18, l19, d22.y),
        q29,
        e2: sensitivity(q29, [f10.y, d22.z]),
        v2: d(q29, phi1),
        m2: d(q29, phi1, f10.y),
        w2: d(q29, f10.y, d22.z),
        p23,
        e3: sensitivity(p23, [l24, f10.z]),
        v3: d(p23, phi1),
        m3: d(p23, phi1, l24),
        w3: d(p23, l24, f10.z)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (dot(n7, n7)) - (1),
        v0: velocity((dot(n7, n7)) - (1)),
        a0: acceleration((dot(n7, n7)) - (1)),
        r1: (cos(w8)) - (dot(n7, unit(turn(d5, d4, phi1)))),
        v1: velocity((cos(w8)) - (dot(n7, unit(turn(d5, d4, phi1))))),
        a1: acceleration((cos(w8)) - (dot(n7, unit(turn(d5, d4, phi1))))),
        r2: (cos(w9)) - (dot(n7, unit(turn((0, 0, 1), d6, phi1)))),
        v2: velocity((cos(w9)) - (dot(n7, unit(turn((0, 0, 1), d6, phi1))))),
        a2: acceleration((cos(w9)) - (dot(n7, unit(turn((0, 0, 1), d6, phi1))))),
        r3: (q3 + polar(l14, t15)) - (f13 + polar(l17, t16)),
        v3: velocity((q3 + polar(l14, t15)) - (f13 + polar(l17, t16))),
        a3: acceleration((q3 + polar(l14, t15)) - (f13 + polar(l17, t16))),
        r4: (l24 * l24) - (dot(q12 - p23, q12 - p23)),
        v4: velocity((l24 * l24) - (dot(q12 - p23, q12 - p23))),
        a4: acceleration((l24 * l24) - (dot(q12 - p23, q12 - p23))),
        r5: (l26) - (dot(unit(d21), p23 - f25)),
        v5: velocity((l26) - (dot(unit(d21), p23 - f25))),
        a5: acceleration((l26) - (dot(unit(d21), p23 - f25))),
        r6: (l28) - (dot(unit(d22), p23 - f27)),
        v6: velocity((l28) - (dot(unit(d22), p23 - f27))),
        a6: acceleration((l28) - (dot(unit(d22), p23 - f27)))
    }
}
}
    position1(0): q30, q18, q29, p23, t16, t15, n7, margin;
    motion1(0): q30, velocity0, acceleration0, jerk0, q18, velocity1, acceleration1, jerk1, q29, velocity2, acceleration2, jerk2, p23, velocity3, acceleration3, jerk3;
    accuracy1(0): q30, e0, v0, m0, w0, q18, e1, v1, m1, w1, q29, e2, v2, m2, w2, p23, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3, r4, v4, a4, r5, v5, a5, r6, v6, a6;
}

corpus! {
    m45 Generated45 [l2, w4, f6.x, f6.y, l7, l9, f11.x, f11.y, f11.z, l13, l14, f15.x, f15.y, f15.z, l16, l19, f22.x, f22.y, f22.z, v23.x, v23.y, v23.z, l26]
    {
pub struct Generated45 {
    unit mm;
    input phi1 = 2.1834069rad in 2.1667402rad..2.2000736rad;
    param l2 = 35.9358mm;
    let q3 = polar(l2, phi1);
    param w4 = -0.9539598rad;
    let g5 = w4 - phi1;
    param f6 = (40.5133mm, 0.0000mm);
    param l7 = 27.5372mm +- 20um;
    let q8 = f6 + polar(l7, g5);
    param l9 = 4.8850mm +- 20um;
    let q10 = (q3.x, q3.y, l9);
    param f11 = (10.7122mm, 28.3585mm, 53.0883mm);
    unknown p12 = (-80.8mm, 49.1mm, 38.0mm);
    param l13 = 71.4107mm;
    loop dot(q10 - p12, q10 - p12) = l13 * l13;
    param l14 = 95.0595mm +- 20um;
    loop l14 = norm(p12 - f11);
    param f15 = (16.4664mm, 7.5630mm, 56.4862mm);
    param l16 = 41.4881mm;
    loop dot(unit((0, 1, 0)), p12 - f15) = l16;
    let q17 = p12;
    let q18 = (q17.x, q17.y);
    param l19 = 23.9274mm;
    let q20 = (q8.x, q8.y, l19);
    const d21 = (-0.1797225, -0.9797523, 0.0882343);
    param f22 = (67.8265mm, 45.2443mm, -6.7101mm);
    param v23 = (-19.2743mm, -9.7195mm, 55.9824mm);
    unknown t24 = 12deg;
    let q25 = f22 + turn(v23, d21, t24);
    param l26 = 49.2571mm +- 20um;
    loop dot((f22 + turn(v23, d21, t24)) - q20, (f22 + turn(v23, d21, t24)) - q20) = l26 * l26;
    let q27 = (q25.x, q25.y);
}

impl Generated45 {
    pub fn position1(phi1) -> Position1 {
        q27,
        q18,
        q25,
        t24,
        p12,
        margin: margin()
    }
    pub fn motion1(phi1) -> Motion1 {
        q27,
        velocity0: velocity(q27),
        acceleration0: acceleration(q27),
        jerk0: jerk(q27),
        q18,
        velocity1: velocity(q18),
        acceleration1: acceleration(q18),
        jerk1: jerk(q18),
        q25,
        velocity2: velocity(q25),
        acceleration2: acceleration(q25),
        jerk2: jerk(q25),
        t24,
        velocity3: velocity(t24),
        acceleration3: acceleration(t24),
        jerk3: jerk(t24)
    }
    pub fn accuracy1(phi1) -> Accuracy1 {
        q27,
        e0: sensitivity(q27, [w4, f6.x]),
        v0: d(q27, phi1),
        m0: d(q27, phi1, w4),
        w0: d(q27, w4, f6.x),
        q18,
        e1: sensitivity(q18, [l7, l9]),
        v1: d(q18, phi1),
        m1: d(q18, phi1, l7),
        w1: d(q18, l7, l9),
        q25,
        e2: sensitivity(q25, [l19, l26]),
        v2: d(q25, phi1),
        m2: d(q25, phi1, l19),
        w2: d(q25, l19, l26),
        t24,
        e3: sensitivity(t24, [f15.x, f15.z]),
        v3: d(t24, phi1),
        m3: d(t24, phi1, f15.x),
        w3: d(t24, f15.x, f15.z)
    }
    pub fn closure1(phi1) -> Closure1 {
        r0: (dot(q10 - p12, q10 - p12)) - (l13 * l13),
        v0: velocity((dot(q10 - p12, q10 - p12)) - (l13 * l13)),
        a0: acceleration((dot(q10 - p12, q10 - p12)) - (l13 * l13)),
        r1: (l14) - (norm(p12 - f11)),
        v1: velocity((l14) - (norm(p12 - f11))),
        a1: acceleration((l14) - (norm(p12 - f11))),
        r2: (dot(unit((0, 1, 0)), p12 - f15)) - (l16),
        v2: velocity((dot(unit((0, 1, 0)), p12 - f15)) - (l16)),
        a2: acceleration((dot(unit((0, 1, 0)), p12 - f15)) - (l16)),
        r3: (dot((f22 + turn(v23, d21, t24)) - q20, (f22 + turn(v23, d21, t24)) - q20)) - (l26 * l26),
        v3: velocity((dot((f22 + turn(v23, d21, t24)) - q20, (f22 + turn(v23, d21, t24)) - q20)) - (l26 * l26)),
        a3: acceleration((dot((f22 + turn(v23, d21, t24)) - q20, (f22 + turn(v23, d21, t24)) - q20)) - (l26 * l26))
    }
}
}
    position1(0): q27, q18, q25, t24, p12, margin;
    motion1(0): q27, velocity0, acceleration0, jerk0, q18, velocity1, acceleration1, jerk1, q25, velocity2, acceleration2, jerk2, t24, velocity3, acceleration3, jerk3;
    accuracy1(0): q27, e0, v0, m0, w0, q18, e1, v1, m1, w1, q25, e2, v2, m2, w2, t24, e3, v3, m3, w3;
    closure1(0): r0, v0, a0, r1, v1, a1, r2, v2, a2, r3, v3, a3;
}

/// The seed of each mechanism and the results of all its functions.
pub(crate) const ALL: &[(u64, crate::Results)] = &[
    (0, m0::results),
    (3, m3::results),
    (6, m6::results),
    (9, m9::results),
    (12, m12::results),
    (15, m15::results),
    (18, m18::results),
    (21, m21::results),
    (24, m24::results),
    (27, m27::results),
    (30, m30::results),
    (33, m33::results),
    (36, m36::results),
    (39, m39::results),
    (42, m42::results),
    (45, m45::results),
];

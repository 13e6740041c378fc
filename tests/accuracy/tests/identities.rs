//! Euler's theorem on homogeneous functions: where every length is a parameter, an angle and its
//! derivatives do not change when all lengths grow alike, and a coordinate and its derivatives grow
//! with them: `sum r_i d(angle)/d r_i = 0`, `sum r_i d(x)/d r_i = x`.

use linkage_reference::{Random, identities};

/// A number within 3 % of the given one.
fn near(random: &mut Random, x: f64) -> f64 {
    x * random.between(0.97, 1.03)
}

linkage::mechanism! {
    struct FourBar {
        unit mm;
        param pivot_d = (140mm, 3mm);
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param arm = 70mm;
        param lift = 25deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }

    impl FourBar {
        fn values(phi) -> FourBarValues {
            psi, psi_by: sensitivity(psi), tracer, tracer_by: sensitivity(tracer),
        }
        fn rates(phi) -> FourBarRates {
            psi: velocity(psi), psi_by: sensitivity(velocity(psi)),
            tracer: velocity(tracer), tracer_by: sensitivity(velocity(tracer)),
        }
        fn seconds(phi) -> FourBarSeconds {
            psi: acceleration(psi), psi_by: sensitivity(acceleration(psi)),
            tracer: acceleration(tracer), tracer_by: sensitivity(acceleration(tracer)),
        }
    }
}

identities!(
    four_bar, FourBar, phi, angles [psi psi_by], lengths [tracer tracer_by],
    random => FourBar {
        pivot_d: [near(random, 140.0), near(random, 3.0)].into(),
        crank: near(random, 50.0),
        coupler: near(random, 120.0),
        rocker: near(random, 100.0),
        arm: near(random, 70.0),
        lift: random.angle(),
    },
    random.angle(),
    |m| vec![m.pivot_d.x, m.pivot_d.y, m.crank, m.coupler, m.rocker, m.arm, m.lift]
);

linkage::mechanism! {
    struct SliderCrank {
        unit mm;
        param crank = 30mm;
        param rod = 100mm;
        param offset = 10mm;
        param gamma = 5deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 3deg;
        unknown s = 126mm;
        loop polar(crank, phi) + polar(rod, theta) = polar(offset, gamma + 90deg) + polar(s, gamma);
    }

    impl SliderCrank {
        fn values(phi) -> SliderValues {
            theta, theta_by: sensitivity(theta), s, s_by: sensitivity(s),
        }
        fn rates(phi) -> SliderRates {
            theta: velocity(theta), theta_by: sensitivity(velocity(theta)),
            s: velocity(s), s_by: sensitivity(velocity(s)),
        }
        fn seconds(phi) -> SliderSeconds {
            theta: acceleration(theta), theta_by: sensitivity(acceleration(theta)),
            s: acceleration(s), s_by: sensitivity(acceleration(s)),
        }
    }
}

identities!(
    slider_crank, SliderCrank, phi, angles [theta theta_by], lengths [s s_by],
    random => SliderCrank {
        crank: near(random, 30.0),
        rod: near(random, 100.0),
        offset: near(random, 10.0),
        gamma: near(random, 0.1),
    },
    random.angle(),
    |m| vec![m.crank, m.rod, m.offset, m.gamma]
);

linkage::mechanism! {
    struct SwingingBlock {
        unit mm;
        param pivot = (80mm, -20mm);
        param crank = 30mm;
        param offset = 10mm;
        input phi = 40deg in 0deg..360deg;
        unknown psi = 137deg;
        unknown s = 68mm;
        loop pivot + rotate((s, offset), psi) = polar(crank, phi);
    }

    impl SwingingBlock {
        fn values(phi) -> BlockValues { psi, psi_by: sensitivity(psi), s, s_by: sensitivity(s) }
        fn rates(phi) -> BlockRates {
            psi: velocity(psi), psi_by: sensitivity(velocity(psi)),
            s: velocity(s), s_by: sensitivity(velocity(s)),
        }
        fn seconds(phi) -> BlockSeconds {
            psi: acceleration(psi), psi_by: sensitivity(acceleration(psi)),
            s: acceleration(s), s_by: sensitivity(acceleration(s)),
        }
    }
}

identities!(
    swinging_block, SwingingBlock, phi, angles [psi psi_by], lengths [s s_by],
    random => SwingingBlock {
        pivot: [near(random, 80.0), near(random, -20.0)].into(),
        crank: near(random, 30.0),
        offset: near(random, 10.0),
    },
    random.angle(),
    |m| vec![m.pivot.x, m.pivot.y, m.crank, m.offset]
);

linkage::mechanism! {
    struct Trammel {
        unit mm;
        param crank = 30mm;
        param pivot = (20mm, -15mm);
        param alpha = 10deg;
        param beta = 100deg;
        input phi = 30deg in 0deg..360deg;
        unknown s = -10mm;
        unknown t = 30mm;
        loop polar(crank, phi) + s * dir(alpha) = pivot + t * dir(beta + 0.1 * phi);
    }

    impl Trammel {
        fn values(phi) -> TrammelValues { s, s_by: sensitivity(s), t, t_by: sensitivity(t) }
        fn rates(phi) -> TrammelRates {
            s: velocity(s), s_by: sensitivity(velocity(s)),
            t: velocity(t), t_by: sensitivity(velocity(t)),
        }
        fn seconds(phi) -> TrammelSeconds {
            s: acceleration(s), s_by: sensitivity(acceleration(s)),
            t: acceleration(t), t_by: sensitivity(acceleration(t)),
        }
    }
}

identities!(
    trammel, Trammel, phi, angles [], lengths [s s_by, t t_by],
    random => Trammel {
        crank: near(random, 30.0),
        pivot: [near(random, 20.0), near(random, -15.0)].into(),
        alpha: near(random, 0.2),
        beta: near(random, 1.7),
    },
    random.angle(),
    |m| vec![m.crank, m.pivot.x, m.pivot.y, m.alpha, m.beta]
);

linkage::mechanism! {
    /// The coupler point of a four-bar drives a second dyad.
    struct SixBar {
        unit mm;
        param pivot_d = (140mm, 5mm);
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param arm = 70mm;
        param pivot_g = (-60mm, 150mm);
        param link = 160mm;
        param out = 120mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        unknown alpha = 109deg;
        unknown beta = 48deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tip = pivot_g + polar(out, beta);
        loop a + polar(arm, theta + 25deg) + polar(link, alpha) = tip;
    }

    impl SixBar {
        fn values(phi) -> SixBarValues {
            beta, beta_by: sensitivity(beta), tip, tip_by: sensitivity(tip),
        }
        fn rates(phi) -> SixBarRates {
            beta: velocity(beta), beta_by: sensitivity(velocity(beta)),
            tip: velocity(tip), tip_by: sensitivity(velocity(tip)),
        }
        fn seconds(phi) -> SixBarSeconds {
            beta: acceleration(beta), beta_by: sensitivity(acceleration(beta)),
            tip: acceleration(tip), tip_by: sensitivity(acceleration(tip)),
        }
    }
}

identities!(
    six_bar, SixBar, phi, angles [beta beta_by], lengths [tip tip_by],
    random => SixBar {
        pivot_d: [near(random, 140.0), near(random, 5.0)].into(),
        crank: near(random, 50.0),
        coupler: near(random, 120.0),
        rocker: near(random, 100.0),
        arm: near(random, 70.0),
        pivot_g: [near(random, -60.0), near(random, 150.0)].into(),
        link: near(random, 160.0),
        out: near(random, 120.0),
    },
    random.angle(),
    |m| vec![
        m.pivot_d.x, m.pivot_d.y, m.crank, m.coupler, m.rocker, m.arm, m.pivot_g.x, m.pivot_g.y,
        m.link, m.out,
    ]
);

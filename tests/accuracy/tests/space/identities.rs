//! Euler's theorem on homogeneous functions, in space: all sensitivities of values, velocities and
//! accelerations at once.

use linkage_reference::{Random, identities};

/// A number within 3 % of the given one.
fn near(random: &mut Random, x: f64) -> f64 {
    x * random.between(0.97, 1.03)
}

fn near_vector<const N: usize>(random: &mut Random, v: [f64; N]) -> [f64; N] {
    v.map(|x| near(random, x))
}

linkage::mechanism! {
    /// RSSR, and RSSP on the rocker.
    struct Drive {
        unit mm;
        param crank = 10mm;
        param coupler = 50mm;
        param rocker = 30mm;
        param lift = 3mm;
        param pivot = (40mm, 10mm, 5mm);
        param gamma1 = 50deg;
        param gamma2 = 10deg;
        param rod = 90mm;
        param rail = (30mm, 0mm, -60mm);
        param guide = (0.9, 0.3, 0.4);
        input phi = 60deg in 0deg..360deg;
        unknown psi = 100deg;
        unknown s = 0mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let x = turn((1, 0, 0), (0, 1, 0), gamma1);
        let axis = turn(turn((0, 0, 1), (0, 1, 0), gamma1), x, gamma2);
        let end = pivot + turn(rocker * x + lift * axis, axis, psi);
        loop distance(pin, end) = coupler;
        loop distance(end, rail + s * guide) = rod;
    }

    impl Drive {
        fn values(phi) -> DriveValues {
            psi, psi_by: sensitivity(psi), end, end_by: sensitivity(end), s, s_by: sensitivity(s),
        }
        fn rates(phi) -> DriveRates {
            psi: velocity(psi), psi_by: sensitivity(velocity(psi)),
            end: velocity(end), end_by: sensitivity(velocity(end)),
            s: velocity(s), s_by: sensitivity(velocity(s)),
        }
        fn seconds(phi) -> DriveSeconds {
            psi: acceleration(psi), psi_by: sensitivity(acceleration(psi)),
            end: acceleration(end), end_by: sensitivity(acceleration(end)),
            s: acceleration(s), s_by: sensitivity(acceleration(s)),
        }
    }
}

identities!(
    rssr_and_rssp, Drive, phi, angles [psi psi_by], lengths [end end_by, s s_by],
    random => Drive {
        crank: near(random, 10.0),
        coupler: near(random, 50.0),
        rocker: near(random, 30.0),
        lift: near(random, 3.0),
        pivot: near_vector(random, [40.0, 10.0, 5.0]).into(),
        gamma1: near(random, 50f64.to_radians()),
        gamma2: near(random, 10f64.to_radians()),
        rod: near(random, 90.0),
        rail: near_vector(random, [30.0, 1.0, -60.0]).into(),
        guide: near_vector(random, [0.9, 0.3, 0.4]).into(),
    },
    random.angle(),
    |m| {
        let ends = [m.crank, m.coupler, m.rocker, m.lift];
        let angles = [m.gamma1, m.gamma2, m.rod];
        [&ends[..], m.pivot.as_slice(), &angles, m.rail.as_slice(), m.guide.as_slice()].concat()
    }
);

linkage::mechanism! {
    /// A tripod whose feet stand on a crank and on the frame, and a bar from its top to a plane.
    struct Tripod {
        unit mm;
        param crank = 10mm;
        param two = (60mm, 5mm, 3mm);
        param three = (20mm, 55mm, -2mm);
        param l1 = 45mm;
        param l2 = 57mm;
        param l3 = 52mm;
        param bar = 70mm;
        param arm = 80mm;
        param normal = (0.1, 0.9, 0.2);
        param height = 13mm;
        input phi = 30deg in 0deg..360deg;
        unknown p = (26mm, 20mm, -40mm);
        unknown q = (90mm, 13mm, -60mm);
        let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
        loop distance(p, one) = l1;
        loop distance(p, two) = l2;
        loop distance(p, three) = l3;
        loop distance(q, p) = bar;
        loop distance(q, two) = arm;
        loop dot(normal, q) = height;
    }

    impl Tripod {
        fn values(phi) -> TripodValues { p, p_by: sensitivity(p), q, q_by: sensitivity(q) }
        fn rates(phi) -> TripodRates {
            p: velocity(p), p_by: sensitivity(velocity(p)),
            q: velocity(q), q_by: sensitivity(velocity(q)),
        }
        fn seconds(phi) -> TripodSeconds {
            p: acceleration(p), p_by: sensitivity(acceleration(p)),
            q: acceleration(q), q_by: sensitivity(acceleration(q)),
        }
    }
}

identities!(
    tripod, Tripod, phi, angles [], lengths [p p_by, q q_by],
    random => Tripod {
        crank: near(random, 10.0),
        two: near_vector(random, [60.0, 5.0, 3.0]).into(),
        three: near_vector(random, [20.0, 55.0, -2.0]).into(),
        l1: near(random, 45.0),
        l2: near(random, 57.0),
        l3: near(random, 52.0),
        bar: near(random, 70.0),
        arm: near(random, 80.0),
        normal: near_vector(random, [0.1, 0.9, 0.2]).into(),
        height: near(random, 13.0),
    },
    random.angle(),
    |m| {
        let lengths = [m.l1, m.l2, m.l3, m.bar, m.arm];
        let points = [m.two.as_slice(), m.three.as_slice()].concat();
        [&[m.crank][..], &points, &lengths, m.normal.as_slice(), &[m.height]].concat()
    }
);

linkage::mechanism! {
    /// Two slides and a link in a loop of three rows; a direction square to the link's arm; then
    /// three slides.
    struct Rows {
        unit mm;
        param crank = 15mm;
        param link = 60mm;
        param base = (30mm, -15mm, 25mm);
        param one = 10deg;
        param two = 60deg;
        param tilt = 25deg;
        param shadow = 15mm;
        param far = (90mm, 70mm, 80mm);
        input phi = 30deg in 0deg..360deg;
        unknown s = 60mm;
        unknown t = 10mm;
        unknown psi = 37deg;
        unknown n = (0.5, 0.5, 0.5);
        unknown u = 270mm;
        unknown v = 90mm;
        unknown w = -190mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let axis = (sin(tilt), 0, cos(tilt));
        let arm = turn(link * (cos(tilt), 0, -sin(tilt)), axis, psi);
        loop pin + s * (cos(one), sin(one), 0) + t * (0, cos(two), sin(two)) = base + arm;
        loop norm(n) = 1;
        loop dot(n, arm) = shadow;
        loop dot(n, axis) = 0.3;
        loop base + arm + u * n + v * (1, 0, 0) + w * (0.1, 1, 0.2) = far;
    }

    impl Rows {
        fn values(phi) -> RowsValues {
            psi, psi_by: sensitivity(psi), n, n_by: sensitivity(n),
            s, s_by: sensitivity(s), v, v_by: sensitivity(v),
        }
        fn rates(phi) -> RowsRates {
            psi: velocity(psi), psi_by: sensitivity(velocity(psi)),
            n: velocity(n), n_by: sensitivity(velocity(n)),
            s: velocity(s), s_by: sensitivity(velocity(s)),
            v: velocity(v), v_by: sensitivity(velocity(v)),
        }
        fn seconds(phi) -> RowsSeconds {
            psi: acceleration(psi), psi_by: sensitivity(acceleration(psi)),
            n: acceleration(n), n_by: sensitivity(acceleration(n)),
            s: acceleration(s), s_by: sensitivity(acceleration(s)),
            v: acceleration(v), v_by: sensitivity(acceleration(v)),
        }
    }
}

identities!(
    loops_of_three_rows, Rows, phi, angles [psi psi_by, n n_by], lengths [s s_by, v v_by],
    random => Rows {
        crank: near(random, 15.0),
        link: near(random, 60.0),
        base: near_vector(random, [30.0, -15.0, 25.0]).into(),
        one: near(random, 10f64.to_radians()),
        two: near(random, 60f64.to_radians()),
        tilt: near(random, 25f64.to_radians()),
        shadow: near(random, 15.0),
        far: near_vector(random, [90.0, 70.0, 80.0]).into(),
    },
    random.angle(),
    |m| {
        let angles = [m.one, m.two, m.tilt, m.shadow];
        [&[m.crank, m.link][..], m.base.as_slice(), &angles, m.far.as_slice()].concat()
    }
);

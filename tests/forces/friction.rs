//! Friction against formulas of friction circles and wedges, against a plain iteration on Newton's and Euler's equations, and by powers.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, flat, pin};

interpreted! {
    /// A rod without mass between a crank and a piston that a force pushes.
    pub struct Circles {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param mu1 = 0.12; param mu2 = 0.2; param mu3 = 0.15; param mu4 = 0;
        param r1 = 12mm; param r2 = 10mm; param r3 = 8mm;
        argument push = 500N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = -10deg;
        unknown x = 150mm;
        let p2 = polar(a, phi);
        let p3 = (x, 0);
        loop p2 + polar(b, theta) = p3;
        body crank = pin b1 on frame at (0mm, 0mm), turns phi;
        body rod = pin b2 on crank at p2, turns theta;
        body piston = slide b4 on frame at p3 along (1, 0);
        pin b3 = rod on piston at p3;
        force (-push, 0) on piston at p3;
        friction mu1 on b1, radius r1;
        friction mu2 on b2, radius r2;
        friction mu3 on b3, radius r3;
        friction mu4 on b4;
    }
    impl Circles {
        pub fn motion(phi) -> CirclesMotion { theta, w: velocity(theta) }
        pub fn forces(phi, omega, push) -> CirclesForces { t: torque(phi), f3: reaction(b3), f4: reaction(b4), p: friction_power(), e: efficiency() }
        pub fn torque(phi, omega, push) -> CirclesTorque { t: torque(phi) }
        pub fn statics(phi, push) -> CirclesStatics { t: torque(phi) }
    }
}

/// Lines of force touch the friction circles at both ends of the rod.
#[test]
fn rods_between_friction_circles() {
    let m = Circles::default();
    let linkage = m.assemble().expect("an assembly");
    for (step, omega) in (0..72).flat_map(|step| [(step, 3.0_f64), (step, -0.1)]) {
        let phi = 0.04 + 5_f64.to_radians() * f64::from(step);
        let at = linkage.motion(phi);
        let sense = omega.signum();
        let [s1, s2, s3] = [sense, (at.w - 1.0).signum() * sense, at.w.signum() * sense];
        let [c1, c2, c3] = [m.mu1 * m.r1, m.mu2 * m.r2, m.mu3 * m.r3];
        let line = at.theta - ((c2 * s2 + c3 * s3) / m.b).asin();
        let force = 500.0 / line.cos();
        let torque = force * (m.a * (line - phi).sin() - c2 * s2 + c1 * s1);
        let found = linkage.forces(phi, omega, 500.0);
        assert!(
            (found.t - torque).abs() < 1e-11 * (500.0 * m.a),
            "{phi} {omega}: {} {torque}",
            found.t
        );
        let size = found.f3.norm();
        assert!((size - force).abs() < 1e-12 * force, "{size} {force}");
        let useful = linkage.statics(phi, 500.0).t * omega;
        let lost = force * (c1 + c2 * (at.w - 1.0).abs() + c3 * at.w.abs()) * omega.abs();
        assert!((found.p - lost).abs() < 1e-12 * lost, "{} {lost}", found.p);
        assert!((found.t * omega - useful - lost).abs() < 1e-12 * (500.0 * m.a * omega.abs()));
        let efficiency = if useful >= 0.0 {
            useful / (useful + lost)
        } else {
            (useful + lost) / useful
        };
        assert!(
            (found.e - efficiency).abs() < 1e-9 * efficiency.abs().max(1.0),
            "{} {efficiency}",
            found.e
        );
        // By virtual work alone.
        let alone = linkage.torque(phi, omega, 500.0).t;
        assert!((alone - torque).abs() < 1e-11 * (500.0 * m.a));
    }
    // At rest nothing slides.
    let rest = linkage.torque(1.0, 0.0, 500.0).t;
    assert_eq!(rest, linkage.statics(1.0, 500.0).t);
}

/// The normal force of a guide as that of a wedge: `tan` of the rod's angle times a force that friction itself changes.
#[test]
fn pistons_in_a_rough_guide() {
    let [mu1, mu2, mu3] = [0.0; 3];
    let steep = 40_f64;
    for (mu4, b) in [(0.3, 120.0), (2.0, 55.0)] {
        let m = Circles {
            mu1,
            mu2,
            mu3,
            mu4,
            b,
            ..Circles::default()
        };
        let linkage = m.assemble().expect("an assembly");
        for (phi, omega) in [
            (steep.to_radians(), 1.0),
            (steep.to_radians(), -1.0),
            (-1.1, 0.7),
            (2.5, 5.0),
            (2.5, -5.0),
        ] {
            let at = linkage.motion(phi);
            let speed = -m.a * phi.sin() - m.b * at.theta.sin() * at.w;
            let sense = (speed * omega).signum();
            // Along the rod: S cos(theta) = F + mu |S sin(theta)| sense.
            let rest = at.theta.cos() - mu4 * at.theta.sin().abs() * sense;
            let found = linkage.forces(phi, omega, 500.0);
            if rest <= 0.0 {
                assert!(
                    found.t.is_nan() && found.e.is_nan() && found.f4.y.is_nan(),
                    "{found:?}"
                );
                continue;
            }
            let force = 500.0 / rest;
            let torque = force * m.a * (at.theta - phi).sin();
            assert!(
                (found.t - torque).abs() < 1e-11 * torque.abs(),
                "{} {torque}",
                found.t
            );
            assert!(
                (found.f4.y - force * at.theta.sin().abs() * found.f4.y.signum()).abs()
                    < 1e-11 * force
            );
        }
    }
    // A rod at 45 degrees and more pushes the piston into a guide with the coefficient 2.
    let m = Circles {
        mu1,
        mu2,
        mu3,
        mu4: 2.0,
        b: 55.0,
        ..Circles::default()
    };
    let linkage = m.assemble().expect("an assembly");
    assert!(
        linkage.forces(-1.1, 0.7, 500.0).t.is_nan() != linkage.forces(-1.1, -0.7, 500.0).t.is_nan()
    );
}

#[test]
fn no_coefficient_is_no_friction() {
    let m = Circles {
        mu1: 0.0,
        mu2: 0.0,
        mu3: 0.0,
        ..Circles::default()
    };
    let linkage = m.assemble().expect("an assembly");
    for phi in [0.3, 1.7, 4.0] {
        let [with, without] = [
            linkage.torque(phi, 2.0, 500.0).t,
            linkage.statics(phi, 500.0).t,
        ];
        assert!(
            (with - without).abs() <= 1e-15 * 500.0 * m.a,
            "{with} {without}"
        );
        let found = linkage.forces(phi, 2.0, 500.0);
        assert!((found.e - 1.0).abs() < 1e-15 && found.p == 0.0);
    }
    // No load, no weight: no force that could cause friction.
    let idle = Circles::default()
        .assemble()
        .expect("an assembly")
        .forces(1.0, 2.0, 0.0);
    assert_eq!((idle.t, idle.p), (0.0, 0.0));
}

interpreted! {
    /// Weight on an incline, moved along it.
    pub struct Incline {
        unit mm;
        param lean = 20deg;
        param mu = 0.3;
        input way = 10mm in 0mm..100mm at v, a;
        gravity = (0, -10m/s^2);
        body block = slide guide on frame at way * dir(lean) along dir(lean), mass 2kg at way * dir(lean);
        friction mu on guide;
    }
    impl Incline {
        pub fn forces(way, v, a) -> InclineForces { f: force(way), n: reaction(guide) }
        pub fn efficiency(way, v) -> InclineEfficiency { e: efficiency() }
        pub fn slide(way, v) -> InclineSlide { a: driven_acceleration(way) }
    }
}

#[test]
fn inclines_lock_themselves_at_the_angle_of_friction() {
    let (weight, mu) = (20.0, 0.3_f64);
    for lean in [0.05, 0.2, mu.atan() - 1e-9, mu.atan() + 1e-9, 0.5, 1.0] {
        let incline = Incline { lean, mu }.assemble().expect("an incline");
        let (sin, cos) = f64::sin_cos(lean);
        for v in [1.0, -2.0, 0.0] {
            let sense = if v == 0.0 { 0.0 } else { f64::signum(v) };
            let force = weight * (sin + mu * cos * sense);
            let found = incline.forces(10.0, v, 300.0);
            assert!((found.f - force - 0.6).abs() < 1e-12, "{}", found.f);
            assert!((found.n.norm() - weight * cos).abs() < 1e-12);
            let acceleration = incline.slide(10.0, v).a;
            assert!(
                (acceleration + 1e4 * (sin + mu * cos * sense)).abs() < 1e-8,
                "{acceleration}"
            );
        }
        let up = incline.efficiency(10.0, 1.0).e;
        assert!((up - sin / (sin + mu * cos)).abs() < 1e-14);
        let down = incline.efficiency(10.0, -1.0).e;
        assert!((down - (1.0 - mu * cos / sin)).abs() < 1e-13, "{down}");
        assert_eq!(down > 0.0, lean > mu.atan());
    }
}

interpreted! {
    /// A machine with masses: pins on the frame, between links and at the piston, a block that tilts in its guide, a driven dyad.
    pub struct Greased {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param lean = 10deg;
        param offset = 5mm;
        param m1 = 130g; param m2 = 90g; param m3 = 0.5kg;
        param i2 = 150000g*mm^2;
        param mu = 0.1;
        param r1 = 9mm; param r2 = 8mm; param r3 = 6mm;
        param block = 50mm;
        argument press = 50N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = -10deg;
        unknown x = 150mm;
        let p2 = polar(a, phi);
        let p3 = x * dir(lean) + polar(offset, lean + 90deg);
        loop p2 + polar(b, theta) = p3;
        let c1 = polar(a / 4, phi);
        let c2 = p2 + polar(b / 3, theta);
        let tip = p3 + polar(30mm, lean + 40deg);
        gravity = (0, -9.80665m/s^2);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at c1;
        body rod = pin b2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
        body slider = slide b4 on frame at p3 along dir(lean), mass m3 at tip;
        pin b3 = rod on slider at p3;
        force (-press, press / 4) on slider at tip;
        friction mu on b1, radius r1;
        friction 1.2 * mu on b2, radius r2;
        friction mu on b3, radius r3;
        friction 0.7 * mu on b4, length block;
    }
    impl Greased {
        pub fn forces(phi, omega, epsilon, press) -> GreasedForces {
            f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), m4: moment(b4), t: torque(phi), p: power(), lost: friction_power(),
        }
        pub fn motion(phi) -> GreasedMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), w2: velocity(theta), e2: acceleration(theta),
            p3, v3: velocity(p3), a3: acceleration(p3), c1, c2, tip, x, vx: velocity(x),
        }
        pub fn free(phi, omega, press) -> GreasedFree { a: driven_acceleration(phi) }
        pub fn equation(phi, omega, epsilon, press) -> GreasedEquation { j: inertia(phi), h: bias(phi), q: generalised_force(phi), t: torque(phi) }
        pub fn slopes(phi, omega, epsilon, press) -> GreasedSlopes {
            t: torque(phi), f: reaction(b4), tv: velocity(torque(phi)), fv: velocity(reaction(b4)), ta: acceleration(torque(phi)),
            ts: sensitivity(torque(phi)), lv: velocity(friction_power()),
        }
        pub fn free_slopes(phi, omega, press) -> GreasedFreeSlopes { a: driven_acceleration(phi), av: velocity(driven_acceleration(phi)), s: sensitivity(driven_acceleration(phi)) }
    }
}

/// The machine without friction.
fn frictionless(m: &Greased, at: &GreasedMotion, rate: Rate, press: f64) -> Instant {
    super::slider_crank::bodies!(m, at, rate, press).0
}

/// The contact forces of the four joints that some reactions are.
fn contact_forces(m: &Greased, found: &super::solution::Solution) -> [f64; 4] {
    let way = Vector::new(m.lean.cos(), m.lean.sin(), 0.0);
    let normal = way.cross(&found.forces[3]).z;
    let couple = found.couple(3).z / m.block;
    let [a, b, c] = [0, 1, 2].map(|joint| found.forces[joint].norm());
    [
        a,
        b,
        c,
        (normal / 2.0 + couple).abs() + (normal / 2.0 - couple).abs(),
    ]
}

#[test]
fn machines_with_masses() {
    each(0x5f, |m: Greased, random| {
        // Coefficients are numbers like any; the masses differ by more.
        let m = Greased {
            mu: random.between(0.02, 0.25),
            ..m
        };
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, press) = (random.turn(), Rate::any(random), random.load(50.0));
        let at = linkage.motion(phi);
        let all = frictionless(&m, &at, rate, press);
        let turns = [1.0, at.w2 - 1.0, at.w2];
        let way = Vector::new(m.lean.cos(), m.lean.sin(), 0.0);
        let senses = turns.map(|turn| (turn * rate.omega).signum());
        let along = (at.vx * rate.omega).signum();
        let ends = [[Some(0), None], [Some(1), Some(0)], [Some(1), Some(2)]];
        let arms = [m.mu * m.r1, 1.2 * m.mu * m.r2, m.mu * m.r3];
        let mut sizes = [0.0; 4];
        let mut last = (all.clone(), all.solve());
        let mut ended = false;
        for _ in 0..400 {
            let mut loaded = all.clone();
            for k in 0..3 {
                loaded.couple(ends[k], Vector::z() * (-arms[k] * sizes[k] * senses[k]));
            }
            loaded.pair(
                [Some(2), None],
                flat(at.p3),
                way * (-0.7 * m.mu * sizes[3] * along),
            );
            let solution = loaded.solve();
            let next = contact_forces(&m, &solution);
            let change: f64 = next.iter().zip(&sizes).map(|(a, b)| (a - b).abs()).sum();
            ended = change <= 1e-14 * next.iter().sum::<f64>();
            (sizes, last) = (next, (loaded, solution));
            if ended {
                break;
            }
        }
        let found = linkage.forces(phi, rate.omega, rate.epsilon, press);
        if !ended || found.t.is_nan() {
            // Masses of any proportion can jam.
            return false;
        }
        let (loaded, solution) = last;
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(3, found.m4);
        solution.expect_torque(solution.drive(0), found.t);
        solution.expect_power(solution.power(&loaded), found.p, rate.omega);
        let lost: f64 = (0..3)
            .map(|k| arms[k] * sizes[k] * (turns[k] * rate.omega).abs())
            .sum();
        let lost = lost + 0.7 * m.mu * sizes[3] * (at.vx * rate.omega).abs();
        solution.expect_power(lost, found.lost, rate.omega);

        // The equation of motion, with the friction of this acceleration.
        let equation = linkage.equation(phi, rate.omega, rate.epsilon, press);
        let sum = equation.j * 1e-3 * rate.epsilon + equation.h - equation.q;
        solution.expect_torque(equation.t, sum);
        // Without a drive no torque is left.
        let free = linkage.free(phi, rate.omega, press).a;
        let rest = linkage.forces(phi, rate.omega, free, press);
        if free.is_finite() && rest.t.is_finite() {
            let size = 40.0 * (rest.f1.norm() + rest.f2.norm());
            assert!(rest.t.abs() < 1e-9 * size, "{} of {size}", rest.t);
        }
        true
    });
}

/// Derivatives by differences of order four.
#[test]
fn derivatives_follow_the_contact_forces() {
    let m = Greased::default();
    let linkage = m.assemble().expect("an assembly");
    let step = 1e-3;
    let difference = |f: &dyn Fn(f64) -> f64, step: f64| {
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| f(k * step));
        (8.0 * (c - b) - (d - a)) / (12.0 * step)
    };
    for phi in [0.4, 1.3, 2.8, 5.1] {
        let (omega, epsilon, press) = (20.0, 100.0, 80.0);
        let at = linkage.slopes(phi, omega, epsilon, press);
        let near = |x: f64| linkage.slopes(phi + x, omega, epsilon, press);
        let close = |slope: f64, other: f64, size: f64| {
            assert!(
                (slope - other).abs() < 1e-7 * size.abs().max(other.abs()),
                "{slope} {other}"
            );
        };
        close(at.tv, difference(&|x| near(x).t, step), at.t);
        close(at.ta, difference(&|x| near(x).tv, step), at.tv);
        close(at.fv.y, difference(&|x| near(x).f.y, step), at.f.y);
        close(
            at.lv,
            difference(
                &|x| linkage.forces(phi + x, omega, epsilon, press).lost,
                step,
            ),
            at.lv,
        );
        let free = linkage.free_slopes(phi, omega, press);
        close(
            free.av,
            difference(&|x| linkage.free_slopes(phi + x, omega, press).a, step),
            free.a,
        );
        let values = linkage::Dimensions::values(&m);
        for (index, &value) in values.iter().enumerate() {
            let changed = |x: f64| {
                let mut values = values;
                values[index] = value + x;
                let changed: Greased = linkage::Dimensions::from_values(&values);
                changed.assemble().expect("an assembly")
            };
            let step = 1e-4 * value;
            let torque = difference(&|x| changed(x).slopes(phi, omega, epsilon, press).t, step);
            close(at.ts[index], torque, at.t / value);
            let acceleration = difference(&|x| changed(x).free(phi, omega, press).a, step);
            close(free.s[index], acceleration, free.a / value);
        }
    }
}

interpreted! {
    /// Two links, each with a drive, and friction in both pins.
    pub struct Arm {
        unit mm;
        param mu = 0.3;
        param payload = 2kg;
        input one = 20deg in -90deg..90deg at one_speed, one_gain;
        input two = 60deg in -90deg..90deg at two_speed, two_gain;
        let elbow = polar(300mm, one);
        let hand = elbow + polar(250mm, two);
        gravity = (0, -9.80665m/s^2);
        body upper = pin shoulder on frame at (0mm, 0mm), turns one, mass 3kg at elbow / 2, inertia 9000kg*mm^2;
        body lower = pin joint on upper at elbow, turns two, mass 2kg at (elbow + hand) / 2, mass payload at hand, inertia 9000kg*mm^2;
        friction mu on shoulder, radius 20mm;
        friction mu on joint, radius 15mm;
    }
    impl Arm {
        pub fn drives(one, two, one_speed, one_gain, two_speed, two_gain) -> ArmDrives {
            one: torque(one), two: torque(two), p: power(), lost: friction_power(), f1: reaction(shoulder), f2: reaction(joint),
        }
        pub fn free(one, two, one_speed, two_speed) -> ArmFree { one: driven_acceleration(one), two: driven_acceleration(two) }
        pub fn still(one, two, one_gain, two_gain) -> ArmStill { one: torque(one), two: torque(two) }
    }
}

/// Several inputs: without drives no torque is left, and friction takes the power of its couples.
#[test]
fn arms_with_two_drives() {
    let arm = Arm::default().assemble().expect("an arm");
    for (one_speed, two_speed) in [(3.0, 5.0), (-3.0, 5.0), (4.0, 4.0), (2.0, -7.0)] {
        let free = arm.free(0.3, 1.1, one_speed, two_speed);
        let at = arm.drives(0.3, 1.1, one_speed, free.one, two_speed, free.two);
        let size = at.f1.norm() * 20.0;
        assert!(
            at.one.abs() < 1e-10 * size && at.two.abs() < 1e-10 * size,
            "{at:?}"
        );
        let relative: f64 = two_speed - one_speed;
        let lost =
            0.3 * (20.0 * at.f1.norm() * one_speed.abs() + 15.0 * at.f2.norm() * relative.abs());
        assert!((at.lost - lost).abs() < 1e-12 * lost, "{} {lost}", at.lost);
    }
    // The couple in the elbow acts on both links.
    let at = arm.drives(0.3, 1.1, 1e-9, 0.0, 2e-9, 0.0);
    let still = arm.still(0.3, 1.1, 0.0, 0.0);
    let couples = [0.3 * 20.0 * at.f1.norm(), 0.3 * 15.0 * at.f2.norm()];
    assert!((at.two - still.two - couples[1]).abs() < 1e-9);
    assert!((at.one - still.one - couples[0] + couples[1]).abs() < 1e-9);
}

interpreted! {
    /// The same machine by joints and links.
    pub struct Linked {
        unit mm;
        argument push = 500N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        joint b1 = (0mm, 0mm), b2 = polar(40mm, 40deg), b3 = (145mm, 0mm), far = (175mm, 0mm);
        link frame: b1;
        link crank: b1, b2 at phi length 40mm;
        link rod: b2, b3 length 120mm;
        link piston: b3, far;
        slider b4: b3 on frame along 0deg through b1, block piston;
        force (-push, 0N) on piston at b3;
        friction 0.12 on b1, radius 12mm;
        friction 0.2 on b2, radius 10mm;
        friction 0.15 on b3, radius 8mm;
        friction 0.1 on b4;
    }
    impl Linked {
        pub fn forces(phi, omega, push) -> LinkedForces { t: torque(phi), p: friction_power() }
    }
    /// Two of them side by side, one shaft.
    pub struct Twins {
        unit mm;
        argument push = 500N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        part left: Linked { phi = phi, push = push };
        part right: Linked { phi = phi, push = push } at (0mm, 80mm), turned by 90deg;
    }
    impl Twins {
        pub fn forces(phi, omega, push) -> TwinsForces { t: torque(phi), p: friction_power() }
    }
}

#[test]
fn links_and_parts_have_the_same_friction() {
    let m = Circles {
        mu4: 0.1,
        ..Circles::default()
    };
    let loops = m.assemble().expect("an assembly");
    let linked = Linked::default().assemble().expect("an assembly");
    let twins = Twins::default().assemble().expect("an assembly");
    for (phi, omega) in [(0.4, 3.0), (2.0, -1.0), (4.4, 0.2)] {
        let expected = loops.forces(phi, omega, 500.0);
        let found = linked.forces(phi, omega, 500.0);
        assert!(
            (found.t - expected.t).abs() < 1e-11 * expected.t.abs(),
            "{} {}",
            found.t,
            expected.t
        );
        assert!((found.p - expected.p).abs() < 1e-12 * expected.p);
        let both = twins.forces(phi, omega, 500.0);
        assert!(
            (both.t - 2.0 * expected.t).abs() < 1e-11 * expected.t.abs(),
            "{}",
            both.t
        );
        assert!((both.p - 2.0 * expected.p).abs() < 1e-12 * expected.p);
    }
}

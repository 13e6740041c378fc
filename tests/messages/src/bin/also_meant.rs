//! What the language page says beside its program.

use linkage::mechanism;
use std::f64::consts::{PI, TAU};

mechanism! {
    #[allow(unused)]
    pub struct Defaults {
        unit mm;
        const half = 10mm;
        param base = sqrt(2) * 10mm;
        param twice = 2 * half +- half / 1000;
        param vector = (base_length, 2 * half) +- 0.1mm;
        const base_length = hypot(3mm, 4mm);
        param spaced = 50mm + - 12um;
        param unspaced = 50mm+-12um;
        param sum = 50mm + 2mm - 1mm +- 12um;
        param turned = (1mm, 2mm, 3mm) +- (1um, 2um, 3um);
        param angle = PI / 6;
        param suffixes = 1m + 1cm + 1mm + 1um + 1nm + 1inch;
        param angles = 1deg + 1rad + 1arcmin + 1arcsec + 1turn;
        param zero = 0mm;
        param negative = -3mm;
        // One name in two spellings: with a letter that has an accent, and with an accent of its own.
        param réglé = 7mm;
        input phi = 30deg;
        let free = phi + PI / 2 + 2 * phi + 0.3;
        let shifted = vector + 0;
        let list = triangle_angle(3, 4, 5) + acos(0.5) + atan2(1mm, 2mm) + angle((1, 1)) + min(1, 2) + max(1, 2) + abs(-1);
        let règle = réglé * 2;
        let turned_once = turn(turned, (0, 0, 1), phi);
    }

    impl Defaults {
        pub fn values(phi) -> Values { free, shifted, s: sin(0.3rad) * sin(angle), list, turned_once, z: turned_once.z }
    }
}

mechanism! {
    /// A range over several turns; the frame left out of the loop; unknown angles in sums.
    pub struct Sums {
        unit mm;
        param crank = 20mm;
        param delta = 10deg;
        input phi = 400deg in -720deg..3 * 360deg;
        unknown theta = -26deg;
        unknown s = 80mm;
        let a = rotate((crank, 0), phi + delta);
        let b = rotate((60mm, 5mm), theta + delta);
        loop a + b - (s, 3mm) = 0;
        let bar = a + rotate((10mm, 1mm), theta - phi);
    }

    impl Sums {
        pub fn all(phi) -> SumsAll { theta, s, bar, s_prime: d(s, phi), m: margin(), }
    }
}

mechanism! {
    /// Scalar loops: a guide by a dot product, a distance, an angle relation; points as unknowns.
    pub struct Scalars {
        unit mm;
        param rod = 60mm;
        input phi = 40deg in 0deg..360deg;
        unknown p = (70mm, 0mm);
        unknown follower = 80deg;
        let a = polar(20mm, phi);
        let normal = dir(90deg);
        loop dot(normal, p) = 0;
        loop distance(a, p) = rod;
        loop follower = 2 * phi;
    }

    impl Scalars {
        pub fn point(phi) -> Point { p, follower, speed: norm(velocity(p)), inverse: 1 / d(follower, phi) }
    }
}

mechanism! {
    /// Two inputs: arrays of derivatives; mixed second derivatives; entries of arrays.
    pub struct Robot {
        param upper = 0.3m;
        param lower = 0.2m;
        input alpha = 30deg in 0deg..90deg;
        input beta = 40deg;
        let tip = polar(upper, alpha) + polar(lower, alpha + beta);
    }

    impl Robot {
        pub fn tip(alpha, beta) -> RobotTip {
            tip,
            v: velocity(tip),
            a: acceleration(tip),
            mixed: d(tip, alpha, lower),
            e: sensitivity(velocity(tip), [upper]),
            f: sensitivity(tip),
            one: velocity(tip)[1].x,
        }
        pub fn elbow(alpha) -> Elbow { elbow: polar(upper, alpha) }
        pub fn swapped(beta, alpha) -> Swapped { tip }
    }
}

mechanism! {
    /// No estimate is needed where there is one assembly, or where others choose.
    pub struct Estimated {
        unit mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta;
        unknown psi = 70deg;
        loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
        unknown between;
        loop between = psi - theta;
        unknown gear;
        loop gear = 2 * phi + 100deg;
        unknown across;
        unknown along;
        loop polar(30mm, phi) = (along, across);
        unknown middle;
        loop middle = ((along, across) + (100mm, 0)) / 2;
    }

    impl Estimated {
        pub fn all(phi) -> AllEstimated { theta, psi, between, gear, across, along, middle, v: velocity(between) }
    }
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}

fn main() {
    let d = Defaults::default();
    near(d.base, 200f64.sqrt());
    near(d.vector.x, 5.0);
    near(d.sum, 51.0);
    near(d.spaced, 50.0);
    near(d.unspaced, 50.0);
    near(d.suffixes, 1000.0 + 10.0 + 1.0 + 1e-3 + 1e-6 + 25.4);
    near(d.turned.z, 3.0);
    let tolerance = |name| {
        let mut found = Defaults::PARAMETERS.iter().filter(|p| p.name == name);
        found.next().map_or(f64::NAN, |p| p.tolerance)
    };
    near(tolerance("twice"), 0.01);
    near(tolerance("vector.y"), 0.1);
    near(tolerance("spaced"), 0.012);
    near(tolerance("unspaced"), 0.012);
    near(tolerance("sum"), 0.012);
    near(tolerance("turned.z"), 0.003);
    near(tolerance("base"), 0.0);
    let values = d.assemble().expect("no loop").values(1.0);
    near(values.free, 3.0 + PI / 2.0 + 0.3);
    near(values.turned_once.z, 3.0);
    near(values.turned_once.x, 1f64.cos() - 2.0 * 1f64.sin());
    near(
        values.list,
        PI / 2.0 + PI / 3.0 + 0.5f64.atan() + PI / 4.0 + 1.0 + 2.0 + 1.0,
    );

    let sums = Sums::default().assemble().expect("it closes");
    let (here, later) = (sums.all(0.3), sums.all(0.3 + TAU));
    near(here.s, later.s);
    near(here.theta, later.theta);

    let estimated = Estimated::default().assemble().expect("it closes");
    let at = estimated.all(60f64.to_radians());
    near(20.0 + 120.0 * at.theta.cos(), 100.0 + 80.0 * at.psi.cos());
    assert!(at.theta > 0.0 && at.psi > 0.0);
    near(at.between, at.psi - at.theta);
    near(at.gear.to_degrees(), 220.0);
    near(at.along, 15.0);
    near(at.middle.x, 57.5);
    near(at.middle.y, at.across / 2.0);

    let scalars = Scalars::default().assemble().expect("it closes");
    let point = scalars.point(0.7);
    near(
        point.p.x,
        20.0 * 0.7f64.cos() + (3600.0 - (20.0 * 0.7f64.sin()).powi(2)).sqrt(),
    );
    near(point.follower, 1.4);
    near(point.inverse, 0.5);

    let robot = Robot::default().assemble().expect("no loop");
    let tip = robot.tip(0.3, 0.4);
    near(tip.v[1].x, -0.2 * 0.7f64.sin());
    near(tip.one, tip.v[1].x);
    near(tip.a[0][1].y, tip.a[1][0].y);
    near(tip.mixed.y, 0.7f64.cos());
    near(tip.e[0][0].y, 0.3f64.cos());
    near(robot.swapped(0.4, 0.3).tip.x, tip.tip.x);
    near(robot.elbow(0.3).elbow.x, 0.3 * 0.3f64.cos());
}

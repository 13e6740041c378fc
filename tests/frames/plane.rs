//! Frames of the plane: given ones, and bodies as unknowns, beside the same mechanisms written with points and angles.

use linkage::{Vector2, mechanism};

mechanism! {
    pub struct Body {
        unit mm;
        param crank = 40mm;
        param rod = 120mm;
        param tracer = (60mm, 20mm);
        input phi = 40deg in 0deg..360deg;
        unknown coupler = frame((30mm, 25mm), (1, 0.3));
        loop coupler.origin = polar(crank, phi);
        loop distance(point_in(coupler, (rod, 0mm)), (100mm, 0mm)) = 80mm;
        let tip = point_in(coupler, tracer);
    }
    impl Body {
        pub fn motion(phi) -> Motion {
            tip, angle: coupler.angle, speed: velocity(tip), x: coupler.x, y: coupler.y, own: coordinates_in(coupler, tip),
            e: sensitivity(tip),
        }
        /// The pose, and how it turns.
        pub fn pose(phi) -> BodyPose { coupler, turn: omega(coupler), bend: alpha(coupler), first: velocity(coupler.angle) }
    }
}

mechanism! {
    pub struct Angle {
        unit mm;
        param crank = 40mm;
        param rod = 120mm;
        param tracer = (60mm, 20mm);
        input phi = 40deg in 0deg..360deg;
        unknown theta = 16deg;
        unknown psi = 60deg;
        let pin = polar(crank, phi);
        loop pin + polar(rod, theta) = (100mm, 0mm) + polar(80mm, psi);
        let tip = pin + rotate(tracer, theta);
        // The same by a frame that is given, in which axes have any length.
        let coupler = frame(pin, polar(3mm, theta));
    }
    impl Angle {
        pub fn motion(phi) -> AngleMotion {
            tip, theta, speed: velocity(tip), e: sensitivity(tip), seen: point_in(coupler, tracer), x: coupler.x,
            angle: coupler.angle,
        }
    }
}

mechanism! {
    /// A platform on three legs: the group of class III that it is when it is written with angles.
    pub struct Platform {
        unit mm;
        param leg = 50mm;
        input phi = 60deg in 20deg..100deg;
        unknown plate = frame((70mm, 50mm), (1, 0.3));
        loop distance(plate.origin, polar(40mm, phi)) = leg;
        loop distance(point_in(plate, (60mm, 0mm)), (120mm, 0mm)) = leg;
        loop distance(point_in(plate, (30mm, 52mm)), (60mm, 110mm)) = leg;
    }
    impl Platform {
        pub fn pose(phi) -> Pose { origin: plate.origin, angle: plate.angle }
    }

    /// The same in a part that is turned.
    pub struct Turned {
        unit mm;
        input phi = 60deg in 20deg..100deg;
        part own: Platform { phi = phi } at (10mm, 20mm), turned by 30deg;
    }
    impl Turned {
        pub fn pose(phi) -> TurnedPose { origin: own.plate.origin, x: own.plate.x }
    }
}

#[track_caller]
fn near(a: Vector2<f64>, b: Vector2<f64>, tolerance: f64) {
    assert!((a - b).norm() <= tolerance, "{a} instead of {b}");
}

#[test]
fn a_body_is_solved_as_a_point_and_an_angle_are() {
    assert_eq!(Body::STRUCTURE.groups[1].kind, "RRR");
    let body = Body::default().assemble().expect("it assembles");
    let angle = Angle::default().assemble().expect("it assembles");
    for k in 0..36 {
        let phi = 0.1 + f64::from(k) * 0.17;
        let (a, b) = (body.motion(phi), angle.motion(phi));
        near(a.tip, b.tip, 1e-13);
        near(a.speed, b.speed, 1e-12);
        near(a.x, Vector2::new(b.theta.cos(), b.theta.sin()), 1e-15);
        near(a.y, Vector2::new(-b.theta.sin(), b.theta.cos()), 1e-15);
        near(a.own, Vector2::new(60.0, 20.0), 1e-13);
        near(b.seen, b.tip, 1e-13);
        near(b.x, a.x, 1e-15);
        assert!((a.angle - b.theta).abs() < 1e-15 && (b.angle - b.theta).abs() < 1e-15);
        assert_eq!(a.e.len(), b.e.len());
        a.e.iter().zip(b.e).for_each(|(a, b)| near(*a, b, 1e-12));
    }
}

#[test]
fn a_platform_is_a_group_of_class_three() {
    let group = &Platform::STRUCTURE.groups[0];
    assert_eq!((group.kind, group.class, group.order), ("RR-RR-RR", 3, 3));
    let platform = Platform::default().assemble().expect("it assembles");
    let turned = Turned::default().assemble().expect("it assembles");
    for k in 0..=8 {
        let phi = 0.4 + 0.15 * f64::from(k);
        let pose = platform.pose(phi);
        let (sin, cos) = pose.angle.sin_cos();
        let at = |x: f64, y: f64| pose.origin + Vector2::new(x * cos - y * sin, x * sin + y * cos);
        let ends = [
            (at(0.0, 0.0), 40.0 * Vector2::new(phi.cos(), phi.sin())),
            (at(60.0, 0.0), Vector2::new(120.0, 0.0)),
            (at(30.0, 52.0), Vector2::new(60.0, 110.0)),
        ];
        ends.into_iter()
            .for_each(|(a, b)| assert!(((a - b).norm() - 50.0).abs() < 1e-13));
        let seen = turned.pose(phi);
        let (s, c) = 30_f64.to_radians().sin_cos();
        let turn = |v: Vector2<f64>| Vector2::new(c * v.x - s * v.y, s * v.x + c * v.y);
        near(
            seen.origin,
            turn(pose.origin) + Vector2::new(10.0, 20.0),
            1e-12,
        );
        near(seen.x, turn(Vector2::new(cos, sin)), 1e-14);
    }
}

/// The pose as a motion of the plane takes the body's points where the mechanism has them; it turns as differences of its axes say.
#[test]
fn a_pose_is_a_motion_of_the_plane() {
    const STEP: f64 = 1e-4;
    let linkage = Body::default().assemble().expect("it assembles");
    let tracer = linkage.mechanism().tracer;
    for k in 0..24 {
        let phi = 0.1 + 0.26 * f64::from(k);
        let (pose, motion) = (linkage.pose(phi), linkage.motion(phi));
        let body = pose.coupler;
        let carried = body.isometry() * linkage::nalgebra::Point2::from(tracer);
        assert!((carried.coords - motion.tip).norm() < 1e-13);
        assert!((body.point(tracer) - motion.tip).norm() < 1e-13);
        assert!((body.coordinates(motion.tip) - tracer).norm() < 1e-13);
        assert!((body.x - motion.x).norm() < 1e-15 && (body.y - motion.y).norm() < 1e-15);
        assert!((body.isometry().rotation.angle().sin() - motion.angle.sin()).abs() < 1e-14);
        assert_eq!(pose.turn, pose.first);
        // Turned by d in between: the sine of it is the product of both axes.
        let at = |steps: f64| linkage.pose(phi + steps * STEP);
        let turned = at(-1.0).coupler.x.perp(&at(1.0).coupler.x).asin();
        assert!((turned / (2.0 * STEP) - pose.turn).abs() < 1e-7);
        let bend = (at(1.0).turn - at(-1.0).turn) / (2.0 * STEP);
        assert!((bend - pose.bend).abs() < 1e-6);
    }
    // In a sweep: the columns of origin, x and y, each with two components.
    let poses = linkage.pose_sweep(&[0.8, 0.9]);
    let [origin, x, y]: [[&[f64]; 2]; 3] = poses.coupler();
    let own = linkage.pose(0.9).coupler;
    for (columns, vector) in [(origin, own.origin), (x, own.x), (y, own.y)] {
        (0..2).for_each(|k| assert!((columns[k][1] - vector[k]).abs() < 1e-13));
    }
}

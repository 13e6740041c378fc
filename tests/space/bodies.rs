//! Bodies as unknowns: a platform on six rods that meet by three, two and one.

use linkage::{Screw, Vector3};
use linkage_interpreted::interpreted;
use nalgebra::Rotation3;

use super::{all_solutions, close, differences};

interpreted! {
    pub struct Platform {
        unit mm;
        param far = (60mm, 0mm, 5mm);
        param side = (10mm, 50mm, -8mm);
        param rod = 190mm;
        input lift = 200mm in 190mm..210mm;
        unknown body = frame((3mm, 2mm, 170mm), (1, 0.1, 0), (0, 0.1, 1));
        loop distance(body.origin, (100mm, 0mm, 0mm)) = lift;
        loop distance(body.origin, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(body.origin, (-50mm, -85mm, 0mm)) = 200mm;
        // Points on an axis of the body, so that the groups can be solved one after the other.
        loop distance(point_in(body, (norm(far), 0mm, 0mm)), (80mm, 70mm, 0mm)) = rod;
        loop distance(point_in(body, (norm(far), 0mm, 0mm)), (80mm, -70mm, 0mm)) = rod;
        loop distance(point_in(body, side), (0mm, 80mm, 0mm)) = 180mm;
    }
    impl Platform {
        pub fn pose(lift) -> Pose { body, side: point_in(body, side), m: margin() }
        pub fn motion(lift) -> Motion { v: velocity(point_in(body, side)), a: acceleration(body.z) }
        pub fn origin(lift) -> OriginRate { v: velocity(body.origin) }
        pub fn turning(lift) -> Turning { w: omega(body), e: alpha(body), x: velocity(body.x), z: velocity(body.z) }
        pub fn accuracy(lift) -> Accuracy { s: sensitivity(body.y, [side, rod]) }
        pub fn screw(lift) -> OwnScrew {
            point: screw_point(body), direction: screw_direction(body), pitch: screw_pitch(body),
            moving: velocity(screw_point(body)), growing: velocity(screw_pitch(body)), by_rod: sensitivity(screw_pitch(body), [rod]),
        }
    }
}

interpreted! {
    /// A pendulum that hangs on a ball joint and is held by two rods at points of its y and z axes: its x axis is not asked for.
    pub struct Held {
        unit mm;
        input drive = 100mm in 95mm..105mm;
        unknown body = frame((0mm, 0mm, 300mm), (1, 0, 0), (0, 0, 1));
        loop body.origin = (0mm, 0mm, 300mm);
        loop distance(point_in(body, (0mm, 0mm, -80mm)), (100mm, 0mm, 220mm)) = drive;
        loop distance(point_in(body, (0mm, 0mm, -80mm)), (0mm, -100mm, 220mm)) = 100mm;
        loop distance(point_in(body, (0mm, 60mm, 0mm)), (90mm, 60mm, 300mm)) = 90mm;
    }
    impl Held {
        pub fn pose(drive) -> HeldPose { body }
    }

    /// The same in a frame that is turned.
    pub struct Hung {
        unit mm;
        input drive = 100mm in 95mm..105mm;
        part held: Held { drive = drive } at frame((10mm, 20mm, 30mm), (0, 1, 0), (0, 0, 1));
    }
    impl Hung {
        pub fn pose(drive) -> HungPose { body: held.body, own: held.body.origin }
    }
}

/// By how much the rods miss, for a place and a rotation vector.
fn misses(x: [f64; 6]) -> [f64; 6] {
    let origin = Vector3::new(x[0], x[1], x[2]);
    let turn = Rotation3::new(Vector3::new(x[3], x[4], x[5]));
    let far = origin + turn * Vector3::new(60.0_f64.hypot(5.0), 0.0, 0.0);
    let side = origin + turn * Vector3::new(10.0, 50.0, -8.0);
    let miss =
        |p: Vector3<f64>, [a, b]: [f64; 2], rod: f64| (p - Vector3::new(a, b, 0.0)).norm() - rod;
    [
        miss(origin, [100.0, 0.0], 200.0),
        miss(origin, [-50.0, 85.0], 200.0),
        miss(origin, [-50.0, -85.0], 200.0),
        miss(far, [80.0, 70.0], 190.0),
        miss(far, [80.0, -70.0], 190.0),
        miss(side, [0.0, 80.0], 180.0),
    ]
}

fn place(x: &[f64; 6]) -> (Vector3<f64>, Rotation3<f64>) {
    let turn = Rotation3::new(Vector3::new(x[3], x[4], x[5]));
    (Vector3::new(x[0], x[1], x[2]), turn)
}

#[test]
fn a_body_is_where_its_rods_hold_it() {
    let same = |x: [f64; 6], y: [f64; 6]| {
        let ((p, r), (q, s)) = (place(&x), place(&y));
        (p - q).norm() < 1e-5 && (r.matrix() - s.matrix()).norm() < 1e-5
    };
    let limits = [150.0, 150.0, 250.0, 3.0, 3.0, 3.0];
    let independent = all_solutions(misses, [limits.map(|x| -x), limits], same, 600);
    let assemblies = Platform::default().assemblies().expect("they are listed");
    assert_eq!(assemblies.len(), independent.len());
    assert_eq!(independent.len(), 8);
    for assembly in assemblies {
        let body = assembly.pose(200.0).body;
        let axes = nalgebra::Matrix3::from_columns(&[body.x, body.y, body.z]);
        let is_it = |x: &[f64; 6]| {
            let (origin, turn) = place(x);
            (origin - body.origin).norm() < 1e-9 && (turn.matrix() - axes).norm() < 1e-10
        };
        assert!(independent.iter().any(is_it));
        close(
            (axes * axes.transpose() - nalgebra::Matrix3::identity()).norm(),
            0.0,
            1e-14,
        );
        close(axes.determinant(), 1.0, 1e-14);
    }
}

#[test]
fn derivatives_of_a_body_are_differences() {
    let platform = Platform::default().assemble().expect("it assembles");
    for k in 0..=10 {
        let lift = 190.5 + 1.9 * f64::from(k);
        let motion = platform.motion(lift);
        for axis in 0..3 {
            let [v, _] = differences(|x| platform.pose(x).side[axis], lift, 1e-4);
            let [_, a] = differences(|x| platform.pose(x).body.z[axis], lift, 1e-2);
            close(motion.v[axis], v, 1e-7);
            close(motion.a[axis], a, 1e-8);
        }
    }
    let accuracy = platform.accuracy(200.0);
    let at = |change: [f64; 4]| {
        let mut platform = Platform::default();
        platform.side += Vector3::new(change[0], change[1], change[2]);
        platform.rod += change[3];
        platform
            .assemble()
            .expect("it assembles")
            .pose(200.0)
            .body
            .y
    };
    for k in 0..4 {
        let step = |size: f64| std::array::from_fn(|i| if i == k { size } else { 0.0 });
        let slope = (at(step(1e-4)) - at(step(-1e-4))) / 2e-4;
        (0..3).for_each(|axis| close(accuracy.s[k][axis], slope[axis], 1e-8));
    }
}

interpreted! {
    /// A body on a ball joint with two inputs, in an order of turns that is known.
    pub struct Wrist {
        unit mm;
        input yaw = 20deg in -60deg..60deg;
        input roll = 10deg in -60deg..60deg;
        const up = (0, 0, 1);
        let axis = turn((1, 0, 0), up, yaw);
        let body = frame((0mm, 0mm, 0mm), axis, turn(up, axis, roll));
    }
    impl Wrist {
        pub fn turning(yaw, roll) -> WristTurning { w: omega(body), e: alpha(body) }
    }
}

#[test]
fn a_body_turns_by_omega() {
    let platform = Platform::default().assemble().expect("it assembles");
    for k in 0..=10 {
        let lift = 190.5 + 1.9 * f64::from(k);
        let (turning, body) = (platform.turning(lift), platform.pose(lift).body);
        close((turning.w.cross(&body.x) - turning.x).norm(), 0.0, 1e-15);
        close((turning.w.cross(&body.z) - turning.z).norm(), 0.0, 1e-15);
        for axis in 0..3 {
            let [e, _] = differences(|x| platform.turning(x).w[axis], lift, 1e-3);
            close(turning.e[axis], e, 1e-9);
        }
    }
    let wrist = Wrist::default()
        .assemble()
        .expect("it assembles")
        .turning(0.3, 0.4);
    let axis = Vector3::new(0.3_f64.cos(), 0.3_f64.sin(), 0.0);
    close((wrist.w[0] - Vector3::z()).norm(), 0.0, 1e-15);
    close((wrist.w[1] - axis).norm(), 0.0, 1e-15);
    // The second axis turns with the first angle, and nothing else does.
    let across = Vector3::new(-axis.y, axis.x, 0.0);
    close((wrist.e[1][0] - across).norm(), 0.0, 1e-15);
    let others = [wrist.e[0][0], wrist.e[0][1], wrist.e[1][1]];
    others.into_iter().for_each(|e| close(e.norm(), 0.0, 1e-15));
}

/// The axis of the rotation and the shift from one pose to another one near it.
fn between(poses: [linkage::Frame; 2], step: f64) -> Screw {
    let [before, after] = poses.map(|own| own.isometry());
    let turn = (after.rotation * before.rotation.inverse()).scaled_axis() / step;
    let shift = (after.translation.vector - before.translation.vector) / step;
    let middle = 0.5 * (after.translation.vector + before.translation.vector);
    Screw::of(turn, shift, middle)
}

#[test]
fn the_screw_of_a_body_is_that_between_two_poses() {
    let platform = Platform::default().assemble().expect("it assembles");
    for k in 0..=10 {
        let lift = 190.5 + 1.9 * f64::from(k);
        let found = platform.screw(lift);
        let poses = [lift - 1e-3, lift + 1e-3].map(|lift| platform.pose(lift).body);
        let known = between(poses, 2e-3);
        close((found.direction - known.direction).norm(), 0.0, 1e-7);
        // Both are the point nearest to the body's origin.
        close((found.point - known.point).norm(), 0.0, 1e-5);
        close(found.pitch, known.pitch(), 1e-6);
        // It moves along itself only.
        let (w, v) = (platform.turning(lift).w, platform.origin(lift).v);
        let own = v + w.cross(&(found.point - platform.pose(lift).body.origin));
        close((own - found.pitch * w).norm(), 0.0, 1e-14);
        for axis in 0..3 {
            let [moving, _] = differences(|x| platform.screw(x).point[axis], lift, 1e-3);
            close(found.moving[axis], moving, 1e-6);
        }
        let [growing, _] = differences(|x| platform.screw(x).pitch, lift, 1e-3);
        close(found.growing, growing, 1e-6);
    }
    let with = |rod: f64| {
        let mut changed = Platform::default();
        changed.rod += rod;
        changed.assemble().expect("it assembles").screw(200.0)
    };
    let slope = (with(1e-3).pitch - with(-1e-3).pitch) / 2e-3;
    close(with(0.0).by_rod[0], slope, 1e-6);
}

#[test]
fn the_axis_that_no_point_needs_is_the_product_of_the_others() {
    let kinds = Held::structure().groups.iter().map(|group| group.unknowns);
    let found: Vec<&str> = kinds.flatten().copied().collect();
    assert_eq!(found, ["body.origin", "body.z", "body.y"]);
    let body = Held::default()
        .assemble()
        .expect("it assembles")
        .pose(97.0)
        .body;
    close((body.y.cross(&body.z) - body.x).norm(), 0.0, 1e-15);
    let low = body.point(Vector3::new(0.0, 0.0, -80.0)) - Vector3::new(100.0, 0.0, 220.0);
    close(low.norm(), 97.0, 1e-14);
}

#[test]
fn a_body_of_a_part_is_seen_from_where_the_part_stands() {
    let held = Held::default()
        .assemble()
        .expect("it assembles")
        .pose(97.0)
        .body;
    let seen = Hung::default().assemble().expect("it assembles").pose(97.0);
    // The part's x axis is y, its y axis is -x.
    let turned = |v: Vector3<f64>| Vector3::new(-v.y, v.x, v.z);
    let pairs = [
        (seen.body.x, held.x),
        (seen.body.y, held.y),
        (seen.body.z, held.z),
    ];
    for (own, axis) in pairs {
        close((own - turned(axis)).norm(), 0.0, 1e-14);
    }
    let origin = turned(held.origin) + Vector3::new(10.0, 20.0, 30.0);
    close((seen.body.origin - origin).norm(), 0.0, 1e-13);
    close((seen.own - origin).norm(), 0.0, 1e-13);
}

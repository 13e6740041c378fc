//! Platforms on six legs from their pose to the drives: feet that slide on rails (hexaglide), and feet on arms that motors turn.

use linkage_interpreted::interpreted;
use nalgebra::{Rotation3, Vector3};

use super::{close, differences};

interpreted! {
    /// Six sleds on two rails along x.
    pub struct Hexaglide {
        unit mm;
        param leg = 560mm;
        param rails = 250mm;                     // each from the middle
        input x = 0mm in -150mm..150mm;
        input y = 0mm in -60mm..60mm;
        input z = 380mm in 340mm..420mm;
        input roll  = 0deg in -15deg..15deg;
        input pitch = 0deg in -15deg..15deg;
        input yaw   = 0deg in -15deg..15deg;
        unknown s1 = 300mm;
        unknown s2 = 300mm;
        unknown s3 = 100mm;
        unknown s4 = -100mm;
        unknown s5 = -300mm;
        unknown s6 = -300mm;
        let ex = turn(turn(turn((1, 0, 0), (0, 0, 1), yaw), (0, 1, 0), pitch), (1, 0, 0), roll);
        let ez = turn(turn(turn((0, 0, 1), (0, 0, 1), yaw), (0, 1, 0), pitch), (1, 0, 0), roll);
        let body = frame((x, y, z), ex, ez);
        loop distance((s1, rails, 0mm), point_in(body, (90mm, 60mm, 0mm))) = leg;
        loop distance((s2, -rails, 0mm), point_in(body, (90mm, -60mm, 5mm))) = leg;
        loop distance((s3, rails, 0mm), point_in(body, (-80mm, 75mm, -5mm))) = leg;
        loop distance((s4, -rails, 0mm), point_in(body, (80mm, -75mm, 0mm))) = leg;
        loop distance((s5, rails, 0mm), point_in(body, (-90mm, 60mm, 8mm))) = leg;
        loop distance((s6, -rails, 0mm), point_in(body, (-90mm, -60mm, 0mm))) = leg;
    }
    impl Hexaglide {
        pub fn sleds(x, y, z, roll, pitch, yaw) -> Sleds { s1, s2, s3, s4, s5, s6 }
        pub fn rates(x, y, z, roll, pitch, yaw) -> SledRates {
            s1: velocity(s1), s2: velocity(s2), s3: velocity(s3), s4: velocity(s4), s5: velocity(s5), s6: velocity(s6),
        }
    }
}

/// Joints on the platform, and on which side of them, along x, the sleds are.
const JOINTS: [([f64; 3], f64); 6] = [
    ([90.0, 60.0, 0.0], 1.0),
    ([90.0, -60.0, 5.0], 1.0),
    ([-80.0, 75.0, -5.0], 1.0),
    ([80.0, -75.0, 0.0], -1.0),
    ([-90.0, 60.0, 8.0], -1.0),
    ([-90.0, -60.0, 0.0], -1.0),
];

/// Places of the joints for a pose: x, y, z, then roll, pitch and yaw.
fn joint(pose: [f64; 6], own: [f64; 3]) -> Vector3<f64> {
    let [x, y, z, roll, pitch, yaw] = pose;
    let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), roll)
        * Rotation3::from_axis_angle(&Vector3::y_axis(), pitch)
        * Rotation3::from_axis_angle(&Vector3::z_axis(), yaw);
    Vector3::new(x, y, z) + turn * Vector3::from(own)
}

/// Where a sled is, by Pythagoras.
fn sled(pose: [f64; 6], leg: usize) -> f64 {
    let (own, side) = JOINTS[leg];
    let joint = joint(pose, own);
    let rail = 250.0_f64.copysign(own[1]);
    let along = 560.0 * 560.0 - (joint.y - rail).powi(2) - joint.z * joint.z;
    joint.x + side * along.sqrt()
}

fn poses() -> impl Iterator<Item = [f64; 6]> {
    (0..40).map(|k| {
        let t = 0.41 * f64::from(k);
        [
            140.0 * t.sin(),
            55.0 * (2.0 * t).cos(),
            380.0 + 35.0 * (3.0 * t).sin(),
            0.22 * (1.3 * t).cos(),
            0.2 * (1.7 * t).sin(),
            0.25 * (0.7 * t).cos(),
        ]
    })
}

#[test]
fn sleds_are_where_their_legs_reach_the_rails() {
    let glide = Hexaglide::default().assemble().expect("it assembles");
    assert!(
        Hexaglide::structure()
            .groups
            .iter()
            .all(|own| own.kind == "SSP")
    );
    for pose in poses() {
        let [x, y, z, roll, pitch, yaw] = pose;
        let found = glide.sleds(x, y, z, roll, pitch, yaw);
        let found = [found.s1, found.s2, found.s3, found.s4, found.s5, found.s6];
        let rates = glide.rates(x, y, z, roll, pitch, yaw);
        let rates = [rates.s1, rates.s2, rates.s3, rates.s4, rates.s5, rates.s6];
        for leg in 0..6 {
            close(found[leg], sled(pose, leg), 1e-14);
            for (input, rate) in rates[leg].into_iter().enumerate() {
                let along = |value: f64| {
                    let mut moved = pose;
                    moved[input] = value;
                    sled(moved, leg)
                };
                let step = if input < 3 { 1e-3 } else { 1e-5 };
                let [known, _] = differences(along, pose[input], step);
                close(rate, known, 1e-8);
            }
        }
    }
}

interpreted! {
    /// Six motors on the base, each with an arm and a rod, whose shafts lie along the sides of a hexagon.
    pub struct Rotary {
        unit mm;
        param arm = 40mm;
        param rod = 180mm;
        input x = 0mm in -20mm..20mm;
        input y = 0mm in -20mm..20mm;
        input z = 175mm in 165mm..185mm;
        input roll  = 0deg in -8deg..8deg;
        input pitch = 0deg in -8deg..8deg;
        input yaw   = 0deg in -8deg..8deg;
        unknown m1 = 0deg;
        unknown m2 = 0deg;
        unknown m3 = 0deg;
        unknown m4 = 0deg;
        unknown m5 = 0deg;
        unknown m6 = 0deg;
        const up = (0, 0, 1);
        let ex = turn(turn(turn((1, 0, 0), (0, 0, 1), yaw), (0, 1, 0), pitch), (1, 0, 0), roll);
        let ez = turn(turn(turn((0, 0, 1), (0, 0, 1), yaw), (0, 1, 0), pitch), (1, 0, 0), roll);
        let body = frame((x, y, z), ex, ez);
        // The arms of each pair point away from each other.
        let left = (100mm, 20mm, 0mm);
        let right = (100mm, -20mm, 0mm);
        loop distance(left + turn((0mm, arm, 0mm), (1, 0, 0), m1), point_in(body, (80mm, 40mm, 0mm))) = rod;
        loop distance(right + turn((0mm, -arm, 0mm), (-1, 0, 0), m2), point_in(body, (80mm, -40mm, 0mm))) = rod;
        loop distance(turn(left + turn((0mm, arm, 0mm), (1, 0, 0), m3), up, 120deg), point_in(body, (-75mm, 49mm, 0mm))) = rod;
        loop distance(turn(right + turn((0mm, -arm, 0mm), (-1, 0, 0), m4), up, 120deg), point_in(body, (-5mm, 89mm, 0mm))) = rod;
        loop distance(turn(left + turn((0mm, arm, 0mm), (1, 0, 0), m5), up, 240deg), point_in(body, (-5mm, -89mm, 0mm))) = rod;
        loop distance(turn(right + turn((0mm, -arm, 0mm), (-1, 0, 0), m6), up, 240deg), point_in(body, (-75mm, -49mm, 0mm))) = rod;
    }
    impl Rotary {
        pub fn motors(x, y, z, roll, pitch, yaw) -> Motors { m1, m2, m3, m4, m5, m6 }
    }
}

const ROTARY: [[f64; 3]; 6] = [
    [80.0, 40.0, 0.0],
    [80.0, -40.0, 0.0],
    [-75.0, 49.0, 0.0],
    [-5.0, 89.0, 0.0],
    [-5.0, -89.0, 0.0],
    [-75.0, -49.0, 0.0],
];

/// The end of an arm, built without what the compiler knows.
fn horn(motor: usize, angle: f64) -> Vector3<f64> {
    let side = if motor.is_multiple_of(2) { 1.0 } else { -1.0 };
    let (sin, cos) = angle.sin_cos();
    let third = std::f64::consts::TAU / 3.0 * (motor / 2) as f64;
    let shaft = Vector3::new(100.0, side * 20.0, 0.0);
    let arm = Vector3::new(0.0, side * 40.0 * cos, 40.0 * sin);
    Rotation3::from_axis_angle(&Vector3::z_axis(), third) * (shaft + arm)
}

/// The angle by Newton's method from where the arm lies flat.
fn motor(pose: [f64; 6], motor: usize) -> f64 {
    let joint = joint(pose, ROTARY[motor]);
    let miss = |[angle]: [f64; 1]| [(horn(motor, angle) - joint).norm() - 180.0];
    let [angle] = super::solve(miss, [0.0]).expect("the arm reaches");
    angle
}

#[test]
fn arms_stand_where_their_rods_reach_the_platform() {
    let platform = Rotary::default().assemble().expect("it assembles");
    assert!(
        Rotary::structure()
            .groups
            .iter()
            .all(|own| own.kind == "SSR")
    );
    for pose in poses() {
        let [x, y, z, roll, pitch, yaw] = pose;
        let pose = [
            x / 8.0,
            y / 4.0,
            175.0 + (z - 380.0) / 5.0,
            roll / 2.0,
            pitch / 2.0,
            yaw / 2.0,
        ];
        let [x, y, z, roll, pitch, yaw] = pose;
        let found = platform.motors(x, y, z, roll, pitch, yaw);
        let found = [found.m1, found.m2, found.m3, found.m4, found.m5, found.m6];
        for (k, found) in found.into_iter().enumerate() {
            close(found, motor(pose, k), 1e-12);
        }
    }
}

//! A platform on three legs that swing about axes in the base: three ball joints at given distances, a coupled group.

use linkage::Vector3;
use linkage_interpreted::interpreted;
use std::f64::consts::{PI, TAU};

use super::{all_solutions, close, differences, turned};

interpreted! {
    pub struct Platform {
        unit mm;
        param base = 100mm;
        param side = 120mm;
        param leg = 150mm;
        input stroke = 100mm in 97mm..105mm;
        unknown x1 = 80deg;
        unknown x2 = 80deg;
        unknown x3 = 80deg;
        let up = (0, 0, 1);
        let p1 = (base, 0, 0) - turn((stroke, 0, 0), (0, 1, 0), x1);
        let p2 = turn((base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), x2), up, 120deg);
        let p3 = turn((base, 0, 0) - turn((leg, 0, 0), (0, 1, 0), x3), up, 240deg);
        loop distance(p1, p2) = side;
        loop distance(p2, p3) = side;
        loop distance(p3, p1) = side;
    }

    impl Platform {
        pub fn pose(stroke) -> Pose { p1, p2, p3, m: margin() }
        pub fn motion(stroke) -> Motion { v: velocity(p1), a: acceleration(p2), x1, w: velocity(x1) }
        pub fn accuracy(stroke) -> Accuracy { s: sensitivity(p3) }
    }
}

fn points(stroke: f64, x: [f64; 3]) -> [Vector3<f64>; 3] {
    let lengths = [stroke, 150.0, 150.0];
    std::array::from_fn(|k| {
        let (sin, cos) = x[k].sin_cos();
        let point = Vector3::new(100.0 - lengths[k] * cos, 0.0, lengths[k] * sin);
        turned(point, Vector3::z(), TAU * k as f64 / 3.0)
    })
}

fn misses(stroke: f64, x: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = points(stroke, x);
    [(a - b), (b - c), (c - a)].map(|v| v.norm() - 120.0)
}

#[test]
fn all_assemblies_are_found() {
    let assemblies = Platform::default().assemblies().expect("they are listed");
    let apart = |a: f64, b: f64| (a - b + PI).rem_euclid(TAU) - PI;
    let independent = all_solutions(
        |x| misses(100.0, x),
        [[-PI; 3], [PI; 3]],
        |x, y| (0..3).all(|k| apart(x[k], y[k]).abs() < 1e-5),
        3000,
    );
    assert_eq!(assemblies.len(), independent.len());
    assert!(independent.len() >= 4);
    for assembly in assemblies {
        let pose = assembly.pose(100.0);
        let [a, b, c] = [pose.p1, pose.p2, pose.p3];
        for side in [a - b, b - c, c - a] {
            close(side.norm(), 120.0, 1e-13);
        }
        let known = |x: &[f64; 3]| (points(100.0, *x)[0] - a).norm() < 1e-6;
        assert!(independent.iter().any(known));
    }
}

#[test]
fn it_moves_as_the_loops_say() {
    let platform = Platform::default().assemble().expect("it assembles");
    for k in 0..=16 {
        let stroke = 97.1 + 0.48 * f64::from(k);
        let pose = platform.pose(stroke);
        let sides = [pose.p1 - pose.p2, pose.p2 - pose.p3, pose.p3 - pose.p1];
        for side in sides {
            close(side.norm(), 120.0, 1e-13);
        }
        assert!(pose.m > 0.0 && pose.m < 1.0);
        let motion = platform.motion(stroke);
        for axis in 0..3 {
            let [v, _] = differences(|x| platform.pose(x).p1[axis], stroke, 1e-4);
            let [_, a] = differences(|x| platform.pose(x).p2[axis], stroke, 1e-3);
            close(motion.v[axis], v, 1e-6);
            close(motion.a[axis], a, 1e-5);
        }
    }
}

#[test]
fn sensitivities_are_differences() {
    let accuracy = Platform::default()
        .assemble()
        .expect("it assembles")
        .accuracy(101.0);
    let at = |change: [f64; 3]| {
        let [base, side, leg] = change;
        let platform = Platform {
            base: 100.0 + base,
            side: 120.0 + side,
            leg: 150.0 + leg,
        };
        platform.assemble().expect("it assembles").pose(101.0).p3
    };
    for k in 0..3 {
        let step = |size: f64| std::array::from_fn(|i| if i == k { size } else { 0.0 });
        let slope = (at(step(1e-4)) - at(step(-1e-4))) / 2e-4;
        (0..3).for_each(|axis| close(accuracy.s[k][axis], slope[axis], 1e-7));
    }
}

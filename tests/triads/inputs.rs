//! A platform on three legs with three inputs: lengths of the legs (3-RPR), or cranks (3-RRR).

use crate::legs::{Leg, Pose, distance, poses, turned};
use crate::newton::follow_pose;
use linkage::{Scalar, Vector2};
use linkage_random::Random;

linkage_interpreted::interpreted! {
    /// Three cylinders hold a plate.
    struct Cylinders {
        unit mm;
        param base_2 = (200mm, 0mm);
        param base_3 = (90mm, 180mm);
        param side = 60mm;
        param other = 70mm;
        param angle = 50deg;
        input l1 = 110mm in 90mm..130mm;
        input l2 = 120mm in 100mm..140mm;
        input l3 = 100mm in 85mm..120mm;
        unknown x1 = 15deg;
        unknown x2 = 133deg;
        unknown x3 = -106deg;
        unknown theta = 78deg;
        let e1 = polar(l1, x1);
        let e3 = e1 + polar(other, theta + angle);
        loop e1 + polar(side, theta) = base_2 + polar(l2, x2);
        loop e3 = base_3 + polar(l3, x3);
    }

    impl Cylinders {
        fn plate(l1, l2, l3) -> Plate {
            e1, direction: dir(theta), margin: margin(),
            miss_2: e1 + polar(side, theta) - base_2 - polar(l2, x2), miss_3: e3 - base_3 - polar(l3, x3),
        }
        fn motion(l1, l2, l3) -> PlateMotion { e3, v: velocity(e3), a: acceleration(e3) }
        fn accuracy(l1, l2, l3) -> PlateAccuracy { by: sensitivity(e3, [side, base_3]) }
    }
}

fn cylinders(l: [f64; 3]) -> [Leg; 3] {
    let pivots = [[0.0, 0.0], [200.0, 0.0], [90.0, 180.0]];
    let ends = [
        [0.0, 0.0],
        [60.0, 0.0],
        turned([70.0, 0.0], 50f64.to_radians()),
    ];
    std::array::from_fn(|i| Leg::Rr {
        pivot: pivots[i],
        length: l[i],
        at: ends[i],
    })
}

linkage_interpreted::interpreted! {
    /// Three cranks hold a plate through rods.
    struct Cranks {
        unit mm;
        param base_2 = (200mm, 0mm);
        param base_3 = (90mm, 180mm);
        param crank = 50mm;
        param rod = 75mm;
        param side = 60mm;
        param other = 70mm;
        param angle = 50deg;
        input f1 = 70deg in 50deg..90deg;
        input f2 = 150deg in 135deg..170deg;
        input f3 = -70deg in -90deg..-50deg;
        unknown x1 = -18deg;
        unknown x2 = 132deg;
        unknown x3 = -138deg;
        unknown theta = 72deg;
        let e1 = polar(crank, f1) + polar(rod, x1);
        let e3 = e1 + polar(other, theta + angle);
        loop e1 + polar(side, theta) = base_2 + polar(crank, f2) + polar(rod, x2);
        loop e3 = base_3 + polar(crank, f3) + polar(rod, x3);
    }

    impl Cranks {
        fn plate(f1, f2, f3) -> CranksPlate {
            e1, direction: dir(theta), margin: margin(),
            miss_2: e1 + polar(side, theta) - base_2 - polar(crank, f2) - polar(rod, x2),
            miss_3: e3 - base_3 - polar(crank, f3) - polar(rod, x3),
        }
        fn motion(f1, f2, f3) -> CranksMotion { e3, v: velocity(e3), a: acceleration(e3) }
    }
}

fn cranks(f: [f64; 3]) -> [Leg; 3] {
    let pivots = [[0.0, 0.0], [200.0, 0.0], [90.0, 180.0]];
    let ends = [
        [0.0, 0.0],
        [60.0, 0.0],
        turned([70.0, 0.0], 50f64.to_radians()),
    ];
    std::array::from_fn(|i| {
        let [x, y] = turned([50.0, 0.0], f[i]);
        Leg::Rr {
            pivot: [pivots[i][0] + x, pivots[i][1] + y],
            length: 75.0,
            at: ends[i],
        }
    })
}

fn pose(e1: Vector2<f64>, direction: Vector2<f64>) -> Pose {
    Pose {
        x: e1.x,
        y: e1.y,
        theta: direction.y.atan2(direction.x),
    }
}

/// A point with its first and second derivatives by three inputs.
type Motion = ([f64; 2], [[f64; 2]; 3], [[[f64; 2]; 3]; 3]);

/// Compares positions at random inputs in the given ranges, and derivatives at a few of them.
fn compare(
    legs: fn([f64; 3]) -> [Leg; 3],
    reference: [f64; 3],
    ranges: [(f64, f64); 3],
    found: &dyn Fn([f64; 3]) -> (Pose, f64),
    motion: &dyn Fn([f64; 3]) -> Motion,
) {
    let start = found(reference).0;
    let listed = poses(&legs(reference)).expect("no two coincide");
    assert!(
        listed
            .iter()
            .any(|pose| distance(pose, &start, 100.0) < 1e-12),
        "{start:?}: {listed:?}"
    );
    let mut random = Random::new(31);
    let (mut compared, mut ended) = (0, 0);
    for _ in 0..200 {
        let x = ranges.map(|(low, high)| random.between(low, high));
        let way = |t: f64| {
            legs(std::array::from_fn(|i| {
                reference[i] + t * (x[i] - reference[i])
            }))
        };
        let (here, miss) = found(x);
        match follow_pose(way, start, (0.0, 1.0)) {
            Ok(expected) => {
                assert!(
                    distance(&here, &expected, 100.0) < 1e-11,
                    "{x:?}: {here:?}, not {expected:?}"
                );
                assert!(miss < 4e-13, "{x:?}: missed by {miss:e}");
                compared += 1;
            }
            Err(_) => ended += 1,
        }
    }
    println!("{compared} positions, {ended} behind a turning point");
    assert!(compared > 150);

    let x = ranges.map(|(low, high)| 0.4 * low + 0.6 * high);
    let (_, first, second) = motion(x);
    for i in 0..3 {
        let size = ranges[i].1 - ranges[i].0;
        let step = 1e-4 * size;
        let moved = |h: f64| {
            let mut x = x;
            x[i] += h;
            motion(x)
        };
        let [b, f, bb, ff] = [-step, step, -2.0 * step, 2.0 * step].map(moved);
        for k in 0..2 {
            let slope = |of: &dyn Fn(&Motion) -> f64| {
                (8.0 * (of(&f) - of(&b)) - (of(&ff) - of(&bb))) / (12.0 * step)
            };
            let miss = slope(&|m| m.0[k]) - first[i][k];
            assert!(
                miss.abs() * size < 1e-7,
                "first derivative by {i}: {miss:e}"
            );
            for j in 0..3 {
                let miss = slope(&|m| m.1[j][k]) - second[i][j][k];
                assert!(
                    miss.abs() * size < 1e-6 * (1.0 + second[i][j][k].abs()),
                    "by {i}, {j}: {miss:e}"
                );
                assert!(
                    (second[i][j][k] - second[j][i][k]).abs() < 1e-9,
                    "{second:?}"
                );
            }
        }
    }
}

#[test]
fn lengths_of_three_legs() {
    let linkage = Cylinders::default().assemble().expect("it closes");
    let ranges = [(90.0, 130.0), (100.0, 140.0), (85.0, 120.0)];
    compare(
        cylinders,
        [110.0, 120.0, 100.0],
        ranges,
        &|[l1, l2, l3]| {
            let p = linkage.plate(l1, l2, l3);
            (
                pose(p.e1, p.direction),
                crate::largest([p.miss_2.norm(), p.miss_3.norm()]),
            )
        },
        &|[l1, l2, l3]| {
            let m = linkage.motion(l1, l2, l3);
            (
                m.e3.into(),
                m.v.map(Into::into),
                m.a.map(|row| row.map(Into::into)),
            )
        },
    );
    // Six legs' lengths at once, and their derivatives by dimensions.
    let columns = linkage.plate_sweep(
        &[100.0, 105.0, 125.0],
        &[110.0, 130.0, 135.0],
        &[90.0, 115.0, 100.0],
    );
    for (i, row) in columns.iter().enumerate() {
        let [l1, l2, l3] = [
            [100.0, 110.0, 90.0],
            [105.0, 130.0, 115.0],
            [125.0, 135.0, 100.0],
        ][i];
        let single = linkage.plate(l1, l2, l3);
        assert!((row.e1 - single.e1).norm() < 1e-12 && row.margin.lane(0) > 0.0);
    }
    let by = linkage.accuracy(105.0, 125.0, 95.0).by;
    let at = |side: f64| {
        let other = Cylinders {
            side,
            ..Cylinders::default()
        }
        .assemble()
        .expect("it closes");
        other.motion(105.0, 125.0, 95.0).e3
    };
    let slope = (at(60.001) - at(59.999)) / 0.002;
    assert!((slope - by[0]).norm() < 1e-6, "{slope:?} {by:?}");
}

#[test]
fn three_cranks() {
    let linkage = Cranks::default().assemble().expect("it closes");
    let ranges = [(50.0, 90.0), (135.0, 170.0), (-90.0, -50.0)]
        .map(|(a, b): (f64, f64)| (a.to_radians(), b.to_radians()));
    compare(
        cranks,
        [70.0, 150.0, -70.0].map(f64::to_radians),
        ranges,
        &|[f1, f2, f3]| {
            let p = linkage.plate(f1, f2, f3);
            (
                pose(p.e1, p.direction),
                crate::largest([p.miss_2.norm(), p.miss_3.norm()]),
            )
        },
        &|[f1, f2, f3]| {
            let m = linkage.motion(f1, f2, f3);
            (
                m.e3.into(),
                m.v.map(Into::into),
                m.a.map(|row| row.map(Into::into)),
            )
        },
    );
}

//! Five poses against 32 digits by another way, planted four-bars, the curve of four poses, special
//! poses.
//!
//! `burmester.txt` has 15 sets of poses and all real dyads: from `|p + R m - a|^2` equal in all
//! poses, two determinants of the equations of `m` (cubics in `a`) with 90 digits, their resultant
//! interpolated, its nine roots, of which those count that are zeros of the other two determinants.

use super::super::*;
use super::{point, spread};
use core::f64::consts::PI;
use linkage_random::Random;
use std::string::ToString;
use std::vec::Vec;

struct Known {
    poses: [Pose; 5],
    /// Fixed, then moving.
    dyads: Vec<[f64; 4]>,
}

fn known() -> Vec<Known> {
    let mut sets: Vec<Known> = Vec::new();
    for line in include_str!("burmester.txt").lines() {
        let mut words = line.split(' ');
        let kind = words.next();
        let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
        match (kind, sets.last_mut()) {
            (Some("poses"), _) => sets.push(Known {
                poses: core::array::from_fn(|j| {
                    Pose::new([numbers[3 * j], numbers[3 * j + 1]], numbers[3 * j + 2])
                }),
                dyads: Vec::new(),
            }),
            (_, Some(set)) => set.dyads.push(core::array::from_fn(|i| numbers[i])),
            _ => unreachable!("a dyad belongs to poses"),
        }
    }
    sets
}

#[test]
fn all_dyads_as_by_resultants_with_90_digits() {
    let sets = known();
    assert_eq!(sets.len(), 15);
    for Known { poses, dyads } in &sets {
        let found = Dyads::of_poses(poses).unwrap();
        assert!(found.certified && found.undecided == 0, "{found:?}");
        assert_eq!(
            [found.real.len(), found.complex],
            [dyads.len(), 4 - dyads.len()]
        );
        for (pivots, known) in found.links().zip(dyads) {
            let joints = [pivots.fixed, pivots.moving].concat();
            for (joint, known) in joints.iter().zip(known) {
                // The data have cosines of 16 digits, and some of the dyads depend on them a
                // thousand times over.
                assert!(
                    (joint - known).abs() <= 2e-13 * known.abs().max(1.0),
                    "{joint} {known}"
                );
                assert!(
                    (joint - known).abs() <= found.error,
                    "{joint} {known} {}",
                    found.error
                );
            }
        }
    }
}

#[test]
fn lengths_are_constant_and_every_count_is_shown() {
    let mut random = Random::new(1);
    let mut counts = [0; 5];
    for _ in 0..200 {
        let poses: [Pose; 5] =
            core::array::from_fn(|_| Pose::new(point(&mut random), random.between(-PI, PI)));
        let found = Dyads::of_poses(&poses).unwrap();
        assert!(found.certified, "{poses:?}");
        counts[found.real.len()] += 1;
        assert_eq!(found.four_bars().len(), [0, 0, 1, 0, 6][found.real.len()]);
        for pivots in found.links() {
            assert!(spread(poses.iter().map(|pose| pivots.length(pose))) < 1e-13);
        }
    }
    // Complex dyads are pairs.
    assert!(counts[1] + counts[3] == 0 && counts[0] > 0 && counts[2] > 0 && counts[4] > 0);
}

#[test]
fn a_slider_is_a_dyad_at_infinity() {
    // A point of the body on a line, or a line of the body through a point: both are planted.
    let angles = [0.1, 0.5, 0.8, -0.4, 1.3];
    let ways = [0.0, 0.7, 1.1, -0.4, 0.3];
    let joint = [0.3, -0.2];
    let on_line = core::array::from_fn(|j| {
        let turned = Pose::new([0.0, 0.0], angles[j]).place(joint);
        let position = [0.5 + 0.8 * ways[j], 0.1 + 0.6 * ways[j]];
        Pose::new(
            [position[0] - turned[0], position[1] - turned[1]],
            angles[j],
        )
    });
    let found = Dyads::of_poses(&on_line).unwrap();
    let slider = found.real.iter().find_map(|dyad| match *dyad {
        Dyad::PointOnLine { moving, angle } => Some((moving, angle)),
        _ => None,
    });
    let (moving, angle) = slider.unwrap();
    assert!(!found.certified);
    assert!(
        (moving[0] - joint[0]).abs() + (moving[1] - joint[1]).abs() < 1e-12,
        "{moving:?}"
    );
    assert!((angle.tan() - 0.75).abs() < 1e-12, "{angle}");

    // The same motion seen from the body.
    let through_point = on_line.map(|pose| Pose::new(pose.point_at([0.0, 0.0]), -pose.angle));
    let found = Dyads::of_poses(&through_point).unwrap();
    let slider = found.real.iter().find_map(|dyad| match *dyad {
        Dyad::LineThroughPoint { fixed, angle } => Some((fixed, angle)),
        _ => None,
    });
    let (fixed, angle) = slider.unwrap();
    assert!(
        (fixed[0] - joint[0]).abs() + (fixed[1] - joint[1]).abs() < 1e-12,
        "{fixed:?}"
    );
    assert!((angle.tan() - 0.75).abs() < 1e-12, "{angle}");
}

#[test]
fn the_curve_of_four_poses_has_the_dyads_of_five() {
    for Known { poses, dyads } in &known() {
        let [four @ .., _] = *poses;
        let curve = CentreCurve::of_poses(&four).unwrap();
        let points = curve.points(90);
        assert!(points.len() > 60, "{}", points.len());
        for point in &points {
            // Next to poles lengths are nothing.
            let lengths = four.map(|pose| point.pivots.length(&pose));
            let size = lengths[0].max(1.0);
            assert!(
                lengths
                    .iter()
                    .all(|length| (length - lengths[0]).abs() < 1e-12 * size * size)
            );
        }
        let pole = curve.pole();
        for &[x, y, u, v] in dyads {
            let is_dyad = |point: &CentrePoint| {
                let joints = [point.pivots.fixed, point.pivots.moving].concat();
                let pairs = joints.iter().zip([x, y, u, v]);
                pairs
                    .into_iter()
                    .all(|(joint, known)| (joint - known).abs() < 1e-9 * known.abs().max(1.0))
            };
            assert!(
                curve
                    .points_at((y - pole[1]).atan2(x - pole[0]))
                    .iter()
                    .any(is_dyad)
            );
            let on_line = curve.on_line([x, y], 0.3);
            assert!(on_line.len() % 2 == 1 && on_line.iter().any(is_dyad));
        }
    }
}

#[test]
fn three_poses_leave_one_joint_free() {
    let mut random = Random::new(2);
    for _ in 0..50 {
        let poses: [Pose; 3] =
            core::array::from_fn(|_| Pose::new(point(&mut random), random.between(-2.0, 2.0)));
        let fixed = point(&mut random);
        let link = Pivots::with_fixed(&poses, fixed).unwrap();
        let size = link.length(&poses[0]).max(1.0);
        assert!(spread(poses.iter().map(|pose| link.length(pose))) < 1e-12 * size);
        let back = Pivots::with_moving(&poses, link.moving).unwrap();
        let way = (back.fixed[0] - fixed[0]).hypot(back.fixed[1] - fixed[1]);
        assert!(way < 1e-10 * size * size, "{way} {size}");
    }
}

#[test]
fn what_leaves_infinitely_many_is_refused() {
    let poses: [Pose; 5] = core::array::from_fn(|j| Pose::new([0.5, 0.25], j as f64 * 0.3));
    let message = Dyads::of_poses(&poses).unwrap_err().to_string();
    assert!(
        message.starts_with("the conditions depend on each other"),
        "{message}"
    );

    let mut poses = known()[0].poses;
    poses[3] = poses[1];
    let refused = Dyads::of_poses(&poses).unwrap_err();
    assert_eq!(refused, Unsolved::Equal { indices: [1, 3] });
    poses[2].angle = f64::NAN;
    assert_eq!(
        Dyads::of_poses(&poses).unwrap_err(),
        Unsolved::NotFinite { index: 2 }
    );

    let parallel: [Pose; 4] = core::array::from_fn(|j| Pose::new([j as f64, (j * j) as f64], 0.5));
    assert_eq!(
        CentreCurve::of_poses(&parallel).err(),
        Some(Unsolved::AtInfinity)
    );
    let line = [0.0, 1.0, 2.0].map(|x| Pose::new([x, 0.0], 0.0));
    assert_eq!(
        Pivots::with_fixed(&line, [0.0, 1.0]).unwrap_err(),
        Unsolved::AtInfinity
    );
    assert_eq!(
        Pivots::with_moving(&line, [0.0, 1.0]).unwrap_err(),
        Unsolved::AtInfinity
    );
}

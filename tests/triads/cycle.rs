//! An assembly stays itself over the whole cycle: a position is the one that fine steps lead to from the
//! reference, or NaN.

use crate::effort;
use crate::kinds::{Answer, Dimensions, KINDS, Kind};
use crate::legs::{Pose, distance, poses};
use crate::newton::{follow_and_measure, follow_pose};
use linkage_random::Random;
use std::f64::consts::TAU;

const REFERENCE: f64 = 30.0 / 180.0 * std::f64::consts::PI;
/// Positions in a turn.
const STEPS: i32 = 90;
/// Sets of dimensions for each kind.
const SETS: usize = 4;
/// Nearer than this to a turning point, in radians, a position may be NaN.
const END: f64 = 0.02;

/// A slider farther out than this, in mm, is on its way to infinity: its mechanism is not looked at there.
const FAR: f64 = 600.0;
/// Where the determinant is smaller, two turning points have all but met: a table may end before it.
const NARROW: f64 = 2e-3;

/// The poses that lead from the reference to one end of a range, and where they end.
struct Way {
    poses: Vec<(f64, Pose)>,
    end: f64,
    /// Whether there is nothing to say about what comes behind: it is far out, or the passage is narrow.
    open: bool,
}

fn way(kind: &Kind, dimensions: &Dimensions, pose: Pose, to: f64) -> Way {
    let legs = |phi| kind.legs(dimensions, phi);
    let (mut at, mut here) = (REFERENCE, pose);
    let mut poses = vec![(at, here)];
    for step in 1..=STEPS {
        let next = REFERENCE + (to - REFERENCE) * f64::from(step) / f64::from(STEPS);
        match follow_and_measure(legs, here, (at, next)) {
            Ok((there, least)) if is_far(&there) || least < NARROW => {
                return Way {
                    poses,
                    end: at,
                    open: true,
                };
            }
            Ok((there, _)) => (at, here) = (next, there),
            Err(end) => {
                return Way {
                    poses,
                    end,
                    open: false,
                };
            }
        }
        poses.push((at, here));
    }
    Way {
        poses,
        end: to,
        open: false,
    }
}

fn is_far(pose: &Pose) -> bool {
    pose.x.hypot(pose.y) > FAR
}

fn pose(answer: &Answer) -> Pose {
    let [x, y] = answer.point;
    Pose {
        x,
        y,
        theta: answer.direction[1].atan2(answer.direction[0]),
    }
}

/// Compares one assembly with both ways through the declared range; gives how many positions were
/// compared.
fn compare(
    kind: &Kind,
    dimensions: &Dimensions,
    evaluate: &dyn Fn(f64) -> Answer,
    start: Pose,
) -> usize {
    let mut compared = 0;
    let ways = [TAU, 0.0].map(|to| way(kind, dimensions, start, to));
    // The same assembly, when the input has gone around the other way.
    let around = [REFERENCE - TAU, REFERENCE + TAU].map(|to| way(kind, dimensions, start, to));
    for (way, around) in ways.iter().zip(&around) {
        for (phi, expected) in &way.poses {
            let found = evaluate(*phi);
            let context = || {
                format!(
                    "{} at {phi}: {dimensions:?}\nfrom {start:?}, expected {expected:?}, found {found:?}",
                    kind.name
                )
            };
            if found.point[0].is_nan() {
                assert!((phi - way.end).abs() < END, "NaN: {}", context());
            } else {
                assert!(
                    distance(&pose(&found), expected, 100.0) < 1e-9,
                    "{}",
                    context()
                );
                compared += 1;
            }
        }
        if !way.open && !around.open {
            beyond(kind, dimensions, evaluate, way, around);
        }
    }
    compared
}

/// Behind the end of a way there is nothing, or the same assembly coming from the other side.
fn beyond(
    kind: &Kind,
    dimensions: &Dimensions,
    evaluate: &dyn Fn(f64) -> Answer,
    way: &Way,
    around: &Way,
) {
    let limit = if way.end > REFERENCE { TAU } else { 0.0 };
    for step in 1..20 {
        let phi = way.end + (limit - way.end) * f64::from(step) / 20.0;
        if (phi - way.end).abs() < 1e-3 {
            continue;
        }
        let found = evaluate(phi);
        if found.point[0].is_nan() {
            continue;
        }
        let turned = if way.end > REFERENCE {
            phi - TAU
        } else {
            phi + TAU
        };
        let reached = (turned - REFERENCE).abs() < (around.end - REFERENCE).abs();
        let expected = reached.then(|| {
            follow_pose(
                |x| kind.legs(dimensions, x),
                around.poses[0].1,
                (REFERENCE, turned),
            )
        });
        let good = matches!(expected, Some(Ok(expected)) if distance(&pose(&found), &expected, 100.0) < 1e-9);
        let start = way.poses[0].1;
        assert!(
            good,
            "{} at {phi}, behind the end at {}: {found:?}, from {start:?}: {dimensions:?}",
            kind.name, way.end
        );
    }
}

#[test]
fn assemblies_keep_to_themselves() {
    let mut random = Random::new(14);
    for kind in &KINDS {
        let (mut compared, mut followed) = (0, 0);
        for set in 0..SETS * effort() {
            let dimensions = random.near(kind.dimensions(), [0.0, 0.03, 0.1, 0.3][set % 4]);
            let Some(starts) = poses(&kind.legs(&dimensions, REFERENCE)) else {
                continue;
            };
            let found = kind.assemblies(&dimensions, REFERENCE).expect(kind.name);
            for evaluate in &found {
                let here = pose(&evaluate(REFERENCE));
                let start = starts
                    .iter()
                    .find(|start| distance(start, &here, 100.0) < 1e-8);
                let start = start.unwrap_or_else(|| panic!("{}: no pose {here:?}", kind.name));
                if is_far(start) {
                    continue;
                }
                compared += compare(kind, &dimensions, evaluate, *start);
                followed += 1;
            }
        }
        println!(
            "{:<10} {followed} assemblies followed, {compared} positions",
            kind.name
        );
        assert!(compared > 100, "{}", kind.name);
    }
}

#[test]
fn derivatives_are_those_of_the_followed_pose() {
    let mut random = Random::new(15);
    for kind in &KINDS {
        let dimensions = kind.dimensions();
        let evaluate = kind.assemble(&dimensions).expect(kind.name);
        let point = |pose: &Pose| {
            let [_, _, _, _, _, _, c, kappa, ..] = dimensions;
            let (s, cos) = (pose.theta + kappa).sin_cos();
            [pose.x + c * cos, pose.y + c * s]
        };
        for _ in 0..20 {
            let phi = random.between(0.0, TAU);
            let here = pose(&evaluate(phi));
            let at = |h: f64| {
                let there = follow_pose(|x| kind.legs(&dimensions, x), here, (phi, phi + h));
                point(&there.expect("near by"))
            };
            let h = 1e-3;
            let [back, front, far_back, far_front] = [-h, h, -2.0 * h, 2.0 * h].map(at);
            let found = evaluate(phi);
            for k in 0..2 {
                let first =
                    (8.0 * (front[k] - back[k]) - (far_front[k] - far_back[k])) / (12.0 * h);
                let sum = 16.0 * (front[k] + back[k]) - (far_front[k] + far_back[k]);
                let second = (sum - 30.0 * point(&here)[k]) / (12.0 * h * h);
                let miss = [
                    (found.velocity[k] - first) / 1e-8,
                    (found.acceleration[k] - second) / 1e-5,
                ];
                let size = 100.0;
                assert!(
                    crate::largest(miss) < size,
                    "{} at {phi}: {found:?}, {first} {second}",
                    kind.name
                );
            }
        }
    }
}

//! All assemblies are listed, no other ones, and the chosen one is the one that the estimates mean.

use crate::effort;
use crate::kinds::{self, Answer, Joints};
use crate::legs::{Point, Pose, characteristic, poses};
use crate::two_slides;
use linkage_random::Random;
use std::f64::consts::TAU;

/// Loops are missed by less than this many times the size of the mechanism: some roundings.
const ROUNDING: f64 = 2e-15;
/// Sets of dimensions for each kind.
const SETS: usize = 25;

/// Whether a list of answers is a list of poses, in any order.
fn same(poses: &[Pose], points: &[(Point, Option<Point>)]) -> bool {
    let at = |pose: &Pose, (point, direction): &(Point, Option<Point>)| {
        let (s, c) = pose.theta.sin_cos();
        let turned = direction.map_or(0.0, |[x, y]| (x - c).hypot(y - s));
        (point[0] - pose.x).hypot(point[1] - pose.y) + 100.0 * turned < 1e-6
    };
    let all = poses
        .iter()
        .all(|pose| points.iter().filter(|found| at(pose, found)).count() == 1);
    all && poses.len() == points.len()
}

/// A slider farther out than this, in mm, is not looked at: guides are almost parallel.
const FAR: f64 = 2000.0;

/// How large a mechanism is: 200 mm, or as far as a slider has gone.
fn size([x, y]: Point) -> f64 {
    x.hypot(y).max(200.0)
}

#[test]
fn characteristic_polynomials_have_the_degrees_of_the_table() {
    let mut random = Random::new(11);
    for kind in &kinds::KINDS {
        for _ in 0..20 {
            let dimensions = random.near(kind.dimensions(), 0.2);
            let legs = kind.legs(&dimensions, random.between(0.0, TAU));
            assert_eq!(characteristic(&legs).degree(), kind.degree, "{}", kind.name);
        }
    }
}

#[test]
fn groups_are_named_after_their_legs() {
    let named = kinds::KINDS
        .iter()
        .map(|kind| (kind.name.to_owned(), kind.mechanism.structure()));
    for (name, structure) in named {
        let legs = |name: &str| {
            let mut legs: Vec<String> = name.split('-').map(String::from).collect();
            legs.sort();
            legs
        };
        let [group] = structure.groups else {
            panic!("{name}: {structure}")
        };
        assert_eq!(
            (group.class, group.order, legs(group.kind)),
            (3, 3, legs(&name))
        );
    }
}

/// Where the ternary link does not turn, the other two legs are a dyad. The leg of two slides follows.
#[test]
fn a_leg_of_two_slides_leaves_a_dyad() {
    for kind in &two_slides::KINDS {
        let structure = kind.mechanism.structure();
        let kinds: Vec<&str> = structure.groups.iter().map(|group| group.kind).collect();
        let rods = kind.joints.iter().filter(|joints| **joints == Joints::Rr);
        let dyad = ["RPP", "RRP", "RRR"][rods.count()];
        assert_eq!(kinds, [dyad, "RPP"], "{}", kind.name);
    }
}

#[test]
fn estimates_choose_the_assembly_that_they_mean() {
    for kind in &kinds::KINDS {
        let dimensions = kind.dimensions();
        let phi = 30f64.to_radians();
        let found = kind.assemble(&dimensions).expect(kind.name)(phi);
        let listed = kind.assemblies(&dimensions, phi).expect(kind.name);
        let first = listed.first().expect("at least the one written")(phi);
        let apart = [0, 1].map(|k| {
            [
                found.point[k] - first.point[k],
                found.direction[k] - first.direction[k],
            ]
        });
        assert!(
            crate::largest(apart.into_iter().flatten()) < 1e-12,
            "{}: {found:?} {first:?}",
            kind.name
        );
    }
}

#[test]
fn all_assemblies_are_listed() {
    let mut random = Random::new(12);
    for kind in &kinds::KINDS {
        let mut counts = [0; 8];
        for set in 0..SETS * effort() {
            let part = [0.0, 0.05, 0.2, 0.5][set.min(set % 4)];
            let dimensions = random.near(kind.dimensions(), part);
            let phi = if set == 0 {
                30f64.to_radians()
            } else {
                random.between(0.0, TAU)
            };
            let Some(poses) = poses(&kind.legs(&dimensions, phi)) else {
                continue;
            };
            if poses.iter().any(|pose| pose.x.hypot(pose.y) > FAR) {
                continue;
            }
            let context = || format!("{} at {phi}: {dimensions:?}", kind.name);
            let found = kind
                .assemblies(&dimensions, phi)
                .unwrap_or_else(|why| panic!("{why}: {}", context()));
            let found: Vec<Answer> = found.iter().map(|evaluate| evaluate(phi)).collect();
            let places: Vec<_> = found.iter().map(|a| (a.point, Some(a.direction))).collect();
            assert!(
                same(&poses, &places),
                "{}\nexpected {poses:?}\nfound {found:?}",
                context()
            );
            for answer in &found {
                assert!(
                    answer.miss < ROUNDING * size(answer.point),
                    "{answer:?}: {}",
                    context()
                );
                assert!(
                    answer.margin > 0.0 && answer.margin <= 1.0,
                    "{answer:?}: {}",
                    context()
                );
            }
            counts[found.len()] += 1;
        }
        println!(
            "{:<10} mechanisms with 0, 1, .. assemblies: {:?}",
            kind.name,
            &counts[..=kind.degree]
        );
        assert!(
            counts[kind.degree..].iter().sum::<usize>() > 0,
            "{}: never all of them",
            kind.name
        );
    }
}

#[test]
fn all_assemblies_with_two_slides_are_listed() {
    let mut random = Random::new(13);
    for kind in &two_slides::KINDS {
        let mut counts = [0; 8];
        for set in 0..SETS * effort() {
            let part = [0.0, 0.05, 0.2, 0.5][set.min(set % 4)];
            let dimensions = random.near(kind.dimensions(), part);
            let [tau, p1, q1] = [dimensions[8], dimensions[9], dimensions[10]];
            let phi = if set == 0 {
                30f64.to_radians()
            } else {
                random.between(0.0, TAU)
            };
            let Some(poses) = poses(&kind.legs(&dimensions, phi)) else {
                continue;
            };
            if (q1 - p1 - tau).sin().abs() < 0.2 {
                continue;
            }
            let context = || format!("{} at {phi}: {dimensions:?}", kind.name);
            let found = kind
                .assemblies(&dimensions, phi)
                .unwrap_or_else(|why| panic!("{why}: {}", context()));
            let found: Vec<_> = found.iter().map(|evaluate| evaluate(phi)).collect();
            let places: Vec<_> = found.iter().map(|a| (a.point, None)).collect();
            assert!(
                same(&poses, &places),
                "{}\nexpected {poses:?}\nfound {found:?}",
                context()
            );
            for answer in &found {
                assert!(
                    answer.miss < 10.0 * ROUNDING * size(answer.point),
                    "{answer:?}: {}",
                    context()
                );
            }
            counts[found.len()] += 1;
        }
        println!(
            "{:<10} mechanisms with 0, 1, .. assemblies: {:?}",
            kind.name,
            &counts[..=kind.degree]
        );
        assert!(counts[kind.degree] > 0, "{}: never all of them", kind.name);
    }
}

//! What is said where estimates lead to no assembly: whether the loops close all the same, and by how much they miss where they come nearest to
//! it.

use linkage::{AssemblyError, ClosestApproach, CoupledCause, Missed};
use linkage_interpreted::interpreted;
use nalgebra::{UnitQuaternion, Vector3};

use super::body::Axle;
use super::independent::{Pose, Rods};

interpreted! {
    /// On legs of one length, from pairs of feet below the gaps between pairs of joints.
    pub struct Platform {
        unit mm;
        param leg = 450mm;
        /// How far the ground is turned.
        param base = 0deg;
        input pull = 0mm in -5mm..5mm;            // of the first leg
        let up = (0, 0, 1);
        let foot = (300mm, 0mm, 0mm);
        let joint = (150mm, 0mm, 0mm);
        unknown body = frame((5mm, -8mm, 380mm), (1, 0.05, 0.02), (0, 0, 1));
        loop distance(point_in(body, turn(joint, up, 50deg)), turn(foot, up, base + 10deg)) = leg - pull;
        loop distance(point_in(body, turn(joint, up, 70deg)), turn(foot, up, base + 110deg)) = leg;
        loop distance(point_in(body, turn(joint, up, 170deg)), turn(foot, up, base + 130deg)) = leg;
        loop distance(point_in(body, turn(joint, up, 190deg)), turn(foot, up, base + 230deg)) = leg;
        loop distance(point_in(body, turn(joint, up, 290deg)), turn(foot, up, base + 250deg)) = leg;
        loop distance(point_in(body, turn(joint, up, 310deg)), turn(foot, up, base + 350deg)) = leg;
    }

    impl Platform {
        pub fn pose(pull) -> PlatformPose { body }
    }
}

/// Of an assembly that its estimates do not lead to.
#[track_caller]
fn closest_approach<A>(assembly: Result<A, AssemblyError>) -> ClosestApproach {
    match assembly.err() {
        Some(AssemblyError::Coupled(error)) => match error.cause {
            CoupledCause::NotReached {
                closest_approach, ..
            } => closest_approach,
            _ => panic!("{error}"),
        },
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn missed<A>(assembly: Result<A, AssemblyError>) -> Vec<Missed> {
    match closest_approach(assembly) {
        ClosestApproach::Misses(missed) => missed,
        other => panic!("{other}"),
    }
}

#[test]
fn legs_that_are_too_short_miss_alike_where_the_body_lies_in_the_ground() {
    let short = Platform {
        leg: 100.0,
        ..Platform::default()
    };
    let missed = missed(short.assemble());
    // Turned so that feet and joints are 40 degrees apart: then the sum of the legs' squares is least, and all of them are equal.
    let square = 300.0 * 300.0 + 150.0 * 150.0 - 2.0 * 300.0 * 150.0 * 40_f64.to_radians().cos();
    let mut numbers: Vec<usize> = missed.iter().map(|own| own.number).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [1, 2, 3, 4, 5, 6]);
    for own in &missed {
        assert!((own.by - (square.sqrt() - 100.0)).abs() < 1e-6, "{own}");
        assert_eq!(own.unit, "mm");
    }
}

#[test]
fn a_rod_that_is_too_short_and_its_neighbours_miss_by_what_steepest_descent_finds() {
    let short = Axle {
        l1: 87.0,
        ..Axle::default()
    };
    let missed = missed(short.assemble());
    let rods = Rods {
        on_body: vec![
            Vector3::new(15.0, -70.0, 135.0),
            Vector3::new(-30.0, -75.0, 140.0),
            Vector3::new(40.0, -60.0, -105.0),
            Vector3::new(-25.0, -55.0, -120.0),
            Vector3::new(-150.0, -70.0, -58.0),
        ],
        on_ground: vec![
            short.inner1,
            Vector3::new(-85.0, 435.0, 440.0),
            Vector3::new(265.0, 480.0, 265.0),
            Vector3::new(-60.0, 255.0, 215.0),
            Vector3::new(-190.0, 316.0, 258.0),
        ],
    };
    let upright = Pose {
        p: Vector3::new(0.0, 760.0, 320.0),
        turn: UnitQuaternion::identity(),
    };
    let lengths = [short.l1, short.l2, short.l3, short.l4, short.l5, 320.0];
    let nearest = rods.nearest(&upright, &lengths);
    assert_eq!(missed.len(), 5);
    for own in &missed {
        let by = nearest[own.number - 1];
        assert!((own.by - by).abs() < 1e-5, "{own}, not by {by}");
    }
    let farthest_first = missed.windows(2).all(|k| k[0].by.abs() >= k[1].by.abs());
    assert!(farthest_first, "{missed:?}");
}

#[test]
fn links_that_reach_each_other_elsewhere_are_told_from_those_that_do_not() {
    // Where ground and body are turned together nothing changes, but the estimates stay behind.
    let [here, turned] = [0.0, 255_f64].map(|base| Platform {
        leg: 300.0,
        base: base.to_radians(),
    });
    here.assemble().expect("it assembles");
    assert_eq!(closest_approach(turned.assemble()), ClosestApproach::Closes);
}

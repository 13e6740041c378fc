//! Circuits, branches and order of four-bars that are moved.

use super::super::*;
use super::coupler_at;
use std::vec::Vec;

/// Poses of the coupler for angles of link 0, on one side of the line from its pin to the other
/// joint of the frame.
fn poses(lengths: [f64; 4], angles: &[f64], side: f64) -> Vec<Pose> {
    let [frame, lengths @ ..] = lengths;
    let fixed = [[0.0, 0.0], [frame, 0.0]];
    let places = angles
        .iter()
        .map(|&angle| coupler_at(fixed, lengths, angle, side));
    places.collect()
}

fn four_bar([frame, _, coupler, _]: [f64; 4]) -> FourBar {
    FourBar {
        fixed: [[0.0, 0.0], [frame, 0.0]],
        moving: [[0.0, 0.0], [coupler, 0.0]],
    }
}

const CRANK_ROCKER: [f64; 4] = [3.0, 1.0, 2.5, 2.0];
const DOUBLE_CRANK: [f64; 4] = [1.0, 2.0, 2.5, 3.0];
const DOUBLE_ROCKER: [f64; 4] = [3.0, 2.0, 1.0, 2.5];
const TRIPLE_ROCKER: [f64; 4] = [3.0, 2.5, 1.5, 1.7];

#[test]
fn links_that_turn_fully() {
    let turning = |lengths: [f64; 4], angle: f64| {
        let four_bar = four_bar(lengths);
        let pose = poses(lengths, &[angle], 1.0)[0];
        let found = four_bar.lengths(&pose);
        assert!(
            found
                .iter()
                .zip(lengths)
                .all(|(found, length)| (found - length).abs() < 1e-15 * 8.0)
        );
        four_bar.turning(&pose)
    };
    assert_eq!(turning(CRANK_ROCKER, 1.0), GrashofType::Crank(0));
    let [frame, crank, coupler, rocker] = CRANK_ROCKER;
    assert_eq!(
        turning([frame, rocker, coupler, crank], 1.0),
        GrashofType::Crank(1)
    );
    assert_eq!(turning(DOUBLE_CRANK, 1.0), GrashofType::DoubleCrank);
    assert_eq!(turning(DOUBLE_ROCKER, 0.9), GrashofType::DoubleRocker);
    assert_eq!(turning(TRIPLE_ROCKER, 0.5), GrashofType::TripleRocker);
}

#[test]
fn order_and_circuits_of_a_crank_rocker() {
    let angles = [0.2, 1.1, 2.5, 3.9, 5.5];
    let four_bar = four_bar(CRANK_ROCKER);
    for side in [1.0, -1.0] {
        let mut passed = poses(CRANK_ROCKER, &angles, side);
        let passage = four_bar.passage(&passed);
        assert!(passage.one_circuit() && passage.one_branch(0) && passage.in_order);
        // The rocker turns back twice.
        assert!(!passage.one_branch(1));
        passed.reverse();
        passed.rotate_left(2);
        assert!(four_bar.passage(&passed).in_order);
        passed.swap(0, 1);
        assert!(!four_bar.passage(&passed).in_order);
    }
    let mut both = poses(CRANK_ROCKER, &angles, 1.0);
    both[2] = poses(CRANK_ROCKER, &angles[2..3], -1.0)[0];
    let passage = four_bar.passage(&both);
    assert!(!passage.one_circuit() && !passage.in_order && !passage.one_branch(0));
    let circuits: Vec<usize> = passage.visits.iter().map(|visit| visit.circuit).collect();
    assert!(circuits[2] != circuits[0] && circuits[1] == circuits[0]);
}

#[test]
fn order_of_chains_whose_links_rock() {
    // Out on one branch and back on the other one is one turn of the circuit.
    for (lengths, out) in [
        (TRIPLE_ROCKER, [-0.9, -0.2, 0.6]),
        (DOUBLE_ROCKER, [0.7, 0.9, 1.1]),
    ] {
        let back = [out[2] - 0.1, out[1] + 0.05, out[0] + 0.03];
        let mut all = poses(lengths, &out, 1.0);
        all.extend(poses(lengths, &back, -1.0));
        let four_bar = four_bar(lengths);
        let passage = four_bar.passage(&all);
        assert!(passage.one_circuit() && passage.in_order, "{passage:?}");
        assert!(!passage.one_branch(0) && four_bar.passage(&all[..3]).one_branch(0));
        all.swap(1, 4);
        assert!(!four_bar.passage(&all).in_order);
    }
    // The other side of the frame is another circuit of a double rocker, and the same one of a
    // triple rocker.
    let both = |lengths: [f64; 4], angle: f64| {
        let mut all = poses(lengths, &[angle], 1.0);
        all.extend(poses(lengths, &[-angle], 1.0));
        four_bar(lengths).passage(&all).one_circuit()
    };
    assert!(!both(DOUBLE_ROCKER, 0.9) && both(TRIPLE_ROCKER, 0.5));
}

//! Five points: 36 solutions, as Morgan and Wampler found; a planted four-bar among them.

use super::super::*;
use super::{coupler_at, spread};

#[test]
fn thirty_six_four_bars_a_planted_one_among_them() {
    // Joints of a crank-rocker and a point of its coupler, at five angles of the crank.
    let (fixed, tracer) = ([[0.25, -0.125], [3.0, 0.5]], [1.25, 0.875]);
    let lengths = [1.0, 2.75, 2.0];
    let poses = [0.2, 0.9, 1.7, 2.3, 3.4].map(|angle| coupler_at(fixed, lengths, angle, 1.0));
    let points = poses.map(|pose| pose.place(tracer));
    let found = five_points(&points, fixed).unwrap();
    assert_eq!(found.four_bars.len() + found.complex + found.undecided, 36);
    assert_eq!((found.undecided, found.paths), (0, 384));
    let planted = found.four_bars.iter().any(|(four_bar, _)| {
        let [_, found_lengths @ ..] = four_bar.lengths(&Pose::new(points[0], 0.0));
        let mut pairs = found_lengths.into_iter().zip(lengths);
        pairs.all(|(found, length)| (found - length).abs() < 1e-9)
    });
    assert!(planted, "{found:?}");
    for (four_bar, found_poses) in &found.four_bars {
        assert_eq!(
            found_poses.map(|pose| pose.point.map(|x| (x * 1e9).round())),
            points.map(|point| point.map(|x| (x * 1e9).round()))
        );
        for link in 0..4 {
            assert!(spread(found_poses.iter().map(|pose| four_bar.lengths(pose)[link])) < 1e-12);
        }
    }
    assert!(found.error < 1e-12, "{}", found.error);
}

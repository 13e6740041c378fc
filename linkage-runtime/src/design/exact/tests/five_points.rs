//! Five points: 36 solutions, as Morgan and Wampler found; a planted four-bar among them.

use super::super::*;
use super::spread;

#[test]
fn thirty_six_four_bars_a_planted_one_among_them() {
    // Joints of a crank-rocker and a point of its coupler, at five angles of the crank.
    let (fixed, tracer) = ([[0.25, -0.125], [3.0, 0.5]], [1.25, 0.875]);
    let [crank, coupler, rocker] = [1.0, 2.75, 2.0];
    let poses = [0.2, 0.9, 1.7, 2.3, 3.4].map(|angle: f64| {
        let pin = [
            fixed[0][0] + crank * angle.cos(),
            fixed[0][1] + crank * angle.sin(),
        ];
        let (x, y) = (fixed[1][0] - pin[0], fixed[1][1] - pin[1]);
        let distance = x.hypot(y);
        let cosine = (distance * distance + coupler * coupler - rocker * rocker)
            / (2.0 * distance * coupler);
        Pose::new(pin, y.atan2(x) + cosine.acos())
    });
    let points = poses.map(|pose| pose.place(tracer));
    let found = five_points(&points, fixed).unwrap();
    assert_eq!(found.four_bars.len() + found.complex + found.undecided, 36);
    assert_eq!((found.undecided, found.paths), (0, 384));
    let planted = found.four_bars.iter().any(|(four_bar, _)| {
        let [_, own_crank, own_coupler, own_rocker] = four_bar.lengths(&Pose::new(points[0], 0.0));
        let differences = [
            own_crank - crank,
            own_coupler - coupler,
            own_rocker - rocker,
        ];
        differences.iter().all(|difference| difference.abs() < 1e-9)
    });
    assert!(planted, "{found:?}");
    for (four_bar, own) in &found.four_bars {
        assert_eq!(
            own.map(|pose| pose.point.map(|x| (x * 1e9).round())),
            points.map(|point| point.map(|x| (x * 1e9).round()))
        );
        for link in 0..4 {
            assert!(spread(own.iter().map(|pose| four_bar.lengths(pose)[link])) < 1e-12);
        }
    }
    assert!(found.error < 1e-12, "{}", found.error);
}

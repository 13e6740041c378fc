mod burmester;
mod five_points;
mod four_bar;
mod function;
mod numbers;
mod verified;

use super::Pose;
use linkage_random::Random;

/// The coupler of a four-bar at an angle of its crank: the pin, and its direction on one side of
/// the line from the pin to the other joint of the frame.
pub(super) fn coupler_at(
    fixed: [[f64; 2]; 2],
    [crank, coupler, rocker]: [f64; 3],
    angle: f64,
    side: f64,
) -> Pose {
    let [from, to] = fixed;
    let pin = [from[0] + crank * angle.cos(), from[1] + crank * angle.sin()];
    let (x, y) = (to[0] - pin[0], to[1] - pin[1]);
    let distance = x.hypot(y);
    let cosine =
        (distance * distance + coupler * coupler - rocker * rocker) / (2.0 * distance * coupler);
    assert!(cosine.abs() < 1.0, "angle {angle} is out of reach");
    Pose::new(pin, y.atan2(x) + side * cosine.acos())
}

/// A point within 1 of the origin in either direction.
fn point(random: &mut Random) -> [f64; 2] {
    [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]
}

/// The largest less the smallest, as a part of the largest.
fn spread(values: impl IntoIterator<Item = f64>) -> f64 {
    let [low, high] = values
        .into_iter()
        .fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], value| {
            [low.min(value), high.max(value)]
        });
    (high - low) / high
}

mod burmester;
mod five_points;
mod four_bar;
mod function;
mod numbers;

use linkage_random::Random;

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

//! Triads of every kind, and larger coupled groups, against positions found in another way: how many
//! assemblies there are, where they are, and that each stays itself over the whole cycle.

mod assemblies;
mod beside;
mod bulges;
mod chains;
mod circuits;
mod contours;
mod cycle;
mod four_bars;
mod inputs;
mod kinds;
mod legs;
mod machines;
mod many_inputs;
mod newton;
mod pinned;
mod platforms;
mod polynomial;
mod scissors;
mod served;
mod sets;
mod sweeps;
mod two_slides;

use linkage_engine::Mechanism;

/// The mechanism of a text.
fn compile(text: &str) -> Mechanism {
    Mechanism::compile(text).unwrap_or_else(|error| panic!("{error}"))
}

/// The largest magnitude; NaN if there is one.
fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let more = |most: f64, x: f64| {
        if most.is_nan() || x.abs() <= most {
            most
        } else {
            x.abs()
        }
    };
    numbers.into_iter().fold(0.0, more)
}

/// How many times the usual number of cases: 10 for `LINKAGE_LONG=1`, 20 for `LINKAGE_LONG=2`.
fn effort() -> usize {
    let long = std::env::var("LINKAGE_LONG").ok();
    let times = long.and_then(|value| value.parse::<usize>().ok());
    times.map_or(1, |times| 10 * times.max(1))
}

/// Whether two lists of directions, or of numbers of size 1, are the same.
fn alike(one: &[f64], two: &[f64], tolerance: f64) -> bool {
    one.iter()
        .zip(two)
        .all(|(a, b)| ((a - b) / 2.0).sin().abs() < tolerance)
}

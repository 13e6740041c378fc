//! Triads of every kind, and larger coupled groups, against positions found in another way: how many
//! assemblies there are, where they are, and that each stays itself over the whole cycle.

mod assemblies;
mod chains;
mod contour;
mod contours;
mod cycle;
mod follow;
mod inputs;
mod kinds;
mod legs;
mod machines;
mod newton;
mod pinned;
mod platforms;
mod polynomial;
mod random;
mod sweeps;
mod two_slides;

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

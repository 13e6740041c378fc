//! Searches of dimensions: wishes with their derivatives, what must hold, messages.

mod derivatives;
mod interruptions;
mod judge;
mod known;
mod messages;
mod parts;
mod reach;
mod reproducible;
mod space;
mod verified;
mod whole;

use linkage::design::{Design, Relation};

include!("../../mechanisms/four_bar_paths.rs");

/// The lengths.
const LENGTHS: [&str; 4] = ["frame", "crank", "coupler", "rocker"];

type FourBarDesign<'a> = Design<'a, FourBar, FourBarAssembly, 9>;

/// A problem of the four-bar in which nothing varies.
fn problem_of_nothing<'a>() -> FourBarDesign<'a> {
    let design = Design::new(
        FourBar::default(),
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    design.expect("it assembles")
}

/// A problem of the four-bar, without a wish.
fn problem<'a>() -> FourBarDesign<'a> {
    let design = problem_of_nothing().hold(Relation::crank_turns(LENGTHS, 0.0));
    LENGTHS
        .iter()
        .fold(design, |design, name| design.vary(name, 5.0, 60.0))
}

/// The coupler point of the declared mechanism at some inputs.
fn points(inputs: &[f64]) -> Vec<[f64; 2]> {
    let linkage = FourBar::default().assemble().expect("it assembles");
    inputs
        .iter()
        .map(|&phi| linkage.path(phi).tracer.into())
        .collect()
}

/// Inputs that are evenly spaced from a first one.
fn evenly(first: f64, step: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| first + step * i as f64).collect()
}

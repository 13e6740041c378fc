//! Motion under forces: `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench dynamics`, and without the flags.
//!
//! Andrews' squeezing mechanism to 0.03 s and a slider-crank to 1 s against their references: our methods, those of
//! `ivp` on the equations with multipliers, and the stored runs of `benches/dynamics_rivals`. Further: 20 digits of
//! Andrews' mechanism, drift of the energy, steps of chains of four-bars, the mass matrix of an ankle. It writes
//! `docs/dynamics.svg`.

mod andrews;
mod ankle;
mod chain;
mod comparison;
mod digits;
#[allow(
    dead_code,
    reason = "an example's module, of which only a part is used here"
)]
#[path = "../../tests/programs/double_double/number.rs"]
mod double_double;
mod links;
mod measured;
mod plot;
mod slider_crank;
mod solvers;
mod task;
mod timing;

use comparison::{Method, Panel};
use linkage_peers::environment;
use linkage_peers::timing::only_tested;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let with_measured = |mut methods: Vec<Method>, problem: &str| {
        methods.extend(measured::methods(problem));
        methods
    };
    let panels = [
        Panel {
            title: "Andrews' squeezing mechanism, 0.03 s",
            methods: with_measured(andrews::methods()?, "andrews"),
        },
        Panel {
            title: "Slider-crank under its weight, 1 s",
            methods: with_measured(slider_crank::methods()?, "slider-crank"),
        },
    ];
    panels.iter().for_each(Panel::print);
    measured::about()
        .iter()
        .for_each(|line| println!("  {line}"));
    if !only_tested() {
        let about = environment::describe("cargo bench -p linkage-benches --bench dynamics");
        let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/dynamics.svg");
        std::fs::write(docs, plot::svg(&panels, &about))?;
    }
    digits::print()?;
    slider_crank::drift()?;
    chain::print()?;
    ankle::print()
}

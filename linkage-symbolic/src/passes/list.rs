//! The list of passes.

use super::{contract, double_angles, reciprocals, sine_pairs, singular};
use crate::program::Program;

/// A step from program to program.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// For dumps.
    pub name: &'static str,
    /// The program that computes the same.
    pub run: fn(Program) -> Program,
}

/// All passes, in order: each program is polished by them before it is printed.
pub const PASSES: &[Pass] = &[
    Pass {
        name: "reciprocals",
        run: reciprocals::share,
    },
    Pass {
        name: "sine pairs",
        run: sine_pairs::pair,
    },
    Pass {
        name: "double angles",
        run: double_angles::share,
    },
    // The others look at products, sums and quotients.
    Pass {
        name: "contract",
        run: contract::contract,
    },
    Pass {
        name: "singular",
        run: singular::mark,
    },
];

/// A program after all passes.
pub fn polished(program: Program) -> Program {
    PASSES
        .iter()
        .fold(program, |program, pass| (pass.run)(program))
}

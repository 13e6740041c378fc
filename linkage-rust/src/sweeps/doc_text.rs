//! The description of sweeps, as text for the docs.

use super::super::outline::{Outline, plain};
use super::argument;
use linkage_language::model::Sweep;
use linkage_language::syntax::Word;

/// The part of the assembly's docs that all its sweeps lead to; nothing if there are none.
pub(in super::super) fn about(outline: &Outline) -> String {
    let mut functions = outline.functions.iter();
    let Some(example) = functions.find(|function| !function.arguments.is_empty()) else {
        return String::new();
    };
    let name = plain(example.name);
    let arguments: Vec<String> = example
        .arguments
        .iter()
        .map(|argument| plain(argument))
        .collect();
    let arguments = arguments.join(", ");
    let [sets, columns, slices] = ["sets", "columns", "slices"].map(|name| argument(example, name));
    let row = |sweep: Sweep, given: &str, does: &str| {
        format!("| `{name}{}({given})` | {does} |\n", sweep.word())
    };
    let mut text = String::from(
        "\n\n# Sweeps\n\nEach function of inputs has methods that compute it many times, side by side, with feature \
         `alloc`, which is part of `std`; those of the first one are:\n\n| method | does |\n|---|---|\n",
    );
    text += &row(
        Sweep::Owned,
        &arguments,
        "many positions, one for each element of the slices",
    );
    text += &row(
        Sweep::Into,
        &format!("{arguments}, {columns}"),
        "the same into columns that are there: allocates only if they are too small",
    );
    text += &row(
        Sweep::Slices,
        &format!("{arguments}, {slices}"),
        "the same into slices: one for each number of the result, in the order of its fields; allocates nothing",
    );
    text += &row(
        Sweep::ParallelInto,
        &format!("{arguments}, {columns}"),
        "the same on all threads of rayon's current pool; with feature `rayon`",
    );
    let mut panics = "Sweeps panic if slices differ in length, those with a single element aside: they have that value everywhere.".to_owned();
    if !outline.parameters.is_empty() {
        text += &row(
            Sweep::Sets,
            &format!("{sets}, {arguments}"),
            "many mechanisms, each at inputs of its own",
        );
        text += &row(
            Sweep::SetsInto,
            &format!("{sets}, {arguments}, {columns}"),
            "the same into columns that are there",
        );
        text += &row(
            Sweep::SetsParallelInto,
            &format!("{sets}, {arguments}, {columns}"),
            "the same on all threads of rayon's current pool; with feature `rayon`",
        );
        text += "\nMany mechanisms are assembled in the modes of this one, and their angles count turns from those of this one. \
                 Where one cannot be assembled at its position, the results are NaN.";
        if outline
            .functions
            .iter()
            .any(|function| !function.states.is_empty())
        {
            text += " Coupled groups are followed straight from the dimensions of this one, at the position.";
        }
        text += "\n";
        panics += " Of many mechanisms, each such slice has one element or as many as there are mechanisms.";
    }
    format!("{text}\n{panics}")
}

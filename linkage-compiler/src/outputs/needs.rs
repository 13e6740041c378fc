//! Do the arguments of a function fit its quantities?

use crate::algebra::Algebra;
use crate::algebra::derivatives::dependence;
use crate::diagnostic::Reporter;
use crate::model::EvaluatorDef;

use super::quantity::Requested;

/// Reports inputs that are listed but not needed, and needed but not listed.
pub(super) fn check_inputs<'m>(
    algebra: &mut Algebra<'m>,
    definition: &EvaluatorDef,
    requested: &Requested<'m>,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    let name = |input: usize| mechanism.input_name(input);
    let word = |input: usize| match input < mechanism.inputs.len() {
        true => "input",
        false => "argument",
    };
    let mut needed = dependence::inputs_below(
        algebra.graph,
        &mut algebra.derivatives.dependence,
        &requested.underlying,
    );
    let computed = dependence::inputs_below(
        algebra.graph,
        &mut algebra.derivatives.dependence,
        &requested.scalars,
    );
    needed.extend(&requested.variables);
    for (&input, &origin) in definition.inputs.iter().zip(&definition.input_origins) {
        if !needed.contains(&input) {
            reporter.error(
                origin,
                format!(
                    "`{}` does not need the {} `{}`: none of its quantities depends on it\n\
                     help: remove the argument",
                    definition.name,
                    word(input),
                    name(input)
                ),
            );
        }
    }
    let missing: Vec<usize> = computed
        .into_iter()
        .filter(|input| !definition.inputs.contains(input))
        .collect();
    if !missing.is_empty() {
        let names: Vec<&str> = missing.iter().map(|&input| name(input)).collect();
        let listed = definition.inputs.iter().map(|&input| name(input));
        let complete: Vec<&str> = listed.chain(names.iter().copied()).collect();
        reporter.error(
            definition.origin,
            format!(
                "`{}` needs the {}{} `{}`, on which its quantities depend\n\
                 help: write `fn {}({})`",
                definition.name,
                words(missing.iter().map(|&input| word(input))),
                if names.len() == 1 { "" } else { "s" },
                names.join("`, `"),
                definition.name,
                complete.join(", ")
            ),
        );
    }
}

/// One word for all: an input is an argument, too.
fn words(mut words: impl Iterator<Item = &'static str>) -> &'static str {
    let first = words.next().unwrap_or_default();
    match words.all(|word| word == first) {
        true => first,
        false => "argument",
    }
}

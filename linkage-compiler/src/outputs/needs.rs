//! Do the arguments of a function fit its quantities?

use crate::algebra::Algebra;
use crate::algebra::derivatives::dependence;
use crate::diagnostic::Reporter;
use crate::model::{EvaluatorDef, Expr, ExprKind, Mechanism, Name};

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
        if needed.contains(&input) {
            continue;
        }
        let text = name(input);
        let (fact, help) = match drives_no_link(mechanism, input) {
            true => (
                format!("the input `{text}` drives no link"),
                format!("write `at {text}` after the joints of the link that it turns"),
            ),
            false => (
                format!(
                    "`{}` does not need the {} `{text}`: none of its quantities depends on it",
                    definition.name,
                    word(input),
                ),
                "remove the argument".to_owned(),
            ),
        };
        reporter.error_with_help(origin, fact, help);
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

/// Returns true for an input that neither links nor loops nor derived quantities mention, in a
/// mechanism of joints and links.
fn drives_no_link(mechanism: &Mechanism, input: usize) -> bool {
    let loops = mechanism.loops.iter().chain(&mechanism.redundant);
    let sides = loops.flat_map(|equation| [&equation.left, &equation.right]);
    let lets = mechanism.lets.iter().map(|item| &item.value);
    let mut parts = lets.chain(sides).flat_map(Expr::parts);
    let is_input =
        |part: &Expr| matches!(part.kind, ExprKind::Name(Name::Input(other)) if other == input);
    mechanism.links.is_some() && input < mechanism.inputs.len() && !parts.any(is_input)
}

/// One word for all: an input is an argument, too.
fn words(mut words: impl Iterator<Item = &'static str>) -> &'static str {
    let first = words.next().unwrap_or_default();
    match words.all(|word| word == first) {
        true => first,
        false => "argument",
    }
}

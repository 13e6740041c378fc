//! Parameters that nothing is written with.

use std::collections::BTreeSet;

use crate::algebra::Nominal;
use crate::diagnostic::Reporter;
use crate::model::{Expr, ExprKind, Mechanism, Name, Parameter, Variable};

use crate::message_format::MessageFormat;

/// Warns of parameters that neither loops nor bodies nor functions mention. An unused parameter is
/// intended if its name begins with `_`, or if it has `#[allow(unused)]`.
pub(crate) fn warn_of_unused(mechanism: &Mechanism, nominal: &Nominal, reporter: &mut Reporter) {
    if mechanism.evaluators.is_empty() {
        // It has just been begun.
        return;
    }
    let used = mentioned(mechanism);
    let parameters = mechanism.parameters.iter().enumerate();
    for (_, parameter) in parameters.filter(|(index, parameter)| {
        !used.contains(index) && !parameter.name.starts_with('_') && !parameter.may_be_unused
    }) {
        let Parameter {
            name,
            ty,
            first_scalar,
            tolerances,
            ..
        } = parameter;
        let values = &nominal.parameters[first_scalar.0..][..tolerances.len()];
        let value = MessageFormat::new(mechanism).value(ty, values);
        let links = mechanism.links.as_ref();
        if links.is_some_and(|links| links.pivots.contains(name)) {
            continue;
        }
        let (fact, help) = match links.and_then(|links| links.moved.get(name)) {
            Some(joint) => (
                format!(
                    "the {joint} at {value} has no effect: no other joint and no function needs it"
                ),
                "name it in another link, or leave it out",
            ),
            None => (
                format!(
                    "the parameter `{name} = {value}` is used by no loop, no body and no function"
                ),
                "remove it, or write `#[allow(unused)]` above it if it is to be a field only",
            ),
        };
        reporter.warning_with_help(parameter.origin, fact, help);
    }
}

/// The parameters that something is written with or differentiated by.
fn mentioned(mechanism: &Mechanism) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    for part in expressions(mechanism).into_iter().flat_map(Expr::parts) {
        match &part.kind {
            ExprKind::Name(Name::Parameter(index)) => {
                found.insert(*index);
            }
            ExprKind::Derivative(_, variables) => {
                found.extend(variables.iter().filter_map(|variable| match variable {
                    Variable::Parameter(scalar) => {
                        Some(mechanism.scalar_parameters[scalar.0].parameter)
                    }
                    Variable::Input(_) => None,
                }));
            }
            // Only names mention parameters, and a sensitivity may be by all of them.
            _ => {}
        }
    }
    found
}

/// All that a mechanism is written with, beside the numbers of its declarations.
fn expressions(mechanism: &Mechanism) -> Vec<&Expr> {
    let mut all = mechanism.expressions_of_mechanics();
    all.extend(
        mechanism
            .unknowns
            .iter()
            .filter_map(|unknown| unknown.estimate.as_ref()),
    );
    all.extend(mechanism.lets.iter().map(|item| &item.value));
    let loops = mechanism.loops.iter().chain(&mechanism.redundant);
    all.extend(loops.flat_map(|equation| [&equation.left, &equation.right]));
    // Pictures draw wheels about their pivots.
    let wheels = mechanism.link_elements.pairs.iter();
    let wheels = wheels.flat_map(|pair| &pair.wheels);
    all.extend(wheels.map(|wheel| &wheel.centre));
    let quantities = mechanism
        .evaluators
        .iter()
        .flat_map(|function| &function.quantities);
    all.extend(quantities.map(|quantity| &quantity.value));
    all
}

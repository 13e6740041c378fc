//! Descriptions of quantities, as text for the docs of results.

use crate::model::{Derived, EvaluatorDef, Expr, ExprKind, Mechanism, Quantity, Variable};

/// More names of variables than these are not listed.
const FEW: usize = 4;

/// Returns `` derivative of `p` by `phi` ``; nothing if the name gives the description.
pub(super) fn about(
    mechanism: &Mechanism,
    definition: &EvaluatorDef,
    quantity: &Quantity,
) -> String {
    let words = Words {
        mechanism,
        definition,
        subject: &quantity.subject,
    };
    match &quantity.value.kind {
        ExprKind::Margin => "how far the nearest group is from a dead point, at most 1".to_owned(),
        _ if quantity.value.derived().is_some() => words.described(&quantity.value),
        _ if quantity.written == quantity.field => String::new(),
        _ => format!("`{}`", quantity.written),
    }
}

struct Words<'a> {
    mechanism: &'a Mechanism,
    definition: &'a EvaluatorDef,
    /// The differentiated quantity, as written.
    subject: &'a str,
}

impl Words<'_> {
    fn described(&self, expr: &Expr) -> String {
        let (inner, which, by) = match expr.derived() {
            None => return format!("`{}`", self.subject),
            Some(Derived::ByInputs(inner, order)) => {
                let drives = self.definition.inputs.iter().copied();
                let drives = drives.filter(|&input| input < self.mechanism.inputs.len());
                let names: Vec<&str> = drives
                    .map(|input| self.mechanism.input_name(input))
                    .collect();
                let ordinal = ordinal(usize::from(order));
                match (&names[..], order) {
                    ([name], _) => (inner, format!("{ordinal}derivative"), format!("`{name}`")),
                    (_, 1) => (inner, "derivatives".to_owned(), listed(&names)),
                    _ => {
                        let pairs = format!("each two of {}", listed(&names));
                        (inner, format!("{ordinal}derivatives"), pairs)
                    }
                }
            }
            Some(Derived::ByParameters(inner, parameters)) => {
                let scalars = &self.mechanism.scalar_parameters;
                let names = parameters.iter().map(|id| scalars[id.0].name.as_str());
                let names: Vec<&str> = names.collect();
                let by = match names.len() {
                    all if all == scalars.len() => "each of `PARAMETERS`".to_owned(),
                    many if many > FEW => format!("{many} of `PARAMETERS`"),
                    _ => listed(&names),
                };
                (inner, "derivatives".to_owned(), by)
            }
            Some(Derived::By(inner, variables)) => {
                let names: Vec<&str> = variables
                    .iter()
                    .map(|variable| self.variable(*variable))
                    .collect();
                let ordinal = ordinal(names.len());
                (inner, format!("{ordinal}derivative"), listed(&names))
            }
        };
        // The variable comes first: the text of the inner derivative ends with a variable of its
        // own.
        match inner.derived() {
            Some(_) => format!("{which} by {by} of the {}", self.described(inner)),
            None => format!("{which} of `{}` by {by}", self.subject),
        }
    }

    fn variable(&self, variable: Variable) -> &str {
        match variable {
            Variable::Input(input) => self.mechanism.input_name(input),
            Variable::Parameter(id) => &self.mechanism.scalar_parameters[id.0].name,
        }
    }
}

/// Before the word derivative.
fn ordinal(order: usize) -> &'static str {
    ["", "", "second ", "third "]
        .get(order)
        .unwrap_or(&"higher ")
}

/// `` `a`, `b` and `c` ``
fn listed(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match names.split_last() {
        Some((end, before)) if !before.is_empty() => format!("{} and {end}", before.join(", ")),
        _ => names.join(""),
    }
}

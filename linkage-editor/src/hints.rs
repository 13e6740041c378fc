//! Values next to names: those of derived quantities, and solutions that differ from estimates.

use crate::computed::Age;
use crate::declaration::NameKind;
use crate::document::Document;
use crate::name_values::{Value, Values};
use crate::shown;

/// The share of an estimate, or of a radian, by which a solution may differ without a hint.
const ALIKE: f64 = 1e-3;

/// A text that an editor shows within a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The byte before which it is shown.
    pub offset: usize,
    /// The text.
    pub label: String,
    /// True for a solution that differs from its estimate.
    pub is_solution: bool,
}

/// Returns the values of derived quantities, and the solutions of unknowns that differ from
/// their estimates. There are none while the text has mistakes.
pub(crate) fn hints(document: &Document) -> Vec<Hint> {
    match document.age_of_values() {
        Age::Present | Age::Pending => {}
        Age::BeforeMistakes => return Vec::new(),
    }
    let mut hints = Vec::new();
    for outline in &document.outlines {
        let Some(values) = document.values(&outline.mechanism.name) else {
            continue;
        };
        for name in &outline.names {
            let is_solution = name.kind == NameKind::Unknown;
            let value = match name.kind {
                NameKind::Derived => values.names.get(&name.name),
                NameKind::Unknown => solution(values, &name.name),
                _ => None,
            };
            if let Some(value) = value {
                hints.push(Hint {
                    offset: name.item.end,
                    label: format!(" = {}", shown::short(value)),
                    is_solution,
                });
            }
        }
    }
    hints
}

/// Returns the solution of an unknown if it differs from the estimate that is written.
pub(crate) fn solution<'v>(values: &'v Values, name: &str) -> Option<&'v Value> {
    let (found, estimate) = (values.names.get(name)?, values.estimates.get(name)?);
    let size = estimate
        .reference
        .iter()
        .fold(0.0, |size: f64, x| size.max(x.abs()));
    let size = if found.unit == "rad" {
        size.max(1.0)
    } else {
        size
    };
    let mut pairs = found.reference.iter().zip(&estimate.reference);
    pairs
        .any(|(x, estimate)| (x - estimate).abs() > ALIKE * size)
        .then_some(found)
}

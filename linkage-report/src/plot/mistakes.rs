//! Contradictions within a plot.

use std::vec::Vec;

use super::builder::Plot;
use linkage_formats::Mistake;
use linkage_formats::characters::control;

/// Returns the mistakes that were found when items were added, and those of the whole plot.
pub(super) fn all_mistakes(plot: &Plot) -> Vec<Mistake> {
    let mut mistakes = plot.mistakes.clone();
    if plot.curves.is_empty() {
        mistakes.push(Mistake::NoCurve);
    }
    let abscissa = &plot.abscissa;
    if abscissa.values.is_empty() {
        let name = abscissa.name.clone();
        mistakes.push(Mistake::NoAbscissa { name });
    }
    let mut values = abscissa.values.iter().enumerate();
    if let Some((index, &value)) = values.find(|(_, x)| !x.is_finite()) {
        let what = std::format!("value {index} of the abscissa `{}`", abscissa.name);
        mistakes.push(Mistake::NotFinite { what, value });
    }
    mistakes.extend(control("the title", &plot.title));
    let quantities = plot.curves.iter().map(|curve| &curve.quantity);
    for quantity in [abscissa].into_iter().chain(quantities) {
        mistakes.extend(control("the name of a quantity", &quantity.name));
        mistakes.extend(control("a unit", &quantity.unit));
    }
    mistakes
}

//! What does not fit together in a plot.

use std::vec::Vec;

use super::Plot;
use crate::report::Mistake;
use crate::report::letters::control;

impl Plot {
    /// What was found when something was added, and what shows when all is there.
    pub(super) fn all_mistakes(&self) -> Vec<Mistake> {
        let mut mistakes = self.mistakes.clone();
        if self.curves.is_empty() {
            mistakes.push(Mistake::NoCurve);
        }
        let abscissa = &self.abscissa;
        if abscissa.values.is_empty() {
            let name = abscissa.name.clone();
            mistakes.push(Mistake::NoAbscissa { name });
        }
        let mut values = abscissa.values.iter().enumerate();
        if let Some((index, &value)) = values.find(|(_, x)| !x.is_finite()) {
            let what = std::format!("value {index} of the abscissa `{}`", abscissa.name);
            mistakes.push(Mistake::NotFinite { what, value });
        }
        mistakes.extend(control("the title", &self.title));
        let quantities = self.curves.iter().map(|curve| &curve.quantity);
        for quantity in [abscissa].into_iter().chain(quantities) {
            mistakes.extend(control("the name of a quantity", &quantity.name));
            mistakes.extend(control("a unit", &quantity.unit));
        }
        mistakes
    }
}

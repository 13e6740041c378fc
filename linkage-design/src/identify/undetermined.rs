//! Combinations that readings do not determine, as text, and readings that would.

use core::fmt;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use nalgebra::DVector;

use super::determined::Determined;
use super::directions::candidates;
use super::named::Named;
use super::reading::ReadingRow;
use linkage_core::format::rounded;

/// A combination of parameters that the readings do not determine: it stays as near as can be to
/// where the fit began.
#[derive(Clone, Debug, PartialEq)]
pub struct Undetermined {
    /// The parameters, and by how much they change together.
    pub parts: Vec<(&'static str, f64)>,
    /// True if it changes no reading at all. Otherwise it changes them, over its whole range, by
    /// less than one standard deviation.
    pub exactly: bool,
    /// Its description.
    pub words: String,
    /// Quantities that would determine it, the best first: those that were offered, and all others
    /// of the functions in use, at the inputs at which these were read.
    pub remedies: Vec<Remedy>,
}

/// A quantity that would determine a combination.
#[derive(Clone, Debug, PartialEq)]
pub struct Remedy {
    /// The quantity.
    pub quantity: &'static str,
    /// The name of the input.
    pub input_name: &'static str,
    /// The offered input at which it tells most.
    pub input: f64,
    /// Its change there, in standard deviations, when the combination changes over its range.
    pub change: f64,
}

/// Directions that differ by less than this sine are one.
const APART: f64 = 0.05;

/// Returns all combinations that are not determined, those that change nothing first. Within both
/// kinds the simplest come first: single parameters, a common scale, rotation or shift, pairs, and
/// the rest.
pub(super) fn undetermined(
    named: &Named,
    found: &Determined,
    offers: &[ReadingRow],
) -> Vec<Undetermined> {
    let mut taken: Vec<DVector<f64>> = Vec::new();
    let mut combinations: Vec<Undetermined> = Vec::new();
    for exactly in [true, false] {
        let is_it = |k: &usize| found.is_nothing(found.singular[*k]) == exactly;
        let open: Vec<usize> = (found.rank..found.singular.len()).filter(is_it).collect();
        let all = combinations.len() + open.len();
        for mut candidate in candidates(named, found, &open) {
            if combinations.len() == all {
                break;
            }
            // A parameter that is not determined by itself need not move with others.
            let alone = |name: &str| {
                combinations
                    .iter()
                    .any(|combinations| matches!(combinations.parts[..], [(one, _)] if one == name))
            };
            for (j, parameter) in named.parameters.iter().enumerate() {
                if alone(parameter.name) {
                    candidate.direction[j] = 0.0;
                }
            }
            let length = candidate.direction.norm();
            if length == 0.0 {
                continue;
            }
            let direction = candidate.direction / length;
            let change = (&found.jacobian * &direction).norm();
            let is_open = if exactly {
                found.is_nothing(change)
            } else {
                change < found.needed()
            };
            let rest = taken.iter().fold(direction.clone(), |rest, taken| {
                &rest - taken * taken.dot(&rest)
            });
            if !is_open || rest.norm() < APART {
                continue;
            }
            taken.push(&rest / rest.norm());
            combinations.push(describe(
                named,
                found,
                &direction,
                candidate.pattern,
                offers,
            ));
        }
        // Combinations that are too much alike miss some parameters: combinations of the rest are
        // added.
        while combinations.len() < all {
            let direction = left_over(found, &open, &taken);
            combinations.push(describe(named, found, &direction, None, offers));
            taken.push(direction);
        }
    }
    combinations
}

/// The direction that has most beside those that were taken.
fn left_over(found: &Determined, open: &[usize], taken: &[DVector<f64>]) -> DVector<f64> {
    let rest = |&k: &usize| {
        let row = found.directions.row(k).transpose();
        taken
            .iter()
            .fold(row, |rest, row| &rest - row * row.dot(&rest))
    };
    let rests = open.iter().map(rest);
    let most = rests.max_by(|a, b| a.norm().total_cmp(&b.norm()));
    most.map_or_else(
        || DVector::zeros(found.singular.len()),
        |rest| rest.normalize(),
    )
}

fn describe(
    named: &Named,
    found: &Determined,
    direction: &DVector<f64>,
    pattern: Option<&'static str>,
    offers: &[ReadingRow],
) -> Undetermined {
    let change = (&found.jacobian * direction).norm();
    let exactly = found.is_nothing(change);
    // The part that rounding, or readings with almost no effect, add to a combination.
    let least = if exactly { 1e-6 } else { APART };
    let part = |j: usize| (named.parameters[j].name, direction[j] * named.ranges[j]);
    let order: Vec<usize> = (0..direction.len())
        .filter(|&j| direction[j].abs() > least)
        .collect();
    let parts: Vec<_> = order.iter().map(|&j| part(j)).collect();
    let remedies = remedies(named, found, direction, offers);
    let mut words = said(named, &order, &parts, pattern, exactly);
    if let Some(best) = remedies.first() {
        words += &format!(
            "; `{}` would tell, best at `{}` = {}",
            best.quantity,
            best.input_name,
            rounded(best.input)
        );
    }
    Undetermined {
        parts,
        exactly,
        words,
        remedies,
    }
}

fn said(
    named: &Named,
    order: &[usize],
    parts: &[(&'static str, f64)],
    pattern: Option<&'static str>,
    exactly: bool,
) -> String {
    let names: Vec<String> = parts.iter().map(|(name, _)| format!("`{name}`")).collect();
    let listed = match &names[..] {
        [] => String::new(),
        [one] => one.to_string(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    };
    let hardly = if exactly {
        ""
    } else {
        ", within what the readings are good for"
    };
    let amount = |k: usize| {
        let unit = named.parameters[order[k]].unit;
        let space = if unit.is_empty() { "" } else { " " };
        format!("{}{space}{unit}", rounded(parts[k].1 / parts[0].1))
    };
    let together = || {
        let each = (0..parts.len()).map(|k| format!("{} by {}", names[k], amount(k)));
        each.collect::<Vec<_>>().join(", ")
    };
    match (pattern, parts.len()) {
        (Some(pattern), _) => {
            format!("{pattern} of {listed} changes nothing that was measured{hardly}")
        }
        (None, 1) => format!("{listed} changes nothing that was measured{hardly}"),
        (None, _) => format!(
            "{listed} cannot be told apart{hardly}: what was measured stays when they change together, {}",
            together()
        ),
    }
}

fn remedies(
    named: &Named,
    found: &Determined,
    direction: &DVector<f64>,
    offers: &[ReadingRow],
) -> Vec<Remedy> {
    let mut best: Vec<Remedy> = Vec::new();
    for row in offers {
        let slopes = row.slopes.iter().zip(&named.ranges).zip(direction.iter());
        let moved: f64 = slopes
            .map(|((slope, range), part)| slope * range * part)
            .sum();
        let change = moved.abs() / row.deviation;
        // NaN where the mechanism does not assemble at an offered input.
        if change.is_nan() || change < found.needed() || found.is_nothing(change) {
            continue;
        }
        let remedy = Remedy {
            quantity: row.number,
            input_name: row.input_name,
            input: row.input,
            change,
        };
        match best.iter_mut().find(|best| best.quantity == row.number) {
            Some(known) if known.change < change => *known = remedy,
            Some(_) => {}
            None => best.push(remedy),
        }
    }
    best.sort_by(|a, b| b.change.total_cmp(&a.change));
    best
}

/// The words.
impl fmt::Display for Undetermined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words)
    }
}

//! Loops that are one too many and close all the same: with the dimensions as they are they repeat
//! others, as a third crank on one rod does that stays parallel to the first two. Whether they do
//! is found by numbers: all loops are closed together at several positions.

use linkage_core::numeric::rank::are_independent;

use crate::algebra::names::Names;
use crate::algebra::{ALIKE, ConstantRatio, Nominal, constant_ratio};
use crate::message_format::loop_names;
use crate::model::{COMPONENTS, Mechanism};
use crate::structure::equations;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::link_faults;
use crate::structure::loops_together::{closed_at, positions, simultaneous_loops};
use crate::structure::simultaneous::ACROSS;

/// The text besides the surplus.
pub(crate) struct RedundantLoops {
    pub(crate) fact: String,
    pub(crate) help: String,
}

/// Checks if a loop with more equations than it has unknowns of its own repeats the others, and
/// returns the remedy.
pub(crate) fn redundant_loops<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    surplus: &Equation<'m>,
    too_many: usize,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<RedundantLoops> {
    let places = positions(names, nominal);
    let together = simultaneous_loops(names, nominal, equations, coordinates)?;
    let found = closed_at(nominal, &together, &places)?;
    let even = constant_ratios(names, &places, &found, coordinates);
    let at = Nominal {
        inputs: places[0].clone(),
        ..nominal.clone()
    };
    let slopes = together.slopes(&found[0], &at);
    let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
    let in_all = rows.saturating_sub(coordinates.len());
    // The loop itself first; another one where its equations find something better than those that
    // remain.
    let others = equations.iter().filter(|e| e.loops != surplus.loops);
    let spare = std::iter::once(surplus).chain(others).find_map(|left_out| {
        let determined = coordinates_of_one(names, left_out, equations, coordinates);
        let alone = left_out.rows.len().checked_sub(determined.len());
        let fits = alone.is_some_and(|rows| (too_many..=in_all).contains(&rows));
        let even: Option<Vec<&ConstantRatio>> = determined
            .iter()
            .map(|&k| {
                even.iter()
                    .find(|e| coordinates[k].unknown == Some(e.unknown))
            })
            .collect();
        let even =
            even.filter(|_| fits && remain_regular(&slopes, left_out, equations, &determined))?;
        Some((left_out, even))
    });
    let mut like = "";
    let spare_loops = spare
        .as_ref()
        .map_or(&surplus.loops, |(left_out, _)| &left_out.loops);
    let link_help = help_for_link(names.mechanism, nominal, spare_loops);
    let help = match spare {
        Some((left_out, even)) => {
            let loops = loop_names(names.mechanism, &left_out.loops);
            if !even.is_empty() {
                like = ", as a further crank on one rod does that stays parallel";
            }
            match lets_for(names.mechanism, &even).filter(|_| link_help.is_none()) {
                Some(lets) => format!("write {lets} and leave {loops} out"),
                None => format!("leave {loops} out, or write `redundant` at its end"),
            }
        }
        None => help_for_components(names.mechanism, &slopes, surplus, equations),
    };
    Some(RedundantLoops {
        fact: match link_help {
            Some(_) => format!("; with these dimensions it fits and holds nothing{like}"),
            None => format!(
                "; with these dimensions it closes all the same and repeats the other loops{like}"
            ),
        },
        help: link_help.unwrap_or(help),
    })
}

/// Returns the advice for a link, slider or joint that repeats others; `None` for a loop as it is
/// written.
fn help_for_link(mechanism: &Mechanism, nominal: &Nominal, loops: &[usize]) -> Option<String> {
    let link = link_faults::link_to_leave_out(mechanism, loops)?;
    let distance = link_faults::distance_of_ends(mechanism, loops);
    let length = link_faults::length_of_link(mechanism, nominal, loops);
    Some(match distance.zip(length) {
        Some((distance, length)) => format!(
            "leave {link} out, or write `loop {distance} = {length} redundant;` in its place, to have its fit checked"
        ),
        None => format!("leave {link} out"),
    })
}

/// Returns the advice for a loop of which some components follow from the others: the components to
/// keep, if one alone can be left out.
fn help_for_components(
    mechanism: &Mechanism,
    slopes: &[Vec<f64>],
    surplus: &Equation,
    equations: &[Equation],
) -> String {
    let loops = loop_names(mechanism, &surplus.loops);
    let count = surplus.rows.len();
    let mut components = COMPONENTS.into_iter().enumerate().take(count);
    let spare = components.find(|(component, _)| {
        count > 1 && determine_all_without(slopes, surplus, *component, equations)
    });
    let Some((spare, name)) = spare else {
        return format!(
            "write of {loops} only what the others do not say, such as one component of its vectors"
        );
    };
    let kept = COMPONENTS.into_iter().enumerate().take(count);
    let kept = kept.filter(|(component, _)| *component != spare);
    let kept: Vec<String> = kept
        .map(|(_, name)| format!("`loop (LEFT).{name} = (RIGHT).{name};`"))
        .collect();
    format!(
        "write {} instead of {loops}: its {name} component follows from the others",
        kept.join(" and ")
    )
}

/// Returns true if the unknowns are determined without one component of a loop.
fn determine_all_without(
    slopes: &[Vec<f64>],
    surplus: &Equation,
    component: usize,
    equations: &[Equation],
) -> bool {
    let rows = equations.iter().flat_map(|e| {
        let is_surplus = e.loops == surplus.loops;
        (0..e.rows.len()).map(move |row| !(is_surplus && row == component))
    });
    let stays: Vec<bool> = rows.collect();
    let columns = slopes.iter().map(|column| {
        let rows = column.iter().zip(&stays).filter(|(_, stays)| **stays);
        rows.map(|(x, _)| *x).collect()
    });
    are_independent(&columns.collect::<Vec<Vec<f64>>>(), ACROSS)
}

/// The coordinates that no other equation contains.
pub(crate) fn coordinates_of_one<'m>(
    names: &Names<'m>,
    equation: &Equation<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<usize> {
    let within = |e: &Equation<'m>, k: usize| {
        let mut rows = e.rows.iter();
        rows.any(|&row| equations::contains(names, row, &coordinates[k]))
    };
    let alone = |k: &usize| {
        let mut others = equations.iter().filter(|e| e.loops != equation.loops);
        others.all(|e| !within(e, *k))
    };
    (0..coordinates.len()).filter(alone).collect()
}

/// `` `let chi = phi;` instead of the unknown``; nothing for none.
fn lets_for(mechanism: &Mechanism, even: &[&ConstantRatio]) -> Option<String> {
    let lets = even.iter().map(|ratio| {
        let unknown = &mechanism.unknowns[ratio.unknown].name;
        let input = &mechanism.inputs[0].name;
        format!("`let {unknown} = {};`", ratio.relation(input))
    });
    let lets: Vec<String> = lets.collect();
    match &lets[..] {
        [] => None,
        [one] => Some(format!("{one} instead of the unknown")),
        several => Some(format!("{} instead of the unknowns", several.join(" and "))),
    }
}

/// The angles that turn evenly with the only input.
fn constant_ratios(
    names: &Names<'_>,
    places: &[Vec<f64>],
    found: &[Vec<f64>],
    coordinates: &[Coordinate],
) -> Vec<ConstantRatio> {
    if names.mechanism.inputs.len() != 1 {
        return Vec::new();
    }
    let even = coordinates
        .iter()
        .enumerate()
        .filter_map(|(k, coordinate)| {
            let CoordinateKind::Angle(_) = coordinate.kind else {
                return None;
            };
            let (x, angle) = (places[0][0], found[0][k]);
            let rates = constant_ratio::candidate_rates(names, 0).into_iter();
            let rate = rates.into_iter().find(|rate| {
                let mut all = places.iter().zip(found);
                all.all(|(position, angles)| {
                    (angles[k] - angle - rate * (position[0] - x)).abs() < ALIKE
                })
            })?;
            Some(ConstantRatio {
                unknown: coordinate.unknown?,
                rate,
                offset: angle - rate * x,
            })
        });
    even.collect()
}

/// True if the other equations find all other coordinates, not at a dead point.
fn remain_regular(
    slopes: &[Vec<f64>],
    left_out: &Equation,
    equations: &[Equation],
    found: &[usize],
) -> bool {
    let rows = equations
        .iter()
        .flat_map(|e| vec![e.loops != left_out.loops; e.rows.len()]);
    let stays: Vec<bool> = rows.collect();
    let columns = slopes
        .iter()
        .enumerate()
        .filter(|(k, _)| !found.contains(k));
    let columns = columns.map(|(_, column)| {
        let rows = column.iter().zip(&stays).filter(|(_, stays)| **stays);
        rows.map(|(x, _)| *x).collect()
    });
    are_independent(&columns.collect::<Vec<Vec<f64>>>(), ACROSS)
}

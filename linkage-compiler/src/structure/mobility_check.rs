//! Messages about the numbers of unknowns and equations.

use crate::algebra::{Names, Nominal};
use crate::message_format::loop_names;
use crate::model::Mechanism;
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::fault::StructureFault;
use crate::structure::frames::FrameFaults;
use crate::structure::link_faults::link_count;
use crate::structure::matching::Matching;
use crate::structure::nearly_redundant::nearly_redundant;
use crate::structure::redundant::RedundantLoops;
use crate::structure::{closest_approach, frames, matching, naming, redundant};

/// A check of the numbers of equations and unknowns.
pub(crate) struct MobilityCheck {
    /// True if every unknown has an equation, and every equation an unknown.
    pub(crate) complete: bool,
    /// The faults that can be described. Unknowns that the compiler introduced have no name.
    pub(crate) faults: Vec<StructureFault>,
}

/// Finds unknowns without equations, and equations without unknowns.
pub(crate) fn check_mobility<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    incidence: &[Vec<usize>],
    matching: &Matching,
) -> MobilityCheck {
    let FrameFaults {
        mut faults,
        coordinates: mut reported,
    } = frames::frame_faults(names, nominal, equations, coordinates, incidence, matching);
    let mut complete = reported.is_empty();
    for (k, coordinate) in coordinates.iter().enumerate() {
        if matching.equation_of[k].is_some() || reported.contains(&k) {
            continue;
        }
        complete = false;
        let (undetermined, sharing) = matching::undetermined_with(k, incidence, matching);
        faults.extend(undetermined_unknowns(
            names,
            coordinate,
            &undetermined,
            &sharing,
            equations,
            coordinates,
        ));
        reported.extend(undetermined);
    }
    for (k, equation) in equations.iter().enumerate() {
        let surplus = equation.rows.len() - matching.coordinates_of[k].len();
        if incidence[k].is_empty() && is_reported(names.mechanism, equation, &reported, coordinates)
        {
            continue;
        }
        if surplus > 0 && (complete || incidence[k].is_empty()) {
            complete = false;
            faults.push(surplus_equations(
                names,
                nominal,
                equation,
                surplus,
                &incidence[k],
                equations,
                coordinates,
            ));
        }
    }
    MobilityCheck { complete, faults }
}

/// True for a loop whose unknowns cancel out, if that has been said of one of them.
fn is_reported<'m>(
    mechanism: &Mechanism,
    equation: &Equation<'m>,
    reported: &[usize],
    coordinates: &[Coordinate],
) -> bool {
    let written = mechanism.usage(&equation.loops).unknowns;
    let mut reported = reported.iter().filter_map(|&k| coordinates[k].unknown);
    reported.any(|unknown| written[unknown])
}

/// Returns the fault of an unknown without an equation; `None` if the compiler introduced it.
fn undetermined_unknowns<'m>(
    names: &Names<'m>,
    coordinate: &Coordinate,
    undetermined: &[usize],
    sharing: &[usize],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<StructureFault> {
    let unknown = coordinate.unknown?;
    let origin = names.mechanism.unknowns[unknown].origin;
    let fault = |text| Some(StructureFault { origin, text });
    let name = &names.mechanism.unknowns[unknown].name;
    if sharing.is_empty() && naming::is_component(undetermined, coordinates) {
        let component = naming::coordinate_name(names, coordinate);
        let dimension = names.mechanism.unknowns[unknown].ty.dimension();
        let norm = if dimension.is_some_and(|d| d.half_lengths == 0) {
            format!("; the loop of a direction is `norm({name}) = 1`")
        } else {
            String::new()
        };
        return fault(format!(
            "`{component}` is in no loop\nhelp: add a `loop` that contains it{norm}"
        ));
    }
    let written: Vec<usize> = (0..names.mechanism.loops.len())
        .filter(|&k| names.mechanism.usage(&[k]).unknowns[unknown])
        .collect();
    if sharing.is_empty() && !written.is_empty() {
        let loops = loop_names(names.mechanism, &written);
        return fault(format!(
            "no loop changes with `{name}`: it cancels out of {loops}\n\
             help: look for a vector that is turned by `{name}` and lies along its axis, or that is multiplied by 0"
        ));
    }
    if sharing.is_empty() {
        if let Some(links) = link_count(names.mechanism, equations, coordinates) {
            return fault(links.moving(&[coordinate], 1));
        }
        return fault(format!(
            "unknown `{name}` is in no loop\n\
             help: add a `loop` that contains it, or write it as `let` or `input`"
        ));
    }
    let rows: usize = sharing.iter().map(|&k| equations[k].rows.len()).sum();
    let surplus = undetermined.len() - rows;
    let open: Vec<&Coordinate> = undetermined.iter().map(|&k| &coordinates[k]).collect();
    if let Some(links) = link_count(names.mechanism, equations, coordinates) {
        return fault(links.moving(&open, surplus));
    }
    let inputs = names.mechanism.inputs.len();
    fault(format!(
        "more unknowns than equations: {} ({}) but {} from {}; mobility {}, driven inputs {inputs}\n\
             help: add a loop, or make {}",
        naming::counted(undetermined.len(), "unknown"),
        naming::unknown_names(names, open.into_iter()),
        naming::counted(rows, "equation"),
        loop_names(
            names.mechanism,
            sharing.iter().flat_map(|&k| &equations[k].loops)
        ),
        inputs + surplus,
        if surplus == 1 {
            "one of these unknowns an `input`".to_owned()
        } else {
            format!("{surplus} of these unknowns inputs")
        },
    ))
}

/// Returns the fault of a loop with more equations than unknowns.
fn surplus_equations<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equation: &Equation<'m>,
    surplus: usize,
    contained: &[usize],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> StructureFault {
    let number = equation.loops[0];
    let origin = names.mechanism.loops[number].origin;
    let loops = loop_names(names.mechanism, &equation.loops);
    let text = if let Some(links) = link_count(names.mechanism, equations, coordinates) {
        let moved: Vec<&Coordinate> = contained.iter().map(|&k| &coordinates[k]).collect();
        let repeated =
            redundant::redundant_loops(names, nominal, equation, surplus, equations, coordinates)
                .or_else(|| nearly_redundant(names, nominal, equation, equations, coordinates));
        let RedundantLoops { fact, help } = repeated.unwrap_or_else(|| RedundantLoops {
            fact: String::new(),
            help: links.leave_out(equation),
        });
        format!("{}\nhelp: {help}", links.held(equation, &moved, &fact))
    } else if contained.is_empty() {
        format!(
            "{loops} contains no unknown\nhelp: a loop closes by unknowns; add an `unknown` to it or remove it"
        )
    } else {
        let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
        let inputs = names.mechanism.inputs.len();
        let mobility = (inputs + coordinates.len()) as isize - rows as isize;
        let unknowns: Vec<Coordinate> = contained.iter().map(|&k| coordinates[k].clone()).collect();
        let short = closest_approach::short_of(names, nominal, equation, &unknowns);
        let short = short.map_or_else(String::new, |short| format!(": {short}"));
        let link = match equation.rows.len() {
            3 => "; a link between two ball joints is one equation, `distance(a, b) = length`",
            _ => "",
        };
        let repeated =
            redundant::redundant_loops(names, nominal, equation, surplus, equations, coordinates)
                .or_else(|| nearly_redundant(names, nominal, equation, equations, coordinates));
        let RedundantLoops { fact, help } = repeated.unwrap_or_else(|| RedundantLoops {
                fact: short,
                help: format!(
                    "make a dimension, an angle or an input of {loops} an `unknown`, or remove a loop{link}"
                ),
            });
        format!(
            "more equations than unknowns: {loops} {} too many for {} ({} for {} in all; mobility {mobility}, \
                 driven inputs {inputs}){fact}\n\
                 help: {help}",
            if surplus == 1 {
                "has one equation".to_owned()
            } else {
                format!("has {surplus} equations")
            },
            naming::unknown_names(names, contained.iter().map(|&k| &coordinates[k])),
            naming::counted(rows, "equation"),
            naming::counted(coordinates.len(), "unknown"),
        )
    };
    StructureFault { origin, text }
}

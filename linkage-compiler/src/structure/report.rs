//! Messages of the structural analysis: mobility.

use super::Analysis;
use super::equations::{Coordinate, CoordinateKind, Equation};
use super::matching::{self, Matching};
use super::redundant::Repeated;
use crate::message_format::loop_list;
use crate::structure::closest_approach;
use crate::structure::frames;
use crate::structure::redundant;

/// Reports unknowns without equations and equations without unknowns; true if there are none.
pub(super) fn report_mobility<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    incidence: &[Vec<usize>],
    matching: &Matching,
) -> bool {
    let mut told = frames::report_frames(analysis, equations, coordinates, incidence, matching);
    let mut complete = told.is_empty();
    for (k, coordinate) in coordinates.iter().enumerate() {
        if matching.equation_of[k].is_some() || told.contains(&k) {
            continue;
        }
        complete = false;
        let (undetermined, sharing) = matching::undetermined_with(k, incidence, matching);
        report_undetermined(
            analysis,
            coordinate,
            &undetermined,
            &sharing,
            equations,
            coordinates,
        );
        told.extend(undetermined);
    }
    for (k, equation) in equations.iter().enumerate() {
        let surplus = equation.rows.len() - matching.coordinates_of[k].len();
        if incidence[k].is_empty() && is_told(analysis, equation, &told, coordinates) {
            continue;
        }
        if surplus > 0 && (complete || incidence[k].is_empty()) {
            complete = false;
            report_surplus(
                analysis,
                equation,
                surplus,
                &incidence[k],
                equations,
                coordinates,
            );
        }
    }
    complete
}

/// True for a loop whose unknowns cancel out, if that has been said of one of them.
fn is_told<'m>(
    analysis: &Analysis<'_, 'm>,
    equation: &Equation<'m>,
    told: &[usize],
    coordinates: &[Coordinate],
) -> bool {
    let written = analysis.algebra.mechanism.usage(&equation.loops).unknowns;
    let mut told = told.iter().filter_map(|&k| coordinates[k].unknown);
    told.any(|unknown| written[unknown])
}

fn report_undetermined<'m>(
    analysis: &mut Analysis<'_, 'm>,
    coordinate: &Coordinate,
    undetermined: &[usize],
    sharing: &[usize],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) {
    let Some(unknown) = coordinate.unknown else {
        return;
    };
    let origin = analysis.algebra.mechanism.unknowns[unknown].origin;
    let name = &analysis.algebra.mechanism.unknowns[unknown].name;
    if sharing.is_empty() && is_component(analysis, undetermined, coordinates) {
        let component = coordinate_name(analysis, coordinate);
        let dimension = analysis.algebra.mechanism.unknowns[unknown].ty.dimension();
        let norm = match dimension.is_some_and(|d| d.half_lengths == 0) {
            true => format!("; the loop of a direction is `norm({name}) = 1`"),
            false => String::new(),
        };
        return analysis.reporter.error(
            origin,
            format!("`{component}` is in no loop\nhelp: add a `loop` that contains it{norm}"),
        );
    }
    let written: Vec<usize> = (0..analysis.algebra.mechanism.loops.len())
        .filter(|&k| analysis.algebra.mechanism.usage(&[k]).unknowns[unknown])
        .collect();
    if sharing.is_empty() && !written.is_empty() {
        let loops = loop_list(&written);
        return analysis.reporter.error(
                origin,
                format!(
                    "no loop changes with `{name}`: it cancels out of {loops}\n\
                     help: look for a vector that is turned by `{name}` and lies along its axis, or that is multiplied by 0"
                ),
            );
    }
    if sharing.is_empty() {
        return analysis.reporter.error(
            origin,
            format!(
                "unknown `{name}` is in no loop\n\
                     help: add a `loop` that contains it, or write it as `let` or `input`"
            ),
        );
    }
    let rows: usize = sharing.iter().map(|&k| equations[k].rows.len()).sum();
    let surplus = undetermined.len() - rows;
    let inputs = analysis.algebra.mechanism.inputs.len();
    let message = format!(
        "more unknowns than equations: {} ({}) but {} from {}; mobility {}, driven inputs {inputs}\n\
             help: add a loop, or make {}",
        counted(undetermined.len(), "unknown"),
        unknown_names(analysis, undetermined.iter().map(|&k| &coordinates[k])),
        counted(rows, "equation"),
        loop_list(sharing.iter().flat_map(|&k| &equations[k].loops)),
        inputs + surplus,
        if surplus == 1 {
            "one of these unknowns an `input`".to_owned()
        } else {
            format!("{surplus} of these unknowns inputs")
        },
    );
    analysis.reporter.error(origin, message);
}

fn report_surplus<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    surplus: usize,
    contained: &[usize],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) {
    let number = equation.loops[0];
    let origin = analysis.algebra.mechanism.loops[number].origin;
    let loops = loop_list(&equation.loops);
    let message = if contained.is_empty() {
        format!(
            "{loops} contains no unknown\nhelp: a loop closes by unknowns; add an `unknown` to it or remove it"
        )
    } else {
        let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
        let inputs = analysis.algebra.mechanism.inputs.len();
        let mobility = (inputs + coordinates.len()) as isize - rows as isize;
        let own: Vec<Coordinate> = contained.iter().map(|&k| coordinates[k].clone()).collect();
        let short = closest_approach::short_of(analysis, equation, &own);
        let short = short.map_or_else(String::new, |short| format!(": {short}"));
        let link = match equation.rows.len() {
            3 => "; a link between two ball joints is one equation, `distance(a, b) = length`",
            _ => "",
        };
        let repeated = redundant::repeated(analysis, equation, surplus, equations, coordinates);
        let Repeated { fact, help } = repeated.unwrap_or_else(|| Repeated {
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
            unknown_names(analysis, contained.iter().map(|&k| &coordinates[k])),
            counted(rows, "equation"),
            counted(coordinates.len(), "unknown"),
        )
    };
    analysis.reporter.error(origin, message);
}

/// The unknowns behind coordinates; of a vector that is not there as a whole, the components.
fn unknown_names<'c>(
    analysis: &Analysis<'_, '_>,
    coordinates: impl Iterator<Item = &'c Coordinate>,
) -> String {
    let coordinates: Vec<&Coordinate> = coordinates.filter(|c| c.unknown.is_some()).collect();
    let mut names: Vec<(usize, String)> = Vec::new();
    for coordinate in &coordinates {
        let Some(unknown) = coordinate.unknown else {
            continue;
        };
        let of_it = coordinates.iter().filter(|c| c.unknown == Some(unknown));
        let name = match of_it.count() == analysis.algebra.names.components_of(unknown) {
            true => analysis.algebra.mechanism.unknowns[unknown].name.clone(),
            false => coordinate_name(analysis, coordinate),
        };
        names.push((unknown, format!("`{name}`")));
    }
    names.sort_by_key(|(unknown, _)| *unknown);
    names.dedup();
    let names: Vec<String> = names.into_iter().map(|(_, name)| name).collect();
    names.join(", ")
}

/// True if these are not all components of the first one's unknown.
fn is_component(_analysis: &Analysis<'_, '_>, own: &[usize], coordinates: &[Coordinate]) -> bool {
    let Some(unknown) = own.first().and_then(|&k| coordinates[k].unknown) else {
        return false;
    };
    let of_it = own
        .iter()
        .filter(|&&k| coordinates[k].unknown == Some(unknown));
    let missing = coordinates.iter().filter(|c| c.unknown == Some(unknown));
    of_it.count() < missing.count()
}

/// `theta`, or a component: `p.x`.
fn coordinate_name(analysis: &Analysis<'_, '_>, coordinate: &Coordinate) -> String {
    match coordinate.kind {
        CoordinateKind::Length(symbol) => analysis.algebra.graph.symbol(symbol).name,
        CoordinateKind::Angle(angle) => {
            let value = analysis.algebra.names.angles[angle].value;
            analysis.algebra.graph.symbol(value).name
        }
    }
}

pub(super) fn names(analysis: &Analysis<'_, '_>, mut unknowns: Vec<usize>) -> String {
    unknowns.sort_unstable();
    unknowns.dedup();
    let name = |&k: &usize| format!("`{}`", analysis.algebra.mechanism.unknowns[k].name);
    unknowns.iter().map(name).collect::<Vec<_>>().join(", ")
}

/// `1 unknown`, `3 unknowns`
pub(super) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

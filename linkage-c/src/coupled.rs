//! Groups without a closed form: states that are known over the ranges of their inputs, from which
//! Newton steps begin.

mod constants;

use std::collections::BTreeSet;
use std::fmt::Write;

use linkage_compiler::ir::{CompiledMechanism, Coupled};
use linkage_core::certificate::{ALLOWED_CONTRACTION, FIRST_CORRECTION, STEPS_BESIDE};
use linkage_core::numeric::continuation::{Axis, CellLayout, NodeLayout, Terms};
use linkage_export::{PreparedStates, RefusalCause};
use linkage_symbolic::program::Program;

use crate::real::Real;
use crate::states::{limit, look_up};
use crate::surface::Surface;
use crate::template::fill;
use crate::writer::{Writer, used, written};

/// The templates of a group: the value of a number of the state in a cell, the look-up of a state,
/// and the state for other dimensions.
struct Templates {
    value: &'static str,
    table: &'static str,
    state: &'static str,
}

/// Tables and steps of all coupled groups.
pub(crate) fn items(writer: &mut Writer) {
    let surface = writer.surface;
    for (number, declared) in surface.declarations.coupled.iter().enumerate() {
        let coupled = declared.group;
        for helper in ["nan", "select", "whole", "within", "min", "max"] {
            writer.printer.helpers.need(helper);
        }
        let (text, words, templates) = match &declared.states {
            Some(PreparedStates::Table(layout)) => {
                let mut words = of_axis(surface.real, &layout.axis);
                words.push(("OUTSIDE", surface.real.literal(CellLayout::OUTSIDE)));
                words.push(("CELLS", layout.cells.len().to_string()));
                let degree = layout.cells[0].coefficients.len() / coupled.size - 1;
                words.push(("DEGREE", degree.to_string()));
                words.push(("INPUT", coupled.inputs[0].to_string()));
                let templates = Templates {
                    value: "",
                    table: include_str!("templates/table.c"),
                    state: include_str!("templates/table_state.c"),
                };
                (constants::table(surface, number, layout), words, templates)
            }
            Some(PreparedStates::Grid(layout)) => {
                let axes = layout.axes.len();
                let words = vec![
                    ("OUTSIDE", surface.real.literal(NodeLayout::OUTSIDE)),
                    ("CELLS", layout.nodes.len().to_string()),
                    ("AXES", axes.to_string()),
                    ("TERMS", (layout.terms.degree() + 1).to_string()),
                    ("DEGREE", layout.terms.degree().to_string()),
                ];
                let value = match layout.terms {
                    Terms::Slopes => include_str!("templates/slopes.c"),
                    Terms::Polynomials => include_str!("templates/polynomials.c"),
                };
                let templates = Templates {
                    value,
                    table: include_str!("templates/grid.c"),
                    state: include_str!("templates/grid_state.c"),
                };
                (constants::grid(surface, number, layout), words, templates)
            }
            None => unreachable!("what is exported has been closed"),
        };
        let words = |word: &str| {
            let found = words.iter().find(|(name, _)| *name == word);
            found
                .map(|(_, text)| text.clone())
                .or_else(|| of_group(surface, coupled, word))
        };
        let filled = |template: &str| {
            let template = template.replace("_NUMBER", &format!("_{number}"));
            fill(
                &template,
                surface.real,
                &surface.declarations.private,
                words,
            ) + "\n"
        };
        writer.text += &text;
        writer.text += filled(templates.value).trim_end_matches('\n');
        writer.text += &filled(templates.table);
        correct(writer, number, &coupled.correct);
        writer.text += &filled(include_str!("templates/settle.c"));
        writer.text += &filled(templates.state);
    }
}

/// A Newton step of a coupled group from a state.
fn correct(writer: &mut Writer, number: usize, program: &Program) {
    let (_, prefix, private) = writer.surface.unit_and_prefixes();
    let real = writer.surface.real.name();
    let printed = writer.printed(program);
    let body = look_up(writer.surface, program, Some(number), "x") + &written(&printed);
    let state = format!("state_{number}");
    let body = used(&["m", "x", &state], body);
    let takes = format!("const {prefix} *m, const {real} *x, const {real} *{state}, {real} *out");
    let _ = writeln!(
        writer.text,
        "/* The state after a Newton step, the square of its change, the determinant before. */\n\
         static void {private}correct_{number}({takes})\n{{\n{body}}}\n"
    );
}

fn of_axis(real: Real, axis: &Axis) -> Vec<(&'static str, String)> {
    let slots = axis.slots as f64;
    vec![
        ("MIDDLE", real.literal(axis.middle)),
        ("LENGTH", real.literal(axis.length)),
        ("RATE", real.literal(axis.rate)),
        ("REPEATS", real.literal(axis.turns)),
        ("SLOTS", real.literal(slots)),
        ("HALF_SLOTS", real.literal(0.5 * slots)),
        ("LAST_SLOT", real.literal(slots - 1.0)),
    ]
}

/// Returns the text for a name that all templates use.
fn of_group(surface: &Surface, coupled: &Coupled, word: &str) -> Option<String> {
    let real = surface.real;
    Some(match word {
        "MECHANISM" => surface.declarations.name.clone(),
        "SIZE" => coupled.size.to_string(),
        "STEPPED" => (coupled.size + 2).to_string(),
        "INPUTS" => surface.declarations.unit.inputs.len().to_string(),
        "STEPS" => STEPS_BESIDE.to_string(),
        "LIMIT" => limit(real),
        "FIRST" => real.literal(FIRST_CORRECTION),
        "CONTRACTION" => real.literal(ALLOWED_CONTRACTION * ALLOWED_CONTRACTION),
        _ => return None,
    })
}

/// Scalars of dimensions that the tables depend on.
pub(crate) fn deciding(unit: &CompiledMechanism) -> BTreeSet<usize> {
    let last = unit.coupled.iter().map(|entry| entry.group).max();
    let groups = last.map_or(&[][..], |last| &unit.groups[..=last]);
    groups
        .iter()
        .flat_map(|item| item.parameters.clone())
        .collect()
}

/// The function that says whether the tables serve the dimensions; nothing without tables.
pub(crate) fn served(writer: &mut Writer) {
    let surface = writer.surface;
    let (unit, prefix, private) = surface.unit_and_prefixes();
    let real = surface.real;
    if unit.coupled.is_empty() {
        return;
    }
    let number = real.name();
    let checks = (0..unit.coupled.len()).map(|group| {
        let code = surface.code(RefusalCause::TooFar(group));
        format!("    if (!{private}serves_{group}(m, at)) return {code};\n")
    });
    let checks: String = checks.collect();
    let _ = writeln!(
        writer.text,
        "/* 0, or the number of a table that does not serve these dimensions. */\n\
         static int {private}too_far(const {prefix} *m, const {number} *at)\n{{\n{checks}    return 0;\n}}\n"
    );
}

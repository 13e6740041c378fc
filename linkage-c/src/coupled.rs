//! Groups without a closed form: a table of states over the range of their input, from which Newton steps begin.

use std::collections::BTreeSet;
use std::fmt::Write;

use linkage_compiler::unit::{Coupled, Start, Unit};
use linkage_runtime::numeric::continuation::{CellLayout, Table, TableLayout};
use linkage_symbolic::program::{Instruction, Program, Source};

use crate::comment::comment;
use crate::helper::Helper;
use crate::real::Real;
use crate::refusal::Why;
use crate::source::Writer;
use crate::surface::Surface;
use crate::template::fill;

/// Newton steps for other dimensions than those of the table, the largest first one, in radians or scaled lengths, and the square of a
/// correction over that of the one before, at most: as in sweeps over dimensions of generated Rust.
const STEPS: usize = 4;
const FIRST: f64 = 0.05;
const CONTRACTION: f64 = 1.0 / 16.0;

/// The largest correction of a state from a table that is trusted.
pub(crate) fn limit(real: Real) -> String {
    real.literal(match real {
        Real::Double => 1e-7,
        Real::Single => 1e-4,
    })
}

/// The table of a group; `None` if it has none over one input.
pub(crate) fn table(coupled: &Coupled) -> Option<&Table> {
    match &coupled.start {
        Some(Start::Table(table)) => Some(table),
        Some(Start::Grid(_)) | None => None,
    }
}

/// Statements that find the states that a program loads, in front of it, but for that of group `own`; `inputs` is the array of all inputs.
pub(crate) fn look_up(
    surface: &Surface,
    program: &Program,
    own: Option<usize>,
    inputs: &str,
) -> String {
    let loads = program.instructions.iter();
    let groups: BTreeSet<usize> = loads
        .filter_map(|instruction| match instruction {
            Instruction::Load(Source::State(group, _)) => Some(*group),
            _ => None,
        })
        .filter(|group| Some(*group) != own)
        .collect();
    let number = surface.real.name();
    let all = groups.iter().map(|&group| {
        let size = surface.unit.coupled[group].size;
        (
            format!("    {number} state_{group}[{}];\n", size + 1),
            format!(
                "    {}state_{group}(m, {inputs}, state_{group});\n",
                surface.own
            ),
        )
    });
    let (declared, found): (Vec<String>, Vec<String>) = all.unzip();
    declared.concat() + &found.concat()
}

/// Tables and steps of all coupled groups.
pub(crate) fn items(writer: &mut Writer) {
    let surface = writer.surface;
    for (number, coupled) in surface.unit.coupled.iter().enumerate() {
        let Some(table) = table(coupled) else {
            continue;
        };
        for helper in [
            Helper::Nan,
            Helper::Select,
            Helper::Whole,
            Helper::Min,
            Helper::Max,
        ] {
            writer.printer.helpers.need(helper);
        }
        let layout = table.layout();
        writer.text += &cells(surface, number, coupled.size, &layout);
        let words = |word: &str| word_of(surface, number, coupled, &layout, word);
        let (real, own) = (surface.real, &surface.own);
        writer.text += &numbered(include_str!("templates/state.c"), number, |text| {
            fill(text, real, own, words)
        });
        writer.text.push('\n');
        writer.correct(number, &coupled.correct);
        writer.text += &numbered(include_str!("templates/settle.c"), number, |text| {
            fill(text, real, own, words)
        });
        writer.text.push('\n');
    }
}

/// A template in which names end with the number of the group.
fn numbered(template: &str, number: usize, fill: impl Fn(&str) -> String) -> String {
    fill(&template.replace("_NUMBER", &format!("_{number}")))
}

/// What names in the templates stand for.
fn word_of(
    surface: &Surface,
    number: usize,
    coupled: &Coupled,
    layout: &TableLayout,
    word: &str,
) -> Option<String> {
    let real = surface.real;
    let axis = layout.axis;
    let slots = axis.slots as f64;
    Some(match word {
        "MECHANISM" => surface.prefix.clone(),
        "MIDDLE" => real.literal(axis.middle),
        "LENGTH" => real.literal(axis.length),
        "RATE" => real.literal(axis.rate),
        "REPEATS" => real.literal(axis.turns),
        "SLOTS" => real.literal(slots),
        "HALF_SLOTS" => real.literal(0.5 * slots),
        "LAST_SLOT" => real.literal(slots - 1.0),
        "OUTSIDE" => real.literal(CellLayout::OUTSIDE),
        "DEGREE" => (degree(layout, coupled.size)).to_string(),
        "CELLS" => layout.cells.len().to_string(),
        "SIZE" => coupled.size.to_string(),
        "STEPPED" => (coupled.size + 2).to_string(),
        "INPUT" => coupled.inputs[0].to_string(),
        "INPUTS" => surface.unit.inputs.len().to_string(),
        "STEPS" => STEPS.to_string(),
        "LIMIT" => limit(real),
        "FIRST" => real.literal(FIRST),
        "CONTRACTION" => real.literal(CONTRACTION),
        "NUMBER" => number.to_string(),
        _ => return None,
    })
}

fn degree(layout: &TableLayout, size: usize) -> usize {
    layout.cells[0].coefficients.len() / size - 1
}

/// The table as constants.
fn cells(surface: &Surface, number: usize, size: usize, layout: &TableLayout) -> String {
    let Surface {
        unit, own, real, ..
    } = surface;
    let name = real.name();
    let coupled = &unit.coupled[number];
    let unknowns = unit.groups[coupled.group].unknowns.join(", ");
    let mut text = comment(
        "",
        &format!(
            "{unknowns} are solved together, from states that are known over the range of {}: polynomials in cells, the lowest power first.",
            unit.inputs[coupled.inputs[0]].name
        ),
    );
    let terms = degree(layout, size) + 1;
    let _ = writeln!(
        text,
        "typedef struct {own}cell_{number} {{ {name} centre, inverse, floor, state[{terms}][{size}]; }} {own}cell_{number};\n"
    );
    let _ = writeln!(
        text,
        "static const {own}cell_{number} {own}cells_{number}[] = {{"
    );
    for cell in &layout.cells {
        let rows = cell.coefficients.chunks(size).map(|row| {
            let row: Vec<String> = row.iter().map(|x| real.literal(*x)).collect();
            format!("{{ {} }}", row.join(", "))
        });
        let rows: Vec<String> = rows.collect();
        let [centre, inverse, floor] =
            [cell.centre, cell.inverse, cell.floor].map(|x| real.literal(x));
        let _ = writeln!(
            text,
            "    {{ {centre}, {inverse}, {floor}, {{\n        {} }} }},",
            rows.join(",\n        ")
        );
    }
    text +=
        "};\n\n/* Which cell is where, in parts of the range as long as the shortest cell. */\n";
    let _ = write!(text, "static const uint16_t {own}index_{number}[] = {{");
    for (place, cell) in layout.index.iter().enumerate() {
        text += if place % 24 == 0 { "\n    " } else { " " };
        let _ = write!(text, "{cell},");
    }
    text + "\n};\n\n"
}

/// Scalars of dimensions that the tables depend on.
pub(crate) fn deciding(unit: &Unit) -> BTreeSet<usize> {
    let last = unit.coupled.iter().map(|own| own.group).max();
    let groups = last.map_or(&[][..], |last| &unit.groups[..=last]);
    groups
        .iter()
        .flat_map(|own| own.parameters.clone())
        .collect()
}

/// The function that says whether the tables serve the dimensions; nothing without tables.
pub(crate) fn served(writer: &mut Writer) {
    let surface = writer.surface;
    let Surface {
        unit,
        prefix,
        own,
        real,
        ..
    } = surface;
    if unit.coupled.is_empty() {
        return;
    }
    let number = real.name();
    let checks = (0..unit.coupled.len()).map(|group| {
        let code = surface.code(Why::TooFar(group));
        format!("    if (!{own}serves_{group}(m, at)) return {code};\n")
    });
    let checks: String = checks.collect();
    let _ = writeln!(
        writer.text,
        "/* 0, or the number of a table that does not serve these dimensions. */\n\
         static int {own}too_far(const {prefix} *m, const {number} *at)\n{{\n{checks}    return 0;\n}}\n"
    );
}

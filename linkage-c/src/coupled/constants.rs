//! Tables and grids as constants of C.

use std::fmt::Write;

use linkage_core::numeric::continuation::{GridLayout, TableLayout, Terms};
use linkage_export::{CoupledDeclaration, Declarations};

use crate::comment::comment;
use crate::surface::Surface;

/// A table over one input.
pub(super) fn table(surface: &Surface, number: usize, layout: &TableLayout) -> String {
    let Surface {
        declarations: Declarations { private, .. },
        real,
        ..
    } = surface;
    let name = real.name();
    let size = surface.declarations.unit.coupled[number].size;
    let terms = layout.cells[0].coefficients.len() / size;
    let mut text = about(
        surface,
        number,
        "polynomials in cells, the lowest power first",
    );
    let _ = writeln!(
        text,
        "typedef struct {private}cell_{number} {{ {name} centre, inverse, floor, state[{terms}][{size}]; }} {private}cell_{number};\n\n\
         static const {private}cell_{number} {private}cells_{number}[] = {{"
    );
    for cell in &layout.cells {
        let rows = cell
            .coefficients
            .chunks(size)
            .map(|row| numbers(surface, row));
        let rows: Vec<String> = rows.collect();
        let rows = rows.join(",\n        ");
        let head = [cell.centre, cell.inverse, cell.floor].map(|x| real.literal(x));
        let head = head.join(", ");
        let _ = writeln!(text, "    {{ {head}, {{\n        {rows} }} }},");
    }
    text +=
        "};\n\n/* Which cell is where, in parts of the range as long as the shortest cell. */\n";
    text + &indices(
        surface,
        number,
        layout.index.iter().map(|entry| usize::from(*entry)),
    )
}

/// A grid over several inputs, or none.
pub(super) fn grid(surface: &Surface, number: usize, layout: &GridLayout) -> String {
    let Surface {
        declarations: Declarations { private, .. },
        real,
        ..
    } = surface;
    let name = real.name();
    let coupled = &surface.declarations.unit.coupled[number];
    let (size, axes) = (coupled.size, layout.axes.len());
    let terms = layout.terms.count(axes);
    let mut text = about(
        surface,
        number,
        match layout.terms {
            Terms::Slopes => "at the centre of each cell, and how they change along it",
            Terms::Polynomials => {
                "polynomials in cells, power by power of the second input, and for each of these power by power of the first"
            }
        },
    );
    let _ = writeln!(
        text,
        "typedef struct {private}axis_{number} {{ int input; {name} middle, length, rate, repeats, slots; }} {private}axis_{number};\n\
         typedef struct {private}node_{number} {{ {name} floor, state[{terms}][{size}]; }} {private}node_{number};\n\n\
         static const {private}axis_{number} {private}axes_{number}[] = {{"
    );
    for (axis, input) in layout.axes.iter().zip(&coupled.inputs) {
        let slots = axis.slots as f64;
        let all = [axis.middle, axis.length, axis.rate, axis.turns, slots];
        let all = all.map(|x| real.literal(x)).join(", ");
        let _ = writeln!(text, "    {{ {input}, {all} }},");
    }
    let _ = writeln!(
        text,
        "}};\n\n/* The first one has no solution. */\nstatic const {private}node_{number} {private}nodes_{number}[] = {{"
    );
    let nothing = vec![f64::NAN; size * terms];
    let reached = layout.nodes.iter().flatten();
    let reached = reached.map(|node| (node.floor, node.coefficients));
    for (floor, rows) in std::iter::once((f64::NAN, &nothing[..])).chain(reached) {
        let rows = rows.chunks(size).map(|row| numbers(surface, row));
        let rows: Vec<String> = rows.collect();
        let (floor, rows) = (real.literal(floor), rows.join(",\n        "));
        let _ = writeln!(text, "    {{ {floor}, {{\n        {rows} }} }},");
    }
    text += "};\n\n/* Which of them belongs to each cell, the last input changing fastest. */\n";
    let mut count = 0;
    let index = layout.nodes.iter().map(|node| {
        count += usize::from(node.is_some());
        if node.is_some() { count } else { 0 }
    });
    text + &indices(surface, number, index)
}

/// A comment about a group's states.
fn about(surface: &Surface, number: usize, what: &str) -> String {
    let CoupledDeclaration {
        unknowns, inputs, ..
    } = &surface.declarations.coupled[number];
    comment(
        "",
        &format!(
            "{unknowns} are solved together, from states that are known over the ranges of {inputs}: {what}."
        ),
    )
}

fn numbers(surface: &Surface, row: &[f64]) -> String {
    let row: Vec<String> = row.iter().map(|x| surface.real.literal(*x)).collect();
    format!("{{ {} }}", row.join(", "))
}

/// An array of numbers of cells.
fn indices(surface: &Surface, number: usize, all: impl Iterator<Item = usize>) -> String {
    let all: Vec<usize> = all.collect();
    let small = all.iter().all(|item| u16::try_from(*item).is_ok());
    let word = if small { "uint16_t" } else { "uint32_t" };
    let mut text = format!(
        "static const {word} {}index_{number}[] = {{",
        surface.declarations.private
    );
    for (index, cell) in all.iter().enumerate() {
        text += if index % 24 == 0 { "\n    " } else { " " };
        let _ = write!(text, "{cell},");
    }
    text + "\n};\n\n"
}

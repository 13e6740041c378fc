//! Sweeps into columns: a source for programs that keep each number of a result by itself.

use std::fmt::Write;

use linkage_compiler::ir::CompiledMechanism;
use linkage_export::{FunctionDeclaration, Refused};
use linkage_symbolic::program::Source;

use crate::column_header::column_header;
use crate::column_rows::{HALVES, Rows};
use crate::comment::comment;
use crate::evaluator::values;
use crate::real::Real;
use crate::source::writer;
use crate::states::is_closed;
use crate::surface::surface;
use crate::writer::{Writer, source_expression};
use crate::{Sources, sources};

/// A mechanism as C, with sweeps into columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnSweeps {
    /// The header and the source.
    pub sources: Sources,
    /// The text of one more header, `NAME_columns.h`, which declares `sweeps`.
    pub header: String,
    /// The text of one more source, `NAME_columns.c`, which includes the other one and is compiled
    /// in its stead.
    pub columns: String,
    /// The function that closes the loops.
    pub assemble: String,
    /// The function that returns the size of an assembly.
    pub assembly_size: String,
    /// The function that returns the text of an error.
    pub error: String,
    /// For each function of the mechanism that has a sweep, the name of that into columns. It takes
    /// the assembly, the count, an array for each argument, the steps from number to number in each
    /// of them (0 for one that stands still, else 1), and an array for each column.
    pub sweeps: Vec<Option<String>>,
    /// For each function, the name of the sweep over mechanisms, in the modes of the estimates:
    /// `None` if the function needs a coupled group. It takes the turns of the angles, then as the
    /// other sweep the count, arrays for the arguments and for all dimensions, steps, and columns.
    pub sets: Vec<Option<String>>,
}

/// Prints a mechanism with sweeps into columns.
///
/// # Errors
///
/// Those of [`sources`].
///
/// ```
/// use linkage_c::{Real, column_sweeps};
///
/// let text = "pub struct Crank { unit mm; param r = 30mm; input phi = 0deg; let pin = polar(r, phi); }
///     impl Crank { pub fn motion(phi) -> Motion { pin } }";
/// let checked = linkage_compiler::check(text.parse().expect("brackets have partners"));
/// let unit = checked.unit.expect("a mechanism without a mistake");
/// let c = column_sweeps("Crank", &unit, Real::Double)?;
/// assert_eq!(c.sweeps, [Some("crank_motion_sweep_columns".to_owned())]);
/// assert!(c.header.contains("void crank_motion_sweep_columns(const crank *m, size_t count,"));
/// assert!(c.columns.starts_with("/* Sweeps into columns. */\n#include \"crank.c\""));
/// # Ok::<(), linkage_c::Refused>(())
/// ```
pub fn column_sweeps(
    name: &str,
    unit: &CompiledMechanism,
    real: Real,
) -> Result<ColumnSweeps, Refused> {
    let sources = sources(name, unit, real)?;
    let surface = surface(name, unit, real);
    let mut columns = comment("", "Sweeps into columns.");
    let _ = writeln!(
        columns,
        "#include \"{name}.c\"\n#include \"{name}_columns.h\"\n\n#include <string.h>",
        name = sources.name
    );
    let mut writer = writer(&surface);
    let functions = surface.declarations.functions.iter();
    let (mut sweeps, mut sets) = (Vec::new(), Vec::new());
    for (function, evaluator) in functions.zip(&surface.functions) {
        let Some(sweep) = &evaluator.sweep else {
            sweeps.push(None);
            sets.push(None);
            continue;
        };
        let name = format!("{}_columns", sweep.name);
        columns += &positions(&mut writer, function, &name);
        sweeps.push(Some(name));
        sets.push(is_closed(function).then(|| {
            let name = format!("{}_sets_columns", sweep.name);
            columns += &mechanisms(&mut writer, function, &name);
            name
        }));
    }
    Ok(ColumnSweeps {
        header: column_header(&surface, &sweeps),
        sweeps,
        sets,
        columns,
        assemble: surface.assemble.name.clone(),
        assembly_size: surface.assembly_size.name.clone(),
        error: surface.error.name.clone(),
        sources,
    })
}

/// The sweep of a function over positions.
fn positions(writer: &mut Writer<'_>, function: &FunctionDeclaration, name: &str) -> String {
    let (statements, results) = values(writer, function);
    let declarations = &writer.surface.declarations;
    // Names of the user are in the statements.
    let private = &declarations.private;
    let bodies = HALVES.map(|half| {
        arguments(writer, function, half) + &statements + &stored(private, half, &results)
    });
    Rows {
        name,
        shared: format!("const {} *m", declarations.name),
        passed: "m".to_owned(),
        arrays: function.arguments.len(),
        columns: results.len(),
        bodies,
        is_closed: is_closed(function),
    }
    .text(writer)
}

/// The sweep of a function over mechanisms: each row prepares its own.
fn mechanisms(writer: &mut Writer<'_>, function: &FunctionDeclaration, name: &str) -> String {
    let surface = writer.surface;
    let (declarations, number) = (&surface.declarations, surface.real.name());
    let (unit, private) = (&declarations.unit, &declarations.private);
    let program = &function.function.called.program;
    let (preparing, slots) = unit.preparing(program);
    let first = function.arguments.len();
    let inputs = unit.inputs.len() + 1;
    let turns = |entry: usize| format!("{private}turns[{entry}]");
    let mut columns = 0;
    let bodies = HALVES.map(|half| {
        let source = |source| match source {
            Source::Input(index) => {
                let argument = function.argument(index);
                argument.expect("a program uses only its inputs").to_owned()
            }
            Source::Parameter(index) => format!("{private}{half}x{}[{private}k]", first + index),
            Source::Prepared(slot) => format!("{private}p{slot}"),
            Source::Centre(angle) => turns(angle * inputs),
            Source::Winding(angle, input) => turns(angle * inputs + 1 + input),
            other => source_expression(surface, other),
        };
        let prepared = writer.printer.program(&preparing, &source);
        let printed = writer.printer.program(program, &source);
        columns = printed.results.len();
        let mut body = arguments(writer, function, half);
        for slot in &slots {
            let _ = writeln!(body, "    {number} {private}p{slot};");
        }
        // Both programs have the same names of values.
        let _ = writeln!(body, "    {{\n{}", prepared.statements.trim_end());
        for (slot, value) in slots.iter().zip(&prepared.results) {
            let _ = writeln!(body, "    {private}p{slot} = {value};");
        }
        let _ = writeln!(body, "    }}\n{}", printed.statements.trim_end());
        body + &stored(private, half, &printed.results)
    });
    Rows {
        name,
        shared: format!("const {number} *{private}turns"),
        passed: format!("{private}turns"),
        arrays: first + declarations.scalars.len(),
        columns,
        bodies,
        is_closed: is_closed(function),
    }
    .text(writer)
}

/// Statements that read the arguments of a row in a half.
fn arguments(writer: &Writer<'_>, function: &FunctionDeclaration, half: &str) -> String {
    let (private, number) = (
        &writer.surface.declarations.private,
        writer.surface.real.name(),
    );
    let mut text = String::new();
    for (k, argument) in function.arguments.iter().enumerate() {
        let name = &argument.name;
        let _ = writeln!(
            text,
            "    const {number} {name} = {private}{half}x{k}[{private}k];"
        );
    }
    text
}

/// Statements that store the results of a row in a half.
fn stored(private: &str, half: &str, results: &[String]) -> String {
    let mut text = String::new();
    for (k, result) in results.iter().enumerate() {
        let _ = writeln!(text, "    {private}{half}c{k}[{private}k] = {result};");
    }
    text
}

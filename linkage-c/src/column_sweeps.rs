//! Sweeps into columns: a source for programs that keep each number of a result by itself.

use std::fmt::Write;

use linkage_compiler::ir::CompiledMechanism;
use linkage_export::{FunctionDeclaration, Refused};

use crate::comment::comment;
use crate::evaluator::values;
use crate::real::Real;
use crate::source::writer;
use crate::surface::surface;
use crate::writer::Writer;
use crate::{Sources, sources};

/// Positions of a block.
const BLOCK: usize = 512;

/// A mechanism as C, with sweeps into columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnSweeps {
    /// The header and the source.
    pub sources: Sources,
    /// The text of one more source, which includes the other one and is compiled in its stead.
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
        "#include \"{}.c\"\n\n#include <string.h>",
        sources.name
    );
    let mut writer = writer(&surface);
    let functions = surface.declarations.functions.iter();
    let functions = functions.zip(&surface.functions);
    let sweeps = functions.map(|(function, evaluator)| {
        let sweep = evaluator.sweep.as_ref()?;
        let name = format!("{}_columns", sweep.name);
        columns += &sweep_text(&mut writer, function, &name);
        Some(name)
    });
    Ok(ColumnSweeps {
        sweeps: sweeps.collect(),
        columns,
        assemble: surface.assemble.name.clone(),
        assembly_size: surface.assembly_size.name.clone(),
        error: surface.error.name.clone(),
        sources,
    })
}

/// The sweep of a function: rows of a block by a function whose arrays do not overlap, so that
/// compilers compute several rows at once. Arguments that stand still fill an array of a block.
fn sweep_text(writer: &mut Writer<'_>, function: &FunctionDeclaration, name: &str) -> String {
    let (statements, results) = values(writer, function);
    let declarations = &writer.surface.declarations;
    let (mechanism, number) = (&declarations.name, writer.surface.real.name());
    // Names of the user are in the statements.
    let private = &declarations.private;
    let arguments = function.arguments.iter().enumerate();
    let mut values = String::new();
    for (k, argument) in arguments {
        let name = &argument.name;
        let _ = writeln!(
            values,
            "    const {number} {name} = {private}x{k}[{private}k];"
        );
    }
    values += &statements;
    for (k, result) in results.iter().enumerate() {
        let _ = writeln!(values, "    {private}c{k}[{private}k] = {result};");
    }
    let values = values.replace('\n', "\n    ");
    let list = |count: usize, item: &dyn Fn(usize) -> String| (0..count).map(item).collect();
    let (arguments, results) = (function.arguments.len(), results.len());
    let inputs: String = list(arguments, &|k| {
        format!(", const {number} *restrict {private}x{k}")
    });
    let outputs: String = list(results, &|k| format!(", {number} *restrict {private}c{k}"));
    let rows = format!(
        "
static void {name}_rows(const {mechanism} *m, size_t {private}count{inputs}{outputs})
{{
    size_t {private}k;
    for ({private}k = 0; {private}k < {private}count; {private}k++) {{
    {}
    }}
}}
",
        values.trim_end()
    );
    let constants: String = list(arguments, &|k| {
        format!(
            "    {number} s{k}[{BLOCK}];\n    if (!steps[{k}]) for (k = 0; k < {BLOCK}; k++) s{k}[k] = x[{k}][0];\n"
        )
    });
    let inputs: String = list(arguments, &|k| {
        format!(", steps[{k}] ? x[{k}] + from : s{k}")
    });
    let outputs: String = list(results, &|k| format!(", columns[{k}] + from"));
    rows + &format!(
        "
void {name}(const {mechanism} *m, size_t count, const {number} *const *x, const size_t *steps, {number} *const *columns)
{{
    size_t from, k;
{constants}    for (from = 0; from < count; from += {BLOCK}) {{
        const size_t rows = count - from < {BLOCK} ? count - from : {BLOCK};
        {name}_rows(m, rows{inputs}{outputs});
    }}
}}
"
    )
}

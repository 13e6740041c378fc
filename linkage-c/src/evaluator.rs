//! Functions of the user.

use std::fmt::Write;

use linkage_export::{FunctionDeclaration, scalar_paths};
use linkage_symbolic::program::Source;

use crate::states::{is_closed, look_up};
use crate::surface::{Declared, Evaluator, Surface};
use crate::writer::{Writer, source_expression, used};

/// Writes a function of the user, and its sweep.
pub(crate) fn evaluator(
    writer: &mut Writer,
    function: &FunctionDeclaration,
    evaluator: &Evaluator,
) {
    let Evaluator {
        declared,
        result,
        sweep,
    } = evaluator;
    let (mut body, results) = values(writer, function);
    let fields = function.fields.iter();
    let targets = fields.flat_map(|field| scalar_paths(&field.name, field.shape));
    for (target, value) in targets.zip(&results) {
        let _ = writeln!(body, "    result.{target} = {value};");
    }
    if function.fields.is_empty() {
        body += "    result.nothing = 0;\n";
    }
    let arguments = function.arguments.iter();
    let arguments = arguments.map(|argument| &argument.name[..]);
    let names: Vec<&str> = ["m"].into_iter().chain(arguments.clone()).collect();
    let body = format!("    {result} result;\n") + &used(&names, body) + "    return result;\n";
    let call = |function: &str, end: &str| {
        let inputs = arguments.clone().map(|entry| format!(", {entry}{end}"));
        format!("{function}(m{})", inputs.collect::<String>())
    };
    let Declared {
        name,
        signature,
        parameters,
    } = declared;
    // A group that is solved step by step keeps rows apart.
    let is_one = sweep.is_some() && is_closed(function);
    let private = &writer.surface.declarations.private;
    let (row, rows) = match is_one {
        true => (format!("{private}row_{name}"), format!("{private}rows ")),
        false => (name.clone(), String::new()),
    };
    let text = match is_one {
        // A library may not take over a function that another one can replace: rows have their own.
        true => format!(
            "static {result} {row}({parameters})\n{{\n{body}}}\n\n{rows}{signature}\n{{\n    return {};\n}}\n\n",
            call(&row, "")
        ),
        false => format!("{signature}\n{{\n{body}}}\n\n"),
    };
    writer.text += &text;
    if let Some(Declared { signature, .. }) = sweep {
        let _ = writeln!(
            writer.text,
            "{rows}{signature}\n{{\n    size_t k;\n    for (k = 0; k < count; k++) results[k] = {};\n}}\n",
            call(&row, "[k]")
        );
    }
}

/// Statements that compute a function, and the expressions of its numbers after them. They use `m`
/// and the arguments by their names.
pub(crate) fn values(writer: &mut Writer, function: &FunctionDeclaration) -> (String, Vec<String>) {
    let surface = writer.surface;
    let program = &function.function.called.program;
    let printed = writer.printer.program(program, &|source| match source {
        Source::Input(index) => {
            let argument = function.argument(index);
            argument.expect("a program uses only its inputs").to_owned()
        }
        other => source_expression(surface, other),
    });
    let statements = states(surface, function) + &printed.statements;
    (statements, printed.results)
}

/// Statements that find the states of the coupled groups that a function needs.
fn states(surface: &Surface, function: &FunctionDeclaration) -> String {
    let found = look_up(surface, &function.function.called.program, None, "inputs");
    if found.is_empty() {
        return found;
    }
    let inputs = surface.declarations.inputs.iter().enumerate();
    let inputs = inputs.map(|(index, declared)| {
        let argument = function.argument(index).map(str::to_owned);
        // What a function does not take, its groups do not depend on.
        argument.unwrap_or_else(|| surface.real.literal(declared.input.reference))
    });
    let inputs: Vec<String> = inputs.collect();
    let (number, inputs) = (surface.real.name(), inputs.join(", "));
    format!("    const {number} inputs[] = {{ {inputs} }};\n{found}")
}

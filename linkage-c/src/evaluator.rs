//! Functions of the user.

use std::fmt::Write;

use linkage_symbolic::program::Source;

use crate::states::look_up;
use crate::surface::{Evaluator, Surface, places};
use crate::writer::{Writer, source_expression, used};

/// Writes a function of the user, and its sweep.
pub(crate) fn evaluator(writer: &mut Writer, evaluator: &Evaluator) {
    let surface = writer.surface;
    let Evaluator {
        declared,
        result,
        function,
        arguments,
        ..
    } = evaluator;
    let program = &function.called.program;
    let printed = writer.printer.program(program, &|source| match source {
        Source::Input(index) => {
            let position = function
                .arguments
                .iter()
                .position(|argument| *argument == index);
            arguments[position.expect("a program uses only its inputs")].clone()
        }
        other => source_expression(surface, other),
    });
    let mut body = states(surface, evaluator) + &printed.statements;
    let fields = evaluator.fields.iter();
    let targets = fields.flat_map(|field| places(&field.name, &field.shape));
    for (target, value) in targets.zip(&printed.results) {
        let _ = writeln!(body, "    result.{target} = {value};");
    }
    if evaluator.fields.is_empty() {
        body += "    result.nothing = 0;\n";
    }
    let mut names = vec!["m"];
    names.extend(arguments.iter().map(String::as_str));
    let body = format!("    {result} result;\n") + &used(&names, body) + "    return result;\n";
    let signature = &declared.signature;
    let _ = writeln!(writer.text, "{signature}\n{{\n{body}}}\n");
    if let Some(sweep) = &evaluator.sweep {
        let at: String = arguments
            .iter()
            .map(|entry| format!(", {entry}[k]"))
            .collect();
        let (name, signature) = (&declared.name, &sweep.signature);
        let _ = writeln!(
            writer.text,
            "{signature}\n{{\n    size_t k;\n    for (k = 0; k < count; k++) results[k] = {name}(m{at});\n}}\n"
        );
    }
}

/// Statements that find the states of the coupled groups that a function needs.
fn states(surface: &Surface, evaluator: &Evaluator) -> String {
    let function = evaluator.function;
    let found = look_up(surface, &function.called.program, None, "inputs");
    if found.is_empty() {
        return found;
    }
    let inputs = surface
        .unit
        .inputs
        .iter()
        .enumerate()
        .map(|(index, input)| {
            let position = function
                .arguments
                .iter()
                .position(|argument| *argument == index);
            // What a function does not take, its groups do not depend on.
            position.map_or_else(
                || surface.real.literal(input.reference),
                |position| evaluator.arguments[position].clone(),
            )
        });
    let inputs: Vec<String> = inputs.collect();
    let (number, inputs) = (surface.real.name(), inputs.join(", "));
    format!("    const {number} inputs[] = {{ {inputs} }};\n{found}")
}

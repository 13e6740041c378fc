//! Names of a function, of its arguments and of its results.

use linkage_compiler::ir::{CompiledMechanism, Function};

use super::data::{Evaluator, Field};
use super::declared::Declared;
use super::notes::{field_note, input_note};
use super::renamed::Log;
use crate::c_names::{Names, Namespace};
use crate::real::Real;

/// Names that those of a function's arguments and results must differ from.
pub(super) struct Scope<'a> {
    pub(super) unit: &'a CompiledMechanism,
    pub(super) real: Real,
    pub(super) prefix: &'a str,
    pub(super) types: &'a [&'a str],
}

pub(super) fn evaluator<'a>(
    Scope {
        unit,
        real,
        prefix,
        types,
    }: Scope,
    function: &'a Function,
    global: &mut dyn FnMut(&str) -> String,
    renamed: &mut Log,
) -> Evaluator<'a> {
    let declared = &function.name;
    let mut of_function = |end: &str, kind: &str| {
        let name = global(&format!("{declared}{end}"));
        let usual = format!("{prefix}_{declared}{end}");
        renamed.note(|| format!("{kind} `{declared}`"), &usual, &name);
        name
    };
    let result = of_function("_result", "the result of the function");
    let sweep = (!function.arguments.is_empty())
        .then(|| of_function("_sweep", "the sweep of the function"));
    let name = of_function("", "the function");
    // What else the function has in scope.
    let others = ["m", "count", "results", "result", "k", "inputs"];
    let others = [&others[..], &[prefix, &name, &result]].concat();
    let mut scope = Names::new(Namespace::Function, &others);
    let mut arguments = Vec::new();
    let mut argument_notes = Vec::new();
    for &index in &function.arguments {
        let (usual, note) = match index.checked_sub(unit.inputs.len()) {
            None => (&unit.inputs[index].name, input_note(unit, index)),
            Some(index) => {
                let argument = &unit.arguments[index];
                (&argument.name, argument.unit.clone())
            }
        };
        let name = scope.take(usual);
        renamed.note(
            || format!("the argument `{usual}` of `{declared}`"),
            usual,
            &name,
        );
        arguments.push(name);
        argument_notes.push(note);
    }
    let mut names = Names::new(Namespace::Struct, types);
    let mut columns = &function.columns[..];
    let fields = function.fields.iter().map(|field| {
        let (of_field, rest) = columns.split_at(field.shape.width());
        columns = rest;
        let usual = &field.name;
        let name = names.take(usual);
        renamed.note(
            || format!("the result `{usual}` of `{declared}`"),
            usual,
            &name,
        );
        Field {
            name,
            documentation: &field.documentation,
            note: field_note(field, of_field),
            shape: field.shape.clone(),
        }
    });
    let fields = fields.collect();
    let number = real.name();
    let numbers = arguments.iter().map(|entry| format!(", {number} {entry}"));
    let arrays = arguments
        .iter()
        .map(|item| format!(", const {number} *{item}"));
    let sweep = sweep.map(|name| Declared {
        signature: format!(
            "void {name}(const {prefix} *m, size_t count{}, {result} *results)",
            arrays.collect::<String>()
        ),
        name,
    });
    Evaluator {
        fields,
        declared: Declared {
            signature: format!(
                "{result} {name}(const {prefix} *m{})",
                numbers.collect::<String>()
            ),
            name,
        },
        result,
        sweep,
        function,
        arguments,
        argument_notes,
    }
}

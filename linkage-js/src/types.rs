//! Types for TypeScript.

use std::fmt::Write;

use linkage_compiler::ir::{CompiledMechanism, Function, Shape, plain};

use crate::js_names::arguments as named;

/// The part that is the same for all mechanisms.
const COMMON: &str = include_str!("common.d.ts");

/// The text of the `.d.ts` file beside the module, which exports the mechanism `title` by a name of
/// JavaScript.
pub(crate) fn types(title: &str, name: &str, unit: &CompiledMechanism) -> String {
    let mut text =
        format!("// {title}. Written by linkage; not to be changed by hand.\n\n{COMMON}\n");
    let _ = writeln!(
        text,
        "/** Dimensions of {title} by name. */\nexport interface Dimensions {{"
    );
    for scalar in unit.scalars() {
        let _ = writeln!(
            text,
            "  /** {} */\n  {}: number;",
            measure(&scalar.unit),
            key(&scalar.name)
        );
    }
    let _ = writeln!(
        text,
        "}}\n\n/** Closed loops: results at any inputs. */\nexport interface Assembly {{"
    );
    for function in &unit.functions {
        text += &documented("  ", &about(function));
        let _ = writeln!(
            text,
            "  {}({}): {};",
            method(plain(&function.name)),
            arguments(unit, function),
            result(function)
        );
    }
    let _ = writeln!(text, "}}\n");
    text += &documented("", &unit.documentation);
    let _ = writeln!(
        text,
        "export declare const {name}: Mechanism<Dimensions, Assembly>;"
    );
    text
}

fn arguments(unit: &CompiledMechanism, called: &Function) -> String {
    let names = called.arguments.iter().map(|&index| {
        let name = match index.checked_sub(unit.inputs.len()) {
            None => &unit.inputs[index].name,
            Some(index) => &unit.arguments[index].name,
        };
        plain(name)
    });
    let arguments = named(names).into_iter();
    let arguments: Vec<String> = arguments.map(|name| format!("{name}: number")).collect();
    arguments.join(", ")
}

/// The name of a method: `new` alone would make an assembly a constructor.
fn method(name: &str) -> String {
    match name {
        "new" => "\"new\"".to_owned(),
        name => name.to_owned(),
    }
}

/// The function's doc comment, then the meaning of its results.
fn about(called: &Function) -> String {
    let told = called.fields.iter().map(|field| {
        let name = plain(&field.name);
        match &field.description()[..] {
            "" => format!("- `{name}`: a number"),
            about => format!("- `{name}`: {about}"),
        }
    });
    let results = told.collect::<Vec<_>>().join("\n");
    match called.documentation.trim() {
        "" => results,
        documentation => format!("{documentation}\n\n{results}"),
    }
}

fn result(called: &Function) -> String {
    let fields = called.fields.iter();
    let fields: Vec<String> = fields
        .map(|field| format!("{}: {}", plain(&field.name), shape(&field.shape)))
        .collect();
    format!("{{ {} }}", fields.join("; "))
}

fn shape(declared: &Shape) -> String {
    match declared {
        Shape::Scalar => "number".to_owned(),
        Shape::Vector(count) => format!("[{}]", vec!["number"; *count].join(", ")),
        Shape::Array(_, entry) => format!("{}[]", shape(entry)),
        Shape::Frame => "[Axis, Axis, Axis, Axis]".to_owned(),
        Shape::PlaneFrame => format!("[{}]", ["[number, number]"; 3].join(", ")),
    }
}

fn measure(unit: &str) -> &str {
    if unit.is_empty() { "a number" } else { unit }
}

/// `pivot.x` is a name that stands in quotes.
fn key(name: &str) -> String {
    let plain = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    if plain {
        name.to_owned()
    } else {
        format!("\"{name}\"")
    }
}

/// Returns a doc comment, with the end mark of comments taken apart.
fn documented(indent: &str, documentation: &str) -> String {
    let lines: Vec<&str> = documentation.lines().map(str::trim).collect();
    if lines.iter().all(|line| line.is_empty()) {
        return String::new();
    }
    let mut text = format!("{indent}/**\n");
    for line in lines {
        let line = line.replace("*/", "* /");
        let _ = writeln!(text, "{}", format!("{indent} * {line}").trim_end());
    }
    text + indent + " */\n"
}

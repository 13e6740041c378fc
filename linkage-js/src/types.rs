//! Types for TypeScript.

use std::fmt::Write;

use linkage_compiler::ir::{Function, plain};
use linkage_export::{Declarations, FunctionDeclaration};

/// The part that is the same for all mechanisms.
const COMMON: &str = include_str!("common.d.ts");

/// The text of the `.d.ts` file of a module.
pub(crate) fn types(declarations: &Declarations) -> String {
    let Declarations {
        title, name, unit, ..
    } = declarations;
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
    for function in &declarations.functions {
        text += &documented("  ", &about(function.function));
        let _ = writeln!(
            text,
            "  {}({}): {};",
            method(&function.items[0]),
            arguments(function),
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

fn arguments(function: &FunctionDeclaration) -> String {
    let arguments = function.arguments.iter();
    let arguments: Vec<&str> = arguments.map(|item| &item.declaration[..]).collect();
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

fn result(function: &FunctionDeclaration) -> String {
    let fields = function.fields.iter();
    let fields: Vec<&str> = fields.map(|field| &field.declaration[..]).collect();
    format!("{{ {} }}", fields.join("; "))
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

//! Types for TypeScript.

use std::fmt::Write;

use linkage_compiler::unit::{Function, Shape, Unit, plain};

/// What is the same for all mechanisms.
const COMMON: &str = include_str!("common.d.ts");

/// The text of the `.d.ts` file beside the module.
pub(crate) fn types(name: &str, unit: &Unit) -> String {
    let mut text =
        format!("// {name}. Written by linkage; not to be changed by hand.\n\n{COMMON}\n");
    let _ = writeln!(
        text,
        "/** Dimensions of {name} by name. */\nexport interface Dimensions {{"
    );
    for own in unit.scalars() {
        let _ = writeln!(
            text,
            "  /** {} */\n  {}: number;",
            measure(&own.unit),
            key(&own.name)
        );
    }
    let _ = writeln!(
        text,
        "}}\n\n/** Closed loops: results at any inputs. */\nexport interface Assembly {{"
    );
    for own in &unit.functions {
        text += &documented("  ", &about(own));
        let _ = writeln!(
            text,
            "  {}({}): {};",
            plain(&own.name),
            arguments(unit, own),
            result(own)
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

fn arguments(unit: &Unit, own: &Function) -> String {
    let names = own
        .arguments
        .iter()
        .map(|&place| match place.checked_sub(unit.inputs.len()) {
            None => plain(&unit.inputs[place].name),
            Some(place) => plain(&unit.arguments[place].name),
        });
    let arguments: Vec<String> = names
        .map(|name| format!("{}: number", identifier(name)))
        .collect();
    arguments.join(", ")
}

/// The function's doc comment, then what its results are.
fn about(own: &Function) -> String {
    let told = own.fields.iter().map(|field| {
        let name = plain(&field.name);
        match &field.told()[..] {
            "" => format!("- `{name}`: a number"),
            about => format!("- `{name}`: {about}"),
        }
    });
    let results = told.collect::<Vec<_>>().join("\n");
    match own.documentation.trim() {
        "" => results,
        documentation => format!("{documentation}\n\n{results}"),
    }
}

fn result(own: &Function) -> String {
    let fields = own.fields.iter();
    let fields: Vec<String> = fields
        .map(|field| format!("{}: {}", plain(&field.name), shape(&field.shape)))
        .collect();
    format!("{{ {} }}", fields.join("; "))
}

fn shape(own: &Shape) -> String {
    match own {
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

/// A name of an argument: words that JavaScript has itself get a `_` behind them.
fn identifier(name: &str) -> String {
    const WORDS: [&str; 48] = [
        "arguments",
        "await",
        "break",
        "case",
        "catch",
        "class",
        "const",
        "continue",
        "debugger",
        "default",
        "delete",
        "do",
        "else",
        "enum",
        "eval",
        "export",
        "extends",
        "false",
        "finally",
        "for",
        "function",
        "if",
        "implements",
        "import",
        "in",
        "instanceof",
        "interface",
        "let",
        "new",
        "null",
        "package",
        "private",
        "protected",
        "public",
        "return",
        "static",
        "super",
        "switch",
        "this",
        "throw",
        "true",
        "try",
        "typeof",
        "var",
        "void",
        "while",
        "with",
        "yield",
    ];
    let taken = if WORDS.contains(&name) { "_" } else { "" };
    format!("{name}{taken}")
}

/// A doc comment; what would end it is taken apart.
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

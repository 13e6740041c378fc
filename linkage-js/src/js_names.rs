//! JavaScript as a target language: names of mechanisms and arguments, and types of TypeScript.

use linkage_compiler::ir::{Shape, plain};
use linkage_export::{FunctionItem, Scope, Target};

/// Words that are no names of variables: reserved ones of modules, and those that TypeScript
/// refuses or reads otherwise.
const WORDS: &[&str] = &[
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
    "globalThis",
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
    "undefined",
    "var",
    "void",
    "while",
    "with",
    "yield",
];

/// Names of a module besides the mechanism: the error, and the class that the error extends in the
/// types.
const OF_MODULE: &[&str] = &["AssemblyError", "Error"];

/// JavaScript, with the types of TypeScript. A mechanism is an object whose methods are the
/// functions of the user, so that only names of mechanisms and arguments may be taken.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JavaScript;

impl Target for JavaScript {
    const LANGUAGE: &'static str = "JavaScript";

    const FUNCTION_ITEMS: &'static [FunctionItem] = &[FunctionItem {
        ending: "",
        kind: "the function",
    }];

    fn mechanism_name(&self, title: &str) -> String {
        plain(title).to_owned()
    }

    fn item_name(&self, _mechanism: &str, item: &str) -> String {
        item.to_owned()
    }

    fn spelled(&self, name: &str, _scope: Scope) -> String {
        plain(name).to_owned()
    }

    fn is_reserved(&self, name: &str, scope: Scope) -> bool {
        match scope {
            Scope::Mechanism => WORDS.contains(&name) || OF_MODULE.contains(&name),
            Scope::Function => WORDS.contains(&name),
            Scope::File | Scope::Members => false,
        }
    }

    fn declared(&self, name: &str, shape: &Shape, _items: &[String]) -> String {
        format!("{name}: {}", type_of(shape))
    }
}

/// Returns the type of a result.
fn type_of(shape: &Shape) -> String {
    match shape {
        Shape::Scalar => "number".to_owned(),
        Shape::Vector(count) => format!("[{}]", vec!["number"; *count].join(", ")),
        Shape::Array(_, entry) => format!("{}[]", type_of(entry)),
        Shape::Frame => "[Axis, Axis, Axis, Axis]".to_owned(),
        Shape::PlaneFrame => format!("[{}]", ["[number, number]"; 3].join(", ")),
    }
}

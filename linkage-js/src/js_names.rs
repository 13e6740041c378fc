//! Names of mechanisms and arguments in JavaScript and in the types.

use std::collections::BTreeSet;

use linkage_compiler::ir::plain;

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

/// The name by which a module exports a mechanism: its own, or that with an underscore behind it.
pub(crate) fn exported(title: &str) -> String {
    let name = plain(title);
    free(name, |name| {
        WORDS.contains(&name) || OF_MODULE.contains(&name)
    })
}

/// The names of a function's arguments in the types: each once.
pub(crate) fn arguments<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let mut one = |name: &str| {
        let chosen = free(name, |name| WORDS.contains(&name) || taken.contains(name));
        taken.insert(chosen.clone());
        chosen
    };
    names.map(&mut one).collect()
}

/// A name with as many underscores behind it as it needs.
fn free(name: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let mut name = name.to_owned();
    while is_taken(&name) {
        name.push('_');
    }
    name
}

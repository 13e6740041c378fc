//! The modules of a crate and their items, with names, ends and attributes.

use crate::lexer::{Lexed, Token};
use std::collections::{BTreeMap, BTreeSet};

// The modules of a crate: their items, imports, and the paths in their code.

/// The words of a path.
pub(crate) type Path<'t> = Vec<&'t str>;

/// A meaning of a name in a module.
#[derive(Debug)]
pub(crate) enum Entry<'t> {
    /// An item of the module's file.
    Item { is_trait: bool },
    /// A module below, by its index.
    Module(usize),
    /// An import.
    Import(Path<'t>),
}

/// An import, or all names of a module.
#[derive(Debug)]
pub(crate) struct Import<'t> {
    pub(crate) path: Path<'t>,
    /// The name that it gets; none for `_` and for all names of a module.
    pub(crate) name: Option<&'t str>,
    pub(crate) is_glob: bool,
    /// True for `pub use` and the like.
    pub(crate) is_public: bool,
    pub(crate) line: usize,
}

/// A path in code, or the name of a macro that is called.
#[derive(Debug)]
pub(crate) struct Mention<'t> {
    pub(crate) path: Path<'t>,
    pub(crate) line: usize,
}

/// A block of methods without a trait.
#[derive(Debug)]
pub(crate) struct Methods<'t> {
    pub(crate) of: Path<'t>,
    pub(crate) count: usize,
}

#[derive(Debug, Default)]
pub(crate) struct Module<'t> {
    /// The index of its file among the sources.
    pub(crate) file: usize,
    pub(crate) parent: Option<usize>,
    /// From the root: nothing for the root itself.
    pub(crate) path: Vec<&'t str>,
    pub(crate) names: BTreeMap<&'t str, Vec<Entry<'t>>>,
    pub(crate) imports: Vec<Import<'t>>,
    pub(crate) mentions: Vec<Mention<'t>>,
    pub(crate) methods: Vec<Methods<'t>>,
    /// All words of its code, without fields, methods and imports.
    pub(crate) words: BTreeSet<&'t str>,
    /// Macros that are called by a single word.
    pub(crate) calls: Vec<Mention<'t>>,
}

/// All modules of a crate; the root is the first.
#[derive(Debug, Default)]
pub(crate) struct Modules<'t> {
    pub(crate) modules: Vec<Module<'t>>,
    /// The files that define macros by `macro_rules!`.
    pub(crate) macros: BTreeMap<&'t str, BTreeSet<usize>>,
}

// Tokens of an item: its name, its end, its attributes.

/// Keywords before the name of an item.
pub(crate) const ITEMS: [&str; 8] = [
    "fn", "struct", "enum", "union", "trait", "type", "const", "static",
];

/// The name that an item defines, and the index after it.
pub(crate) fn defined<'t>(
    tokens: &'t [Token<'t>],
    start: usize,
    end: usize,
) -> Option<(&'t str, usize)> {
    const BEFORE: [&str; 7] = [
        "const", "unsafe", "async", "extern", "static", "auto", "safe",
    ];
    let mut index = start;
    while index + 1 < end {
        let token = &tokens[index];
        let next = &tokens[index + 1];
        if token.is("macro_rules") {
            return tokens.get(index + 2).map(|name| (name.text, index + 3));
        }
        let goes_on = next.is("mut") || next.is("unsafe") || next.is("fn") || next.is("extern");
        if ITEMS.contains(&token.text) && next.is_word() && !goes_on {
            return Some((next.text, index + 2));
        }
        if !(BEFORE.contains(&token.text) || token.is("mut") || token.text.starts_with('"')) {
            return None;
        }
        if token.is("static") && next.is("mut") {
            return tokens.get(index + 2).map(|name| (name.text, index + 3));
        }
        index += 1;
    }
    None
}

/// The index after an item that begins at an index.
pub(crate) fn end_of_item(lexed: &Lexed, start: usize, end: usize) -> usize {
    let tokens = &lexed.tokens;
    // Braces do not end a value or an import.
    let is_function = tokens[start..end.min(start + 4)]
        .iter()
        .any(|token| token.is("fn"));
    let has_value = ["const", "static", "use", "type"]
        .iter()
        .any(|word| tokens[start].is(word));
    let mut index = start;
    while index < end {
        let token = &tokens[index];
        if token.is(";") {
            return index + 1;
        }
        let close = lexed.partner(index);
        if token.is("{") && (is_function || !has_value) {
            return close + 1;
        }
        index = close + 1;
    }
    end
}

/// The index after the `>` that closes the `<` at an index.
pub(crate) fn end_of_angles(tokens: &[Token], start: usize, end: usize) -> usize {
    let mut depth = 0;
    for (index, token) in tokens.iter().enumerate().take(end).skip(start) {
        if token.is("<") {
            depth += 1;
        } else if token.is(">") {
            depth -= 1;
            if depth == 0 {
                return index + 1;
            }
        }
    }
    end
}

/// The number of functions between two tokens, outside brackets.
pub(crate) fn functions_in(lexed: &Lexed, start: usize, end: usize) -> usize {
    let mut count = 0;
    let mut index = start;
    while index < end {
        count += usize::from(lexed.tokens[index].is("fn"));
        index = lexed.partner(index) + 1;
    }
    count
}

/// True for the content of `#[cfg(test)]`, of `#[cfg(all(test, ...))]` and of `#[test]`.
pub(crate) fn is_for_tests(attribute: &[Token]) -> bool {
    let has = |word: &str| attribute.iter().any(|token| token.is(word));
    let is_first = |word: &str| attribute.first().is_some_and(|token| token.is(word));
    is_first("test") || is_first("cfg") && has("test") && !has("not")
}

//! The leaves of an import.

use crate::lexer::Lexed;
use crate::modules::{Import, Path};

/// Adds the leaves of a tree of imports behind a path.
pub(crate) fn leaves<'t>(
    lexed: &'t Lexed<'t>,
    mut index: usize,
    end: usize,
    start: &[&'t str],
    imports: &mut Vec<Import<'t>>,
) {
    let tokens = &lexed.tokens;
    let mut path = start.to_vec();
    let mut add = |path: &mut Path<'t>, name: Option<&'t str>, is_glob: bool, line: usize| {
        if path.len() > 1 && path.last() == Some(&"self") {
            path.pop();
        }
        let name = name.or(path.last().copied());
        imports.push(Import {
            path: path.clone(),
            name: name.filter(|name| *name != "_" && !is_glob),
            is_glob,
            is_public: false,
            line,
        });
    };
    let mut line = None;
    let mut groups = Vec::new();
    while index < end {
        let token = &tokens[index];
        match token.text {
            "," => {
                if let Some(line) = line.take() {
                    add(&mut path, None, false, line);
                }
                path = start.to_vec();
            }
            "*" => {
                add(&mut path, None, true, token.line);
                line = None;
            }
            "as" => {
                let name = tokens.get(index + 1).map(|token| token.text);
                add(&mut path, name, false, token.line);
                line = None;
                index += 1;
            }
            "{" => {
                let close = lexed.partner(index);
                groups.push((index + 1, close, path.clone()));
                line = None;
                index = close;
            }
            // From outside: a leaf that is no path of the crate.
            "::" if path.is_empty() => path.push("::"),
            _ if token.is_word() => {
                path.push(token.text);
                line = Some(token.line);
            }
            _ => {}
        }
        index += 1;
    }
    if let Some(line) = line {
        add(&mut path, None, false, line);
    }
    for (first, last, path) in groups {
        leaves(lexed, first, last, &path, imports);
    }
}

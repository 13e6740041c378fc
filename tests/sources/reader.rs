//! Modules from the tokens of a crate.
//!
//! Modules and items that only tests have are left out. So is the text in `quote!`, the code of users.

use std::collections::BTreeMap;

use crate::crates::Source;
use crate::lexer::Lexed;
use crate::modules::{Entry, Mention, Methods, Module, Modules};
use crate::modules::{ITEMS, defined, end_of_angles, end_of_item, functions_in, is_for_tests};
use crate::resolve::leaves;

/// Macros whose text is code of users.
const TOKENS_OF_USERS: [&str; 4] = [
    "quote",
    "quote_spanned",
    "parse_quote",
    "parse_quote_spanned",
];

/// Reads a crate from its root `lib.rs`, or `main.rs` without one.
pub(crate) fn modules_of<'t>(sources: &'t [Source<'t>], home: usize) -> Modules<'t> {
    let files: BTreeMap<&str, usize> = sources
        .iter()
        .enumerate()
        .filter(|(_, source)| source.home == home)
        .map(|(index, source)| (source.below(), index))
        .collect();
    let root = files.get("lib.rs").or(files.get("main.rs"));
    let mut reader = Reader {
        sources,
        files: &files,
        found: Modules::default(),
    };
    if let Some(file) = root {
        reader.file(*file, None, Vec::new());
    }
    reader.found
}

struct Reader<'t, 'f> {
    sources: &'t [Source<'t>],
    /// Indices by paths below `src`.
    files: &'f BTreeMap<&'t str, usize>,
    found: Modules<'t>,
}

impl<'t> Reader<'t, '_> {
    fn file(&mut self, file: usize, parent: Option<usize>, path: Vec<&'t str>) -> usize {
        let index = self.add(file, parent, path);
        let lexed = &self.sources[file].lexed;
        self.items(lexed, 0, lexed.tokens.len(), index);
        index
    }

    fn add(&mut self, file: usize, parent: Option<usize>, path: Vec<&'t str>) -> usize {
        self.found.modules.push(Module {
            file,
            parent,
            path,
            ..Module::default()
        });
        self.found.modules.len() - 1
    }

    fn define(&mut self, module: usize, name: &'t str, entry: Entry<'t>) {
        let names = &mut self.found.modules[module].names;
        names.entry(name).or_default().push(entry);
    }

    /// Reads the items of a module between two tokens.
    fn items(&mut self, lexed: &'t Lexed<'t>, mut index: usize, end: usize, module: usize) {
        let tokens = &lexed.tokens;
        let (mut for_tests, mut is_public, mut is_exported) = (false, false, false);
        while index < end {
            let token = &tokens[index];
            let next = tokens.get(index + 1);
            if token.is("#") {
                index += usize::from(next.is_some_and(|next| next.is("!")));
                let close = lexed.partner(index + 1);
                for_tests |= is_for_tests(&tokens[index + 2..close.max(index + 2)]);
                is_exported |= tokens[index + 2..close.max(index + 2)]
                    .iter()
                    .any(|token| token.is("macro_export"));
                index = close + 1;
                continue;
            }
            if token.is("pub") {
                is_public = true;
                let restricted = next.is_some_and(|next| next.is("("));
                index = if restricted {
                    lexed.partner(index + 1) + 1
                } else {
                    index + 1
                };
                continue;
            }
            let item_end = end_of_item(lexed, index, end);
            if !for_tests {
                match token.text {
                    "mod" => self.module(lexed, index, item_end, module),
                    "use" => self.import(lexed, index + 1, item_end, module, is_public),
                    "impl" => self.methods(lexed, index, item_end, module),
                    _ => self.item(lexed, index, item_end, module, is_exported),
                }
            }
            (for_tests, is_public, is_exported) = (false, false, false);
            index = item_end;
        }
    }

    fn module(&mut self, lexed: &'t Lexed<'t>, index: usize, end: usize, module: usize) {
        let name = lexed.tokens[index + 1].text;
        let (file, mut path) = {
            let parent = &self.found.modules[module];
            (parent.file, parent.path.clone())
        };
        path.push(name);
        let child = if lexed.tokens[index + 2].is("{") {
            let child = self.add(file, Some(module), path);
            self.items(lexed, index + 3, end - 1, child);
            child
        } else {
            let below = path.join("/");
            let names = [format!("{below}.rs"), format!("{below}/mod.rs")];
            let Some(file) = names.iter().find_map(|name| self.files.get(&name[..])) else {
                return;
            };
            self.file(*file, Some(module), path)
        };
        self.define(module, name, Entry::Module(child));
    }

    /// Reads an item that is neither a module nor an import, nor a block of methods.
    fn item(
        &mut self,
        lexed: &'t Lexed<'t>,
        index: usize,
        end: usize,
        module: usize,
        is_exported: bool,
    ) {
        let tokens = &lexed.tokens;
        let mut start = index;
        if let Some((name, after)) = defined(tokens, index, end) {
            start = after;
            let is_trait = tokens[after - 2].is("trait");
            self.define(module, name, Entry::Item { is_trait });
            if tokens[index].is("macro_rules") {
                let file = self.found.modules[module].file;
                self.found.macros.entry(name).or_default().insert(file);
                if is_exported && module != 0 {
                    let path = self.found.modules[module].path.clone();
                    let path = [&["crate"], &path[..], &[name]].concat();
                    self.define(0, name, Entry::Import(path));
                }
            }
        }
        if tokens.get(index + 1).is_some_and(|token| token.is("!")) && start == index {
            self.items_of_macro(lexed, index + 2, module);
        }
        self.code(lexed, start, end, module);
    }

    /// Adds the items that are written in the brackets of a macro.
    fn items_of_macro(&mut self, lexed: &'t Lexed<'t>, open: usize, module: usize) {
        let tokens = &lexed.tokens;
        let (mut index, end) = (open + 1, lexed.partner(open));
        while index + 1 < end {
            let is_item = ITEMS.contains(&tokens[index].text) && tokens[index + 1].is_word();
            if is_item {
                let is_trait = tokens[index].is("trait");
                self.define(module, tokens[index + 1].text, Entry::Item { is_trait });
            }
            index = lexed.partner(index) + 1;
        }
    }

    fn methods(&mut self, lexed: &'t Lexed<'t>, index: usize, end: usize, module: usize) {
        let tokens = &lexed.tokens;
        self.code(lexed, index + 1, end, module);
        let mut at = index + 1;
        if tokens.get(at).is_some_and(|token| token.is("<")) {
            at = end_of_angles(tokens, at, end);
        }
        let mut of = Vec::new();
        while at < end && tokens[at].is_word() {
            of.push(tokens[at].text);
            if at + 1 < end && tokens[at + 1].is("::") {
                at += 2;
            } else {
                at += 1;
                break;
            }
        }
        if at < end && tokens[at].is("<") {
            at = end_of_angles(tokens, at, end);
        }
        // A trait, a reference, a parameter of a macro: no methods of a type.
        if of.is_empty() || at >= end || !(tokens[at].is("{") || tokens[at].is("where")) {
            return;
        }
        let body = (at..end).find(|index| tokens[*index].is("{"));
        let count = body.map_or(0, |body| functions_in(lexed, body + 1, end - 1));
        let methods = Methods { of, count };
        self.found.modules[module].methods.push(methods);
    }

    /// Reads code: words, paths, and imports in bodies.
    fn code(&mut self, lexed: &'t Lexed<'t>, mut index: usize, end: usize, module: usize) {
        let tokens = &lexed.tokens;
        while index < end {
            let token = &tokens[index];
            if !token.is_word() {
                index += 1;
                continue;
            }
            let follows = |text: &str, at: usize| at < end && tokens[at].is(text);
            let before = index.checked_sub(1).map(|before| &tokens[before]);
            if before.is_some_and(|before| before.is(".") || before.is("::")) {
                index += 1;
                continue;
            }
            if token.is("use") && !follows("<", index + 1) {
                let close = (index..end).find(|index| tokens[*index].is(";"));
                let close = close.unwrap_or(end);
                self.import(lexed, index + 1, close, module, false);
                index = close;
                continue;
            }
            let is_call = follows("!", index + 1) && !follows("=", index + 2);
            if is_call && TOKENS_OF_USERS.contains(&token.text) && index + 2 < end {
                index = lexed.partner(index + 2) + 1;
                continue;
            }
            let line = token.line;
            let mut path = vec![token.text];
            index += 1;
            while follows("::", index) && index + 1 < end && tokens[index + 1].is_word() {
                path.push(tokens[index + 1].text);
                index += 2;
            }
            let found = &mut self.found.modules[module];
            found.words.insert(path[0]);
            if path.len() > 1 {
                found.mentions.push(Mention { path, line });
            } else if is_call {
                found.calls.push(Mention { path, line });
            }
        }
    }

    fn import(
        &mut self,
        lexed: &'t Lexed<'t>,
        index: usize,
        end: usize,
        module: usize,
        is_public: bool,
    ) {
        let mut imports = Vec::new();
        leaves(lexed, index, end, &[], &mut imports);
        for mut import in imports {
            import.is_public = is_public;
            if let Some(name) = import.name {
                self.define(module, name, Entry::Import(import.path.clone()));
            }
            self.found.modules[module].imports.push(import);
        }
    }
}

//! Which module of the compiler uses which: no circle among the phases, and no formula knows of programs or printing.
//!
//! Read from the tokens of all sources but tests: `use` lines and paths written in code, from the crate's root (`crate::`) or
//! upwards (`super::`).

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fs;
use std::path::Path;

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};

/// The root: the order of phases, and what hands their results to others. Phases do not use it.
const ROOT: &str = "lib";
const PARTS_OF_THE_ROOT: [&str; 3] = ["lib", "oracle", "trace"];

#[test]
fn no_module_uses_itself_through_others() {
    let uses = Uses::of_the_compiler();
    let circle = uses.circle();
    assert!(circle.is_none(), "{}", uses.in_words(&circle.unwrap()));
}

#[test]
fn formulas_know_neither_programs_nor_printing() {
    let uses = Uses::of_the_compiler();
    for other in ["lower", "emit"] {
        let way = uses.way("formulate", other);
        assert!(way.is_none(), "{}", uses.in_words(&way.unwrap()));
    }
}

#[test]
fn all_modules_are_read() {
    let uses = Uses::of_the_compiler();
    for module in ["syntax", "model", "algebra", "structure", "formulate"] {
        let way = uses.way("emit", module).or(uses.way("request", module));
        assert!(way.is_some(), "`{module}` is used by nobody");
    }
}

#[test]
fn a_circle_is_found_and_told() {
    let sources = [
        ("ir/mod.rs", "use crate::model::Shape;"),
        ("model/mod.rs", "mod types;"),
        (
            "model/types.rs",
            "fn f() { super::super::algebra::g(crate::ROOT) }",
        ),
        (
            "algebra.rs",
            "#[cfg(test)] mod tests; use {crate::{unit::{self, Unit}, algebra}, std::fmt};",
        ),
        ("algebra/tests.rs", "use crate::emit;"),
        ("lib.rs", "mod unit; use unit::Unit; static ROOT: Unit;"),
        (
            "emit.rs",
            "use crate::unit; #[cfg(test)] mod tests { use crate::emit; }",
        ),
    ];
    let uses = Uses::of(&sources.map(|(path, text)| (path.to_owned(), text.to_owned())));
    let found: Vec<(&str, &str)> = uses.pairs().collect();
    let expected = [
        ("algebra", "unit"),
        ("emit", "unit"),
        ("lib", "unit"),
        ("model", "algebra"),
        ("model", "lib"),
        ("unit", "model"),
    ];
    assert_eq!(found, expected);
    assert_eq!(
        uses.in_words(&uses.circle().expect("there is one")),
        "`algebra` uses `unit` (algebra.rs: crate::unit), `unit` uses `model` (ir/mod.rs: crate::model::Shape), \
         `model` uses `algebra` (model/types.rs: super::super::algebra::g)"
    );
}

/// Which module of the crate's root uses which, and where that is said.
#[derive(Default)]
struct Uses {
    places: BTreeMap<(String, String), String>,
}

impl Uses {
    fn of_the_compiler() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut sources = Vec::new();
        read_all(&root, "", &mut sources);
        Self::of(&sources)
    }

    /// Of paths below `src` and texts.
    fn of(sources: &[(String, String)]) -> Self {
        let files: Vec<File> = sources
            .iter()
            .map(|own| File::new(&own.0, &own.1))
            .collect();
        let tests: BTreeSet<&Vec<String>> = files.iter().flat_map(|file| &file.tests).collect();
        let modules: BTreeSet<&str> = files.iter().filter_map(File::top).collect();
        let mut uses = Self::default();
        for file in &files {
            if tests.iter().any(|test| file.module.starts_with(test)) {
                continue;
            }
            let own = node(file.top());
            for (target, written) in &file.through_the_root {
                // What is no module is an item of the root itself.
                let target = node(modules.get(&target[..]).copied());
                if target != own {
                    let place = format!("{}: {written}", file.path);
                    let pair = (own.to_owned(), target.to_owned());
                    uses.places.entry(pair).or_insert(place);
                }
            }
        }
        uses
    }

    fn pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        self.places.keys().map(|(from, to)| (&from[..], &to[..]))
    }

    /// The shortest way from a module back to itself.
    fn circle(&self) -> Option<Vec<&str>> {
        let starts = self.pairs().map(|(from, _)| from);
        let circles = starts.filter_map(|start| self.way(start, start));
        circles.min_by_key(Vec::len)
    }

    /// The shortest way from a module to another along what they use, both ends included.
    fn way<'u>(&'u self, from: &'u str, to: &str) -> Option<Vec<&'u str>> {
        let mut ways = VecDeque::from([vec![from]]);
        let mut seen = BTreeSet::new();
        while let Some(way) = ways.pop_front() {
            let end = way[way.len() - 1];
            for (_, next) in self.pairs().filter(|(from, _)| *from == end) {
                let longer = [&way[..], &[next]].concat();
                if next == to {
                    return Some(longer);
                }
                if seen.insert(next) {
                    ways.push_back(longer);
                }
            }
        }
        None
    }

    fn in_words(&self, way: &[&str]) -> String {
        let steps = way.windows(2).map(|step| {
            let place = &self.places[&(step[0].to_owned(), step[1].to_owned())];
            format!("`{}` uses `{}` ({place})", step[0], step[1])
        });
        steps.collect::<Vec<_>>().join(", ")
    }
}

fn node(module: Option<&str>) -> &str {
    module
        .filter(|module| !PARTS_OF_THE_ROOT.contains(module))
        .unwrap_or(ROOT)
}

/// What one file says.
struct File {
    path: String,
    /// Where it stands, from the root: `syntax`, `literal`; nothing for `lib.rs`.
    module: Vec<String>,
    /// Modules that only tests have, from the root.
    tests: Vec<Vec<String>>,
    /// Paths that lead through the root: from there, and as they are written.
    through_the_root: Vec<(String, String)>,
}

impl File {
    fn new(path: &str, text: &str) -> Self {
        let below = path.trim_end_matches(".rs").trim_end_matches("/mod");
        let parts = below.split('/').filter(|part| *part != ROOT);
        let module: Vec<String> = parts.map(str::to_owned).collect();
        let tokens: TokenStream = text
            .parse()
            .unwrap_or_else(|error| panic!("{path}: {error}"));
        let mut file = Self {
            path: path.to_owned(),
            module: module.clone(),
            tests: Vec::new(),
            through_the_root: Vec::new(),
        };
        file.read(tokens, &module, &[]);
        file
    }

    /// The module of the root in which it stands.
    fn top(&self) -> Option<&str> {
        self.module.first().map(String::as_str)
    }

    /// Reads what stands in a module, or in braces behind a path, as in `crate::{...}`.
    fn read(&mut self, tokens: TokenStream, module: &[String], start: &[String]) {
        let mut tokens = tokens.into_iter().peekable();
        let mut path = start.to_vec();
        let mut after_colons = false;
        let mut module_named = None;
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Group(group) if is_for_tests(&group) => {
                    self.skip_item(&mut tokens, module);
                }
                TokenTree::Group(group) => {
                    self.note(&path, module);
                    let continued = after_colons && group.delimiter() == Delimiter::Brace;
                    let start = if continued { &path[..] } else { &[] };
                    let module = [module, module_named.take().as_slice()].concat();
                    self.read(group.stream(), &module, start);
                    path.clear();
                }
                TokenTree::Punct(sign) if sign.as_char() == ':' && is_joint(&sign) => {
                    tokens.next();
                    after_colons = true;
                    continue;
                }
                TokenTree::Ident(word) if after_colons => path.push(word.to_string()),
                TokenTree::Punct(sign) if after_colons && sign.as_char() == '*' => {
                    path.push("*".to_owned());
                }
                other => {
                    self.note(&path, module);
                    let is_module = path == ["mod"];
                    path = start.to_vec();
                    if let TokenTree::Ident(word) = other {
                        module_named = is_module.then(|| word.to_string());
                        path.push(word.to_string());
                    }
                }
            }
            after_colons = false;
        }
        self.note(&path, module);
    }

    /// Past an item that only tests have.
    fn skip_item(&mut self, tokens: &mut impl Iterator<Item = TokenTree>, module: &[String]) {
        let mut words = Vec::new();
        for token in tokens {
            match token {
                TokenTree::Ident(word) => words.push(word.to_string()),
                TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => return,
                TokenTree::Punct(sign) if sign.as_char() == ';' => break,
                _ => {}
            }
        }
        if let [.., key, name] = &words[..]
            && key == "mod"
        {
            self.tests
                .push([module, std::slice::from_ref(name)].concat());
        }
    }

    fn note(&mut self, path: &[String], module: &[String]) {
        let from_root = match path.first().map(String::as_str) {
            Some("crate") => path[1..].to_vec(),
            Some("super") => {
                let ups = path.iter().take_while(|part| *part == "super").count();
                [&module[..module.len() - ups], &path[ups..]].concat()
            }
            // In the root, all paths begin there.
            _ if module.is_empty() => path.to_vec(),
            _ => return,
        };
        // A single word is a name of some other kind, as in `pub(crate)`.
        if let ([first, ..], [_, _, ..]) = (&from_root[..], path) {
            let written = (first.clone(), path.join("::"));
            self.through_the_root.push(written);
        }
    }
}

fn is_joint(sign: &Punct) -> bool {
    sign.spacing() == Spacing::Joint
}

/// Whether this is the bracket of `#[cfg(test)]`.
fn is_for_tests(group: &Group) -> bool {
    let text = group.stream().to_string().replace(' ', "");
    group.delimiter() == Delimiter::Bracket && text == "cfg(test)"
}

/// All sources below a folder: paths from `src`, and texts.
fn read_all(folder: &Path, below: &str, sources: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy();
        if path.is_dir() {
            read_all(&path, &format!("{below}{name}/"), sources);
        } else if name.ends_with(".rs") {
            let text = fs::read_to_string(&path).expect("a file that can be read");
            sources.push((format!("{below}{name}"), text));
        }
    }
    sources.sort();
}

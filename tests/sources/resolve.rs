//! The files that define what paths lead to, through imports and re-exports.

use crate::lexer::Lexed;
use crate::modules::{Entry, Import, Modules, Path};
use std::collections::BTreeSet;

/// The end of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Target<'t> {
    Module(usize),
    /// An item by its file and its name there.
    Item {
        file: usize,
        name: &'t str,
        is_trait: bool,
    },
}

/// Names that are being resolved: a name that leads to itself has no target.
type Visited<'t> = BTreeSet<(usize, &'t str)>;

impl<'t> Modules<'t> {
    /// The targets of a path that is used in a module; none outside the crate.
    pub(crate) fn resolve(&self, module: usize, path: &Path<'t>) -> BTreeSet<Target<'t>> {
        self.path(module, path, &mut Visited::new())
    }

    /// The targets of a name in a module.
    pub(crate) fn resolve_name(&self, module: usize, name: &'t str) -> BTreeSet<Target<'t>> {
        self.name(module, name, &mut Visited::new())
    }

    fn path(
        &self,
        module: usize,
        path: &[&'t str],
        visited: &mut Visited<'t>,
    ) -> BTreeSet<Target<'t>> {
        let mut rest = path;
        let mut start = module;
        let mut is_rooted = false;
        while let [first, others @ ..] = rest {
            match *first {
                "crate" => start = 0,
                "self" => {}
                "super" => start = self.modules[start].parent.unwrap_or(0),
                _ => break,
            }
            (rest, is_rooted) = (others, true);
        }
        let mut targets = BTreeSet::from([Target::Module(start)]);
        for (index, name) in rest.iter().enumerate() {
            let mut next = BTreeSet::new();
            for target in targets {
                match target {
                    // A variant, or an associated item.
                    Target::Item { .. } => drop(next.insert(target)),
                    Target::Module(module) => {
                        let found = self.name(module, name, visited);
                        let is_import = self.modules[module].names.contains_key(name);
                        // A macro wrote the item, unless it is imported from another crate.
                        if found.is_empty() && !is_import && (is_rooted || index > 0) {
                            next.insert(Target::Item {
                                file: self.modules[module].file,
                                name,
                                is_trait: false,
                            });
                        }
                        next.extend(found);
                    }
                }
            }
            targets = next;
        }
        targets
    }

    fn name(
        &self,
        module: usize,
        name: &'t str,
        visited: &mut Visited<'t>,
    ) -> BTreeSet<Target<'t>> {
        let mut targets = BTreeSet::new();
        if !visited.insert((module, name)) {
            return targets;
        }
        let found = &self.modules[module];
        for entry in found.names.get(name).into_iter().flatten() {
            match entry {
                Entry::Item { is_trait } => {
                    targets.insert(Target::Item {
                        file: found.file,
                        name,
                        is_trait: *is_trait,
                    });
                }
                Entry::Module(child) => drop(targets.insert(Target::Module(*child))),
                Entry::Import(path) => targets.extend(self.path(module, path, visited)),
            }
        }
        if targets.is_empty() {
            for import in found.imports.iter().filter(|import| import.is_glob) {
                for target in self.path(module, &import.path, visited) {
                    if let Target::Module(from) = target {
                        targets.extend(self.name(from, name, visited));
                    }
                }
            }
        }
        visited.remove(&(module, name));
        targets
    }
}

// The leaves of an import.

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

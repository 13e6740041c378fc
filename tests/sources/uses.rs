//! The files that a file uses, and the place where it does.

use std::collections::BTreeMap;

use crate::crates::Source;
use crate::graph::Graph;
use crate::modules::{Entry, Import, Modules};
use crate::resolve::Target;

/// The first place where a file uses another.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) line: usize,
    /// The path as it is written.
    pub(crate) written: String,
}

/// Uses between the files of a crate, by their indices among the sources.
#[derive(Debug, Default)]
pub(crate) struct Uses {
    pub(crate) arrows: BTreeMap<(usize, usize), Place>,
    /// Imports from the root of names that it only re-exports.
    pub(crate) through_the_face: Vec<(usize, Place)>,
    /// The same for names that the root re-exports from another crate.
    pub(crate) of_other_crates: Vec<(usize, Place)>,
}

impl Uses {
    pub(crate) fn between(modules: &Modules) -> Self {
        let mut uses = Self::default();
        for index in 0..modules.modules.len() {
            uses.add_module(modules, index);
        }
        uses
    }

    pub(crate) fn graph(&self) -> Graph<usize> {
        Graph::new(self.arrows.keys().copied())
    }

    fn add_module(&mut self, modules: &Modules, index: usize) {
        let module = &modules.modules[index];
        for import in &module.imports {
            self.add_import(modules, index, import);
        }
        for mention in &module.mentions {
            self.add_path(modules, index, &mention.path, mention.line);
        }
        for call in &module.calls {
            let name = call.path[0];
            let files = modules.macros.get(name).into_iter().flatten();
            let files: Vec<usize> = files.copied().collect();
            let is_known = module.names.contains_key(name) || files.contains(&module.file);
            // Macros are visible below their definition without an import.
            if let ([file], false) = (&files[..], is_known) {
                self.add(module.file, *file, call.line, format!("{name}!"));
            }
        }
    }

    fn add_import(&mut self, modules: &Modules, index: usize, import: &Import) {
        let module = &modules.modules[index];
        let written = import.path.join("::");
        let targets = modules.resolve(index, &import.path);
        if import.is_glob {
            if !import.is_public {
                self.add_glob(modules, index, import);
            }
            return;
        }
        let is_mentioned = import.name.is_some_and(|name| module.words.contains(name));
        for target in targets {
            // Methods of a trait need its import, whose name is nowhere else.
            if let Target::Item { file, is_trait, .. } = target
                && (is_mentioned || is_trait && !import.is_public)
            {
                self.add(module.file, file, import.line, written.clone());
            }
        }
        self.add_face(modules, index, &import.path, import.line);
    }

    /// Adds the names of a module that are imported together, as far as they occur.
    fn add_glob(&mut self, modules: &Modules, index: usize, import: &Import) {
        let module = &modules.modules[index];
        let written = format!("{}::*", import.path.join("::"));
        for target in modules.resolve(index, &import.path) {
            match target {
                Target::Item { file, .. } => {
                    self.add(module.file, file, import.line, written.clone());
                }
                Target::Module(from) => {
                    let mut is_used = false;
                    for name in &module.words {
                        for target in modules.resolve_name(from, name) {
                            if let Target::Item { file, .. } = target {
                                is_used = true;
                                self.add(module.file, file, import.line, written.clone());
                            }
                        }
                    }
                    if !is_used {
                        let file = modules.modules[from].file;
                        self.add(module.file, file, import.line, written.clone());
                    }
                }
            }
        }
    }

    fn add_path<'t>(
        &mut self,
        modules: &Modules<'t>,
        index: usize,
        path: &Vec<&'t str>,
        line: usize,
    ) {
        let from = modules.modules[index].file;
        for target in modules.resolve(index, path) {
            if let Target::Item { file, .. } = target {
                self.add(from, file, line, path.join("::"));
            }
        }
        self.add_face(modules, index, path, line);
    }

    fn add_face(&mut self, modules: &Modules, index: usize, path: &[&str], line: usize) {
        let (from, root) = (&modules.modules[index], &modules.modules[0]);
        let ["crate", name, ..] = path else { return };
        let Some(entries) = root.names.get(name) else {
            return;
        };
        let is_import = |entry: &Entry| matches!(entry, Entry::Import(_));
        if from.file == root.file || !entries.iter().all(is_import) {
            return;
        }
        let place = Place {
            line,
            written: path.join("::"),
        };
        let found = (from.file, place);
        if modules.resolve_name(0, name).is_empty() {
            self.of_other_crates.push(found);
        } else {
            self.through_the_face.push(found);
        }
    }

    fn add(&mut self, from: usize, to: usize, line: usize, written: String) {
        if from != to {
            let place = Place { line, written };
            self.arrows.entry((from, to)).or_insert(place);
        }
    }

    /// The steps of a circle, one in a line.
    pub(crate) fn described(&self, sources: &[Source], circle: &[usize]) -> String {
        let steps = circle.iter().zip(circle.iter().cycle().skip(1));
        let steps = steps.map(|(from, to)| {
            let Place { line, written } = &self.arrows[&(*from, *to)];
            let (from, to) = (sources[*from].path, sources[*to].path);
            format!("    {from}:{line} uses {to} by `{written}`")
        });
        steps.collect::<Vec<_>>().join("\n")
    }
}

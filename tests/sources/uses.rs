//! The files that a file uses, and circles in a graph of uses.

use crate::crates::Source;
use crate::modules::{Entry, Import, Modules};
use crate::resolve::Target;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt::Debug;

// The files that a file uses, and the place where it does.

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

// Circles in a graph of uses.

#[derive(Debug)]
pub(crate) struct Graph<N> {
    next: BTreeMap<N, BTreeSet<N>>,
}

impl<N: Copy + Ord + Debug> Graph<N> {
    pub(crate) fn new(arrows: impl Iterator<Item = (N, N)>) -> Self {
        let mut next: BTreeMap<N, BTreeSet<N>> = BTreeMap::new();
        for (from, to) in arrows {
            next.entry(to).or_default();
            next.entry(from).or_default().insert(to);
        }
        Self { next }
    }

    /// Sets of nodes that reach each other, larger than one, the largest first.
    pub(crate) fn circles(&self) -> Vec<BTreeSet<N>> {
        let mut left = BTreeSet::new();
        let mut order = Vec::new();
        for node in self.next.keys() {
            self.visit(*node, &mut left, &mut order);
        }
        let mut back: BTreeMap<N, Vec<N>> = BTreeMap::new();
        for (from, nexts) in &self.next {
            for to in nexts {
                back.entry(*to).or_default().push(*from);
            }
        }
        let mut circles = Vec::new();
        for node in order.into_iter().rev() {
            let mut circle = BTreeSet::new();
            let mut open = vec![node];
            while let Some(node) = open.pop() {
                if left.remove(&node) {
                    circle.insert(node);
                    open.extend(back.get(&node).into_iter().flatten());
                }
            }
            if circle.len() > 1 {
                circles.push(circle);
            }
        }
        circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
        circles
    }

    /// Adds all nodes that can be reached, the last ones first.
    fn visit(&self, node: N, seen: &mut BTreeSet<N>, order: &mut Vec<N>) {
        if seen.insert(node) {
            for next in &self.next[&node] {
                self.visit(*next, seen, order);
            }
            order.push(node);
        }
    }

    /// The shortest way round within a set that `circles` gave.
    pub(crate) fn shortest(&self, circle: &BTreeSet<N>) -> Vec<N> {
        let rounds = circle.iter().filter_map(|node| self.way(*node, *node));
        rounds.min_by_key(Vec::len).unwrap_or_default()
    }

    /// The shortest way from a node to another along at least one arrow, without its end.
    pub(crate) fn way(&self, from: N, to: N) -> Option<Vec<N>> {
        let mut before: BTreeMap<N, N> = BTreeMap::new();
        let mut open = VecDeque::from([from]);
        while let Some(node) = open.pop_front() {
            for next in self.next.get(&node).into_iter().flatten() {
                if *next == to {
                    let mut way = vec![node];
                    while way[way.len() - 1] != from {
                        way.push(before[&way[way.len() - 1]]);
                    }
                    way.reverse();
                    return Some(way);
                }
                if *next != from && !before.contains_key(next) {
                    before.insert(*next, node);
                    open.push_back(*next);
                }
            }
        }
        None
    }
}

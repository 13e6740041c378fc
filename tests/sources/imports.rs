//! Uses of files and of modules of the root: no circles, and no formula uses programs or printing.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::sync::OnceLock;

use crate::crates::{CRATES, Source, is_reported, sources};
use crate::reader::modules_of;
use crate::uses::Graph;
use crate::uses::Uses;

mod tests;

/// The root of a crate as a module.
const ROOT: &str = "lib";
/// Modules of the compiler that belong to its root.
const PARTS_OF_THE_ROOT: [&str; 2] = ["oracle", "trace"];

/// The phase that writes formulas, and later ones.
const FORMULAS: &str = "solve";
const LATER: [&str; 1] = ["lower"];

/// Everything that the tests ask about a crate.
struct Checked<'t> {
    sources: &'t [Source<'t>],
    name: &'static str,
    uses: Uses,
}

impl<'t> Checked<'t> {
    fn new(sources: &'t [Source<'t>], home: usize) -> Self {
        Self {
            sources,
            name: CRATES[home],
            uses: Uses::between(&modules_of(sources, home)),
        }
    }

    /// The module of the root that has a file.
    fn top(&self, file: usize) -> &'t str {
        let below = self.sources[file].path.split_once("src/");
        let below = below.map_or("", |parts| parts.1);
        let top = below.split('/').next().unwrap_or_default();
        let top = top.trim_end_matches(".rs");
        if PARTS_OF_THE_ROOT.contains(&top) {
            ROOT
        } else {
            top
        }
    }

    /// Modules of the root that use each other, and a pair of files for each use.
    fn tops(&self) -> BTreeMap<(&'t str, &'t str), (usize, usize)> {
        let mut tops = BTreeMap::new();
        for (from, to) in self.uses.arrows.keys() {
            let pair = (self.top(*from), self.top(*to));
            if pair.0 != pair.1 {
                tops.entry(pair).or_insert((*from, *to));
            }
        }
        tops
    }

    fn described_tops(&self, way: &[&str]) -> String {
        let tops = self.tops();
        let steps = way.iter().zip(way.iter().cycle().skip(1));
        let steps = steps.filter_map(|step| {
            let (from, to) = tops.get(&(*step.0, *step.1))?;
            let place = &self.uses.arrows[&(*from, *to)];
            let path = self.sources[*from].path;
            let (line, written) = (place.line, &place.written);
            Some(format!(
                "    `{}` uses `{}`: {path}:{line} `{written}`",
                step.0, step.1
            ))
        });
        steps.collect::<Vec<_>>().join("\n")
    }

    fn circles(&self) -> Vec<BTreeSet<usize>> {
        self.uses.graph().circles()
    }

    /// Circles of files, each with its shortest way round.
    fn circles_of_files(&self, is_wanted: impl Fn(&str) -> bool) -> String {
        let graph = self.uses.graph();
        let mut text = String::new();
        for circle in graph.circles() {
            let mut paths = circle.iter().map(|file| self.sources[*file].path);
            if !paths.clone().any(&is_wanted) {
                continue;
            }
            let shortest = graph.shortest(&circle);
            let listed = paths.by_ref().collect::<Vec<_>>().join(" ");
            let steps = self.uses.described(self.sources, &shortest);
            let count = circle.len();
            let _ = writeln!(
                text,
                "  {}: {count} files use each other: {listed}\n   the shortest circle:\n{steps}",
                self.name
            );
        }
        text
    }

    fn circles_of_modules(&self) -> (usize, String) {
        let graph = Graph::new(self.tops().into_keys());
        let mut text = String::new();
        let mut count = 0;
        for circle in graph.circles() {
            count += circle.len();
            let _ = writeln!(
                text,
                "  {}: modules use each other: {circle:?}\n   the shortest circle:\n{}",
                self.name,
                self.described_tops(&graph.shortest(&circle))
            );
        }
        (count, text)
    }

    fn faces(&self, is_wanted: impl Fn(&str) -> bool) -> String {
        let mut text = String::new();
        for (file, place) in &self.uses.through_the_face {
            let path = self.sources[*file].path;
            if is_wanted(path) {
                let (line, written) = (place.line, &place.written);
                let _ = writeln!(
                    text,
                    "  {path}:{line} `{written}` is re-exported by the root"
                );
            }
        }
        text
    }
}

/// All crates, in the order of `CRATES`.
fn all() -> &'static [Checked<'static>] {
    static ALL: OnceLock<Vec<Checked>> = OnceLock::new();
    ALL.get_or_init(|| {
        let homes = 0..CRATES.len();
        homes.map(|home| Checked::new(sources(), home)).collect()
    })
}

#[test]
fn files_have_no_circles() {
    let mut failures = String::new();
    for checked in all() {
        let count: usize = checked.circles().iter().map(BTreeSet::len).sum();
        if count > 0 {
            let circles = checked.circles_of_files(|_| true);
            let _ = writeln!(
                failures,
                "{}: {count} files in circles\n{circles}",
                checked.name
            );
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

#[test]
fn modules_of_the_root_have_no_circles() {
    let mut failures = String::new();
    for checked in all() {
        let (count, circles) = checked.circles_of_modules();
        if count > 0 {
            let _ = writeln!(
                failures,
                "{}: {count} modules in circles\n{circles}",
                checked.name
            );
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

#[test]
fn items_are_imported_from_their_modules() {
    let mut failures = String::new();
    for checked in all() {
        let count = checked.uses.through_the_face.len();
        if count > 0 {
            let _ = writeln!(
                failures,
                "{}: {count} uses of re-exports of the root\n{}",
                checked.name,
                checked.faces(|_| true)
            );
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

fn compiler() -> &'static Checked<'static> {
    let mut all = all().iter();
    let found = all.find(|checked| checked.name == "linkage-compiler");
    found.expect("the compiler is a crate")
}

#[test]
fn formulas_use_neither_programs_nor_printing() {
    let checked = compiler();
    let tops = checked.tops();
    let graph = Graph::new(tops.keys().copied());
    let has = |name: &str| tops.keys().any(|pair| pair.0 == name);
    assert!(has(FORMULAS), "the compiler has no module `{FORMULAS}`");
    for later in LATER {
        assert!(has(later), "the compiler has no module `{later}`");
        if let Some(way) = graph.way(FORMULAS, later) {
            let way = [&way[..], &[later]].concat();
            panic!("\n{}", checked.described_tops(&way));
        }
    }
}

#[test]
fn all_modules_of_the_compiler_are_read() {
    let checked = compiler();
    let files: BTreeSet<usize> = checked.uses.arrows.keys().map(|arrow| arrow.0).collect();
    let is_wanted = |source: &&Source| CRATES[source.home] == checked.name && !source.is_test();
    let all = sources().iter().filter(is_wanted).count();
    // Some files use nothing of the crate.
    assert!(files.len() * 10 > all * 8, "{} of {all}", files.len());
}

pub(crate) fn report() -> String {
    let mut text = String::new();
    for checked in all() {
        let circles = checked.circles();
        let count: usize = circles.iter().map(BTreeSet::len).sum();
        let (modules, between) = checked.circles_of_modules();
        let faces = checked.uses.through_the_face.len();
        let _ = writeln!(
            text,
            "{}: {} circles with {count} files; {modules} modules of the root in circles; \
             {faces} uses of re-exports of the root, {} of its re-exports of other crates",
            checked.name,
            circles.len(),
            checked.uses.of_other_crates.len()
        );
        if is_reported(checked.name) {
            text += &between;
        }
        text += &checked.circles_of_files(is_reported);
        text += &checked.faces(is_reported);
    }
    text
}

//! Types with methods in several files: a type is one module, and not a folder of methods.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::crates::{CRATES, Source, from_texts, is_reported, sources};
use crate::reader::modules_of;
use crate::resolve::Target;

const MOST_FILES: usize = 3;

/// A recursive descent parser has its methods in one file for each part of the grammar.
const EXCEPTED: [&str; 1] = ["Parser"];

/// A type with the files of its methods.
struct Type<'t> {
    name: &'t str,
    /// The file that defines it.
    file: usize,
    /// The number of methods in each file.
    methods: BTreeMap<usize, usize>,
}

impl Type<'_> {
    fn described(&self, sources: &[Source]) -> String {
        let count: usize = self.methods.values().sum();
        let (name, path) = (self.name, sources[self.file].path);
        let mut text = format!(
            "  `{name}` of {path}: {count} methods in {} files:",
            self.methods.len()
        );
        for (file, count) in &self.methods {
            let _ = write!(text, " {} {count},", sources[*file].path);
        }
        text.trim_end_matches(',').to_owned()
    }
}

/// Types of a crate with methods in more files than allowed, the largest first.
fn spread<'t>(sources: &'t [Source<'t>], home: usize) -> Vec<Type<'t>> {
    let modules = modules_of(sources, home);
    let mut types: BTreeMap<(usize, &str), Type> = BTreeMap::new();
    for (index, module) in modules.modules.iter().enumerate() {
        for methods in &module.methods {
            for target in modules.resolve(index, &methods.of) {
                if let Target::Item { file, name, .. } = target {
                    let found = types.entry((file, name)).or_insert_with(|| Type {
                        name,
                        file,
                        methods: BTreeMap::new(),
                    });
                    *found.methods.entry(module.file).or_default() += methods.count;
                }
            }
        }
    }
    let mut types: Vec<Type> = types.into_values().collect();
    types.retain(|found| found.methods.len() > MOST_FILES && !EXCEPTED.contains(&found.name));
    types.sort_by_key(|found| std::cmp::Reverse(found.methods.len()));
    types
}

#[test]
fn methods_of_a_type_are_in_few_files() {
    let mut failures = String::new();
    for (home, name) in CRATES.iter().enumerate() {
        let spread = spread(sources(), home);
        if !spread.is_empty() {
            let count = spread.len();
            let _ = writeln!(
                failures,
                "{name}: {count} types have methods in more than {MOST_FILES} files"
            );
            for found in spread {
                let _ = writeln!(failures, "{}", found.described(sources()));
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

#[test]
fn a_type_with_methods_in_four_files_is_found() {
    let lib = "mod a; mod b; mod c; mod d; pub struct Other;";
    let texts = |last| {
        [
            ("linkage-c/src/lib.rs", lib),
            (
                "linkage-c/src/a.rs",
                "pub struct Shape<T>(T); impl<T> Shape<T> where T: Copy { fn a() {} fn b() { fn c() {} } }",
            ),
            (
                "linkage-c/src/b.rs",
                "use crate::a::Shape as S; impl S<u8> { fn d() {} }",
            ),
            ("linkage-c/src/c.rs", "impl super::a::Shape<[u8; 2]> {}"),
            ("linkage-c/src/d.rs", last),
        ]
    };
    let described = |last| {
        let texts = texts(last);
        let sources = from_texts(&texts);
        let found = spread(&sources, sources[0].home);
        found
            .iter()
            .map(|found| found.described(&sources))
            .collect::<String>()
    };
    assert_eq!(
        described("use crate::a::Shape; impl Clone for Shape<u8> {}"),
        ""
    );
    assert_eq!(
        described("use crate::a::Shape; #[cfg(test)] impl Shape<u8> {}"),
        ""
    );
    assert_eq!(
        described("use crate::a::Shape; impl Shape<u16> { fn e() {} }"),
        "  `Shape` of linkage-c/src/a.rs: 4 methods in 4 files: linkage-c/src/a.rs 2, linkage-c/src/b.rs 1, \
         linkage-c/src/c.rs 0, linkage-c/src/d.rs 1"
    );
}

pub(crate) fn report() -> String {
    let mut text = String::new();
    for (home, name) in CRATES.iter().enumerate() {
        let spread = spread(sources(), home);
        let _ = writeln!(
            text,
            "{name}: {} types with methods in more than {MOST_FILES} files",
            spread.len()
        );
        for found in spread {
            let mut files = found.methods.keys().chain([&found.file]);
            if files.any(|file| is_reported(sources()[*file].path)) {
                let _ = writeln!(text, "{}", found.described(sources()));
            }
        }
    }
    text
}

//! Names in small sources.

use super::{faults, named_files, repeated};
use crate::crates::from_texts;

#[test]
fn names_of_files_are_found() {
    let paths = [
        "linkage-compiler/src/unit/mod.rs",
        "linkage-compiler/src/unit/way.rs",
        "linkage-c/src/unit.rs",
        "linkage-core/src/numeric/roots/cycle.rs",
        "linkage-runtime/src/design/cycle.rs",
        "linkage-runtime/src/freeway.rs",
    ];
    assert_eq!(
        named_files(paths.into_iter())
            .into_iter()
            .collect::<Vec<_>>(),
        [
            "linkage-compiler/src/unit",
            "linkage-compiler/src/unit/way",
            "linkage-core/src/numeric/roots/cycle",
        ]
    );
    let paths = [
        "a/b.rs", "b.rs", "c/b.rs", "a/mod.rs", "b/mod.rs", "c/mod.rs", "d/mod.rs",
    ];
    assert_eq!(repeated(paths.into_iter()), []);
    assert_eq!(repeated(paths.into_iter().chain(["d/b.rs"])), [("b.rs", 4)]);
}

#[test]
fn names_in_code_are_found() {
    let text = "/// Own way.\npub(crate) struct Way;\ntype Place = u8;\npub type Turns = u8;\n\
                impl Way { fn of(own: u8) -> u8 { \"own\"; own.at(own) } fn at() {} fn often() {} }";
    let sources = from_texts(&[("linkage-c/src/lib.rs", text)]);
    let faults = faults(&sources[0]);
    let named = |line, name: &str| (line, name.to_owned());
    assert_eq!(
        faults.types,
        [named(2, "struct Way"), named(4, "type Turns")]
    );
    assert_eq!(faults.functions, [named(5, "fn of"), named(5, "fn at")]);
    assert_eq!(faults.identifiers, [vec![5, 5, 5], vec![]]);
}

#[test]
fn functions_that_generated_code_calls_are_excepted() {
    let text = "fn of() {} fn told() {}";
    let sources = from_texts(&[("linkage-runtime/src/screw.rs", text)]);
    assert_eq!(faults(&sources[0]).functions, [(1, "fn told".to_owned())]);
}

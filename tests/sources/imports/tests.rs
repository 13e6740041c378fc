//! Uses and circles in small sources.

use std::collections::BTreeSet;

use super::Checked;
use crate::crates::from_texts;

/// Uses in small sources, each as the two paths, the line and the path in code.
fn uses_of(texts: &[(&str, &str)]) -> Vec<String> {
    let sources = from_texts(texts);
    let checked = Checked::new(&sources, sources[0].home);
    let arrows = checked.uses.arrows.iter().map(|((from, to), place)| {
        let (from, to) = (sources[*from].below(), sources[*to].below());
        format!("{from}:{} {to} {}", place.line, place.written)
    });
    arrows.collect()
}

const SMALL: [(&str, &str); 7] = [
    (
        "linkage-c/src/lib.rs",
        "mod model;\nmod emit;\nmod unit;\npub use model::Shape;\n#[cfg(test)]\nmod tests;\n",
    ),
    (
        "linkage-c/src/model/mod.rs",
        "mod types;\npub(crate) use types::{Kind, Shape};\npub(super) const MOST: usize = 2;",
    ),
    (
        "linkage-c/src/model/types.rs",
        "use std::fmt;\nuse super::super::emit::{self, other};\npub struct Shape;\n\
         impl Shape { fn f() { emit::printed(); other() } }\npub enum Kind { One }",
    ),
    (
        "linkage-c/src/emit.rs",
        "use crate::{model::{Kind, Shape as Form}, unit};\npub fn printed() { Kind::One; unit::LENGTH }\n\
         pub fn other() -> Form { quote!(crate::unit::LENGTH) }\n\
         #[cfg(test)]\nmod tests { use crate::unit::LENGTH; }",
    ),
    (
        "linkage-c/src/unit.rs",
        "pub const LENGTH: u8 = crate::Shape::SIZE;",
    ),
    ("linkage-c/src/tests.rs", "use crate::unit;"),
    ("linkage-c/src/unused.rs", "use crate::unit;"),
];

#[test]
fn uses_lead_to_the_files_of_items() {
    assert_eq!(
        uses_of(&SMALL),
        [
            "model/types.rs:2 emit.rs super::super::emit::other",
            "emit.rs:1 model/types.rs crate::model::Kind",
            "emit.rs:2 unit.rs unit::LENGTH",
            "unit.rs:1 model/types.rs crate::Shape::SIZE",
        ]
    );
}

#[test]
fn a_circle_is_described() {
    let sources = from_texts(&SMALL);
    let checked = Checked::new(&sources, sources[0].home);
    let circles = checked.circles();
    let sizes: Vec<usize> = circles.iter().map(BTreeSet::len).collect();
    assert_eq!(sizes, [3]);
    let text = checked.circles_of_files(|_| true);
    let shortest = "    linkage-c/src/model/types.rs:2 uses linkage-c/src/emit.rs by `super::super::emit::other`\n    \
                    linkage-c/src/emit.rs:1 uses linkage-c/src/model/types.rs by `crate::model::Kind`\n";
    assert!(text.ends_with(shortest), "{text}");
    let (count, text) = checked.circles_of_modules();
    assert_eq!(count, 3);
    assert!(
        text.contains("`model` uses `emit`: linkage-c/src/model/types.rs:2"),
        "{text}"
    );
    let faces = checked.faces(|_| true);
    assert_eq!(
        faces,
        "  linkage-c/src/unit.rs:1 `crate::Shape::SIZE` is re-exported by the root\n"
    );
}

/// A module with an item for its children that uses an item of theirs is in a circle.
///
/// Re-exports are no use.
#[test]
fn a_face_with_items_is_in_a_circle() {
    let child = (
        "linkage-c/src/model/types.rs",
        "use super::MOST;\npub struct Shape([u8; MOST]);",
    );
    let root = ("linkage-c/src/lib.rs", "mod model;");
    let count = |face: &str| {
        let texts = [root, ("linkage-c/src/model.rs", face), child];
        let sources = from_texts(&texts);
        Checked::new(&sources, sources[0].home).circles().len()
    };
    let face = "mod types;\npub use types::Shape;\nconst MOST: usize = 2;";
    assert_eq!(count(face), 0);
    assert_eq!(count(&format!("{face}\nfn f(shape: &Shape) {{}}")), 1);
    assert_eq!(
        count(&format!("{face}\nfn f(shape: &types::Shape) {{}}")),
        1
    );
}

#[test]
fn names_imported_together_and_macros_are_uses() {
    let texts = [
        (
            "linkage-c/src/lib.rs",
            "#[macro_use] mod table;\nmod model;\nmod emit;\nmod other;",
        ),
        (
            "linkage-c/src/table.rs",
            "macro_rules! table { () => { $crate::other::f() } }",
        ),
        (
            "linkage-c/src/model.rs",
            "pub use crate::other::f;\npub enum Kind { One }",
        ),
        (
            "linkage-c/src/emit.rs",
            "use crate::model::*;\nfn g() { f(); table!() }",
        ),
        (
            "linkage-c/src/other.rs",
            "pub fn f() { use super::model::Kind::*; One }",
        ),
    ];
    assert_eq!(
        uses_of(&texts),
        [
            "table.rs:1 other.rs crate::other::f",
            "emit.rs:2 table.rs table!",
            "emit.rs:1 other.rs crate::model::*",
            "other.rs:1 model.rs super::model::Kind::*",
        ]
    );
}

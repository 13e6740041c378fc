//! `linkage js`: which files are left, and that they are those of the library.

use std::fs;

use crate::{folder, printed, refused};

#[test]
fn both_files_are_those_of_the_library() {
    let folder = folder("js");
    printed(&folder, &["new", "own.mech"]);
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    let said = printed(&folder, &["js", "own.mech", "-o", "sub/out"]);
    assert_eq!(said, "sub/out/SliderCrank.js\nsub/out/SliderCrank.d.ts\n");
    let checked = linkage_compiler::check(text.parse().expect("tokens"));
    let unit = checked.unit.expect("a mechanism without a mistake");
    let own = linkage_js::module("SliderCrank", &unit);
    let read = |path| fs::read_to_string(folder.join(path)).expect("it was written");
    assert_eq!(read("sub/out/SliderCrank.js"), own.script);
    assert_eq!(read("sub/out/SliderCrank.d.ts"), own.types);
}

#[test]
fn a_folder_that_cannot_be_made_is_told() {
    let folder = folder("js_refused");
    printed(&folder, &["new", "own.mech"]);
    let said = refused(&folder, &["js", "own.mech", "-o", "own.mech/out"], 1);
    assert!(
        said.starts_with("error: cannot make `own.mech/out`: "),
        "{said}"
    );
}

//! `linkage js`: which files are left, and that they are those of the library.

use std::fs;

use crate::{folder, linkage, printed, refused, slider};

#[test]
fn both_files_are_those_of_the_library() {
    let folder = slider("js");
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
    let folder = slider("js_refused");
    let said = refused(&folder, &["js", "own.mech", "-o", "own.mech/out"], 1);
    assert!(
        said.starts_with("error: cannot make `own.mech/out`: "),
        "{said}"
    );
}

/// Names that JavaScript has itself are others, and the command reports them; those that are one file are refused.
#[test]
fn names_of_javascript_are_reported_or_refused() {
    let folder = folder("js_names");
    let one = |name: &str| {
        format!(
            "pub struct {name} {{ unit mm; param a = 3mm; input phi = 30deg; let h = a * sin(phi); }}\nimpl {name} {{ pub fn f(phi) -> F{name} {{ h }} }}\n"
        )
    };
    fs::write(folder.join("class.mech"), one("class")).expect("a file");
    let output = linkage(&folder, &["js", "class.mech"]);
    assert!(output.status.success());
    assert_eq!(
        String::from_utf8_lossy(&output.stdout),
        "./class_.js\n./class_.d.ts\n"
    );
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        "note: class_.js: the mechanism `class` is called `class_` in JavaScript\n"
    );
    fs::write(
        folder.join("both.mech"),
        one("SliderCrank") + &one("SLIDERCRANK"),
    )
    .expect("a file");
    let said = refused(&folder, &["js", "both.mech"], 1);
    assert!(
        said.starts_with("error: `SliderCrank` and `SLIDERCRANK` would have the files `SliderCrank.js` and `SLIDERCRANK.js`, which are one"),
        "{said}"
    );
    assert!(!folder.join("SliderCrank.js").exists());
}

//! `linkage st`: which files are left, and that they are those of the library.

use std::fs;

use crate::{folder, linkage, printed, refused, slider};

#[test]
fn the_file_is_that_of_the_library() {
    let folder = slider("st");
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    let said = printed(&folder, &["st", "own.mech", "-o", "sub/out"]);
    assert_eq!(said, "sub/out/SliderCrank.st\n");
    let file = fs::read_to_string(folder.join("sub/out/SliderCrank.st")).expect("it was written");
    let checked = linkage_compiler::check(text.parse().expect("tokens"));
    let unit = checked.unit.expect("a mechanism without a mistake");
    let library = linkage_st::structured_text("SliderCrank", &unit).expect("a closed form");
    assert_eq!(file, library.text);
}

#[test]
fn other_dimensions_become_those_of_the_declaration() {
    let folder = slider("st_set");
    printed(&folder, &["st", "own.mech", "--set", "crank=41mm"]);
    let file = fs::read_to_string(folder.join("SliderCrank.st")).expect("it was written");
    assert!(
        file.contains("\n    crank : LREAL := LREAL#41.0; (* mm"),
        "{file}"
    );
}

/// Nothing is written if one of the mechanisms has a coupled group.
#[test]
fn coupled_groups_are_refused() {
    let folder = folder("st_coupled");
    let golden = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../linkage-compiler/tests/golden/eye_needle.mech"
    );
    let said = refused(&folder, &["st", golden, "-o", "out"], 1);
    assert!(said.starts_with("error: EyeNeedle: loops "), "{said}");
    assert!(
        said.contains("has no closed form, and structured text has closed forms only"),
        "{said}"
    );
    assert!(!folder.join("out").exists());
}

#[test]
fn other_names_are_reported() {
    let folder = folder("st_names");
    let text = "pub struct Crank { unit mm; param array = 3mm; input phi = 30deg; let h = array * sin(phi); }
                impl Crank { pub fn f(phi) -> F { h } }";
    fs::write(folder.join("crank.mech"), text).expect("a file");
    let output = linkage(&folder, &["st", "crank.mech"]);
    assert!(output.status.success());
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        "note: Crank.st: the parameter `array` is called `array_x` in structured text\n"
    );
}

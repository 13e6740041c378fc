//! `linkage c`: which files are left, and that they are those of the library.

use std::fs;

use linkage_c::{Real, sources};

use crate::{favorit, folder, printed, refused};

/// What the library prints for the mechanism that `linkage new` writes.
fn of_the_library(text: &str, real: Real) -> [String; 2] {
    let checked = linkage_compiler::check(text.parse().expect("tokens"));
    let unit = checked.unit.expect("a mechanism without a mistake");
    let name = checked.name.expect("it has a name");
    let sources = sources(&name, &unit, real).expect("a dyad is printed");
    [sources.header, sources.source]
}

#[test]
fn both_files_are_those_of_the_library() {
    let folder = folder("c");
    printed(&folder, &["new", "own.mech"]);
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    for (scalar, real) in [("double", Real::Double), ("float", Real::Single)] {
        let said = printed(
            &folder,
            &["c", "own.mech", "-o", "sub/out", "--scalar", scalar],
        );
        assert_eq!(said, "sub/out/slider_crank.h\nsub/out/slider_crank.c\n");
        let files = ["h", "c"].map(|ending| {
            let path = folder.join(format!("sub/out/slider_crank.{ending}"));
            fs::read_to_string(path).expect("it was written")
        });
        assert_eq!(files, of_the_library(&text, real), "{scalar}");
    }
}

#[test]
fn mechanisms_of_rust_files_are_printed_too() {
    let folder = folder("c_favorit");
    let said = printed(&folder, &["c", favorit()]);
    assert_eq!(said, "./favorit.h\n./favorit.c\n");
}

/// The folder cannot be made where a file stands: nothing is written.
#[test]
fn a_folder_that_cannot_be_made_is_told() {
    let folder = folder("c_refused");
    printed(&folder, &["new", "own.mech"]);
    let said = refused(&folder, &["c", "own.mech", "-o", "own.mech/out"], 1);
    assert!(
        said.starts_with("error: cannot make `own.mech/out`: "),
        "{said}"
    );
    assert_eq!(
        fs::read_dir(&folder).expect("the folder is there").count(),
        1
    );
}

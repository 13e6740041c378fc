//! `linkage c`: which files are left, and that they are those of the library.

use std::fs;

use linkage_c::{Real, sources};

use crate::{favorit, folder, linkage, printed, refused, slider};

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
    let folder = slider("c");
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

#[test]
fn sweeps_into_columns_have_files_of_their_own() {
    let folder = folder("c_columns");
    let said = printed(&folder, &["c", favorit(), "--columns"]);
    let files = [
        "favorit.h",
        "favorit.c",
        "favorit_columns.h",
        "favorit_columns.c",
    ];
    assert_eq!(said, files.map(|file| format!("./{file}\n")).concat());
    let header = fs::read_to_string(folder.join("favorit_columns.h")).expect("it was written");
    assert!(
        header.contains("columns: p10.x (mm), p10.y (mm), v.x (mm/rad),"),
        "{header}"
    );
}

/// The folder cannot be made where a file stands: nothing is written.
#[test]
fn a_folder_that_cannot_be_made_is_told() {
    let folder = slider("c_refused");
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

/// Names that C has itself are others, and the command reports them.
#[test]
fn other_names_are_reported() {
    let folder = folder("c_names");
    let text = "pub struct Link { unit mm; param int = 3mm; param M_PI = 3mm; input phi = 30deg; let h = (int + M_PI) * sin(phi); }
                impl Link { pub fn f(phi) -> F { h } }";
    fs::write(folder.join("link.mech"), text).expect("a file");
    let output = linkage(&folder, &["c", "link.mech"]);
    assert!(output.status.success());
    assert_eq!(
        String::from_utf8_lossy(&output.stdout),
        "./link_.h\n./link_.c\n"
    );
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        "note: link_.h: the mechanism `Link` is called `link_` in C\n\
         note: link_.h: the parameter `int` is called `int_` in C\n\
         note: link_.h: the parameter `M_PI` is called `M_PI_` in C\n"
    );
    assert!(folder.join("link_.h").exists() && folder.join("link_.c").exists());
}

/// Two mechanisms that would be one in C: no file is written, and each of them can be written alone.
#[test]
fn names_that_become_one_are_refused() {
    let folder = folder("c_clash");
    let one = |name: &str| {
        format!(
            "pub struct {name} {{ unit mm; param a = 3mm; input phi = 30deg; let h = a * sin(phi); }}\nimpl {name} {{ pub fn f(phi) -> F{name} {{ h }} }}\n"
        )
    };
    let text = one("SliderCrank") + &one("Slider_Crank");
    fs::write(folder.join("both.mech"), text).expect("a file");
    let said = refused(&folder, &["c", "both.mech"], 1);
    assert!(
        said.starts_with(
            "error: `SliderCrank` and `Slider_Crank` would both have the name `slider_crank` in C. "
        ),
        "{said}"
    );
    assert!(!folder.join("slider_crank.h").exists());
    let said = printed(
        &folder,
        &[
            "c",
            "both.mech",
            "--mechanism",
            "Slider_Crank",
            "-o",
            "second",
        ],
    );
    assert_eq!(said, "second/slider_crank.h\nsecond/slider_crank.c\n");
}

//! `linkage fmt`: files with blanks by the rules.

use std::fs;

use crate::{folder, linkage, printed, refused};

const WIDE: &str = "struct A{unit mm;param  a=1mm;//of it\nparam b = 2mm;}\n";
const FORMATTED: &str = "struct A {\n    unit mm;\n    param a = 1mm;                              // of it\n    param b = 2mm;\n}\n";

#[test]
fn files_are_formatted_once() {
    let folder = folder("fmt");
    let file = folder.join("a.mech");
    fs::write(&file, WIDE).expect("a file");
    fs::write(folder.join("b.mech"), FORMATTED).expect("a file");
    let output = linkage(&folder, &["fmt", "--check", "a.mech", "b.mech"]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "a.mech\n");
    assert_eq!(fs::read_to_string(&file).expect("a file"), WIDE);

    assert_eq!(printed(&folder, &["fmt", "a.mech", "b.mech"]), "");
    assert_eq!(fs::read_to_string(&file).expect("a file"), FORMATTED);
    assert_eq!(
        printed(&folder, &["fmt", "--check", "a.mech", "b.mech"]),
        ""
    );
}

#[test]
fn files_that_cannot_be_read_stay() {
    let folder = folder("fmt-refused");
    for (name, text, message) in [
        (
            "a.mech",
            "struct A { let a = (1; }",
            "a bracket has no partner",
        ),
        ("a.rs", "fn main() { }", "format it with `rustfmt`"),
    ] {
        fs::write(folder.join(name), text).expect("a file");
        let said = refused(&folder, &["fmt", name], 1);
        assert!(said.contains(message), "{said}");
        assert_eq!(fs::read_to_string(folder.join(name)).expect("a file"), text);
    }
    assert!(refused(&folder, &["fmt", "c.mech"], 1).contains("cannot read `c.mech`"));
}

//! Names in one normal form, and letters that look alike.

use std::fs;

use crate::{folder, linkage, printed, refused};

/// `ré` with one letter in the declaration, and with an accent of its own in the formula.
const ACCENT: &str = "pub struct S { unit mm; param r\u{e9} = 3mm; input phi = 90deg; \
    let h = re\u{301} * sin(phi); } impl S { pub fn hauteur_e\u{301}(phi) -> F { h } }";

#[test]
fn one_name_in_two_spellings_is_one() {
    let folder = folder("normal");
    fs::write(folder.join("own.mech"), ACCENT).expect("written");
    assert!(printed(&folder, &["check", "own.mech"]).starts_with("S: mobility 1"));
    // Names on the command line, too, in both spellings.
    for set in ["r\u{e9}=5mm", "re\u{301}=5mm"] {
        for function in ["hauteur_\u{e9}", "hauteur_e\u{301}"] {
            let table = ["table", "own.mech", function, "--steps", "1", "--set", set];
            let text = printed(&folder, &table);
            assert!(text.ends_with(",5\r\n"), "{text}");
        }
    }
}

#[test]
fn letters_that_look_alike_are_warned_of() {
    let folder = folder("alike");
    let text = "pub struct S { unit mm; param a = 3mm; param \u{430} = 4mm; input phi = 30deg; \
        let h = (a - \u{430}) * sin(phi); } impl S { pub fn f(phi) -> F { h } }";
    let warning =
        "warning: `\u{430}` looks like `a`, and is another name: U+0430 instead of U+0061\n";
    fs::write(folder.join("own.mech"), text).expect("written");
    for command in [&["check", "own.mech"][..], &["table", "own.mech", "f"]] {
        let output = linkage(&folder, command);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.success() && said.starts_with(warning),
            "{said}"
        );
    }
    // It explains a mistake, on the command line, too.
    let set = ["table", "own.mech", "f", "--set", "\u{430}\u{430}=3mm"];
    let plain = text.replace('\u{430}', "aa");
    fs::write(folder.join("plain.mech"), plain).expect("written");
    let said = refused(&folder, &[&["table", "plain.mech"], &set[2..]].concat(), 1);
    assert_eq!(
        said,
        "error: there is no dimension `\u{430}\u{430}` in S; there is `a` and `aa`\n\
         help: `\u{430}\u{430}` looks like `aa`, and is another name: U+0430 instead of U+0061\n"
    );
    fs::write(
        folder.join("own.mech"),
        text.replace("param \u{430} = 4mm;", ""),
    )
    .expect("written");
    let said = refused(&folder, &["check", "own.mech"], 1);
    assert!(said.starts_with(warning), "{said}");
    assert!(said.contains("error: unknown name `\u{430}`"), "{said}");
}

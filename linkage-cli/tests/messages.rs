//! Messages are those that rustc prints for the macro, word for word, with file, line and column.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::{check, check_all};
use linkage_engine::{Source, rendered};

/// Faulty programs beside what rustc prints for them.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/messages/tests/ui")
}

fn programs() -> Vec<PathBuf> {
    let phases = fs::read_dir(folder()).expect("the folder can be read");
    let files = phases.flat_map(|phase| {
        let phase = phase.expect("a folder").path();
        fs::read_dir(phase).expect("it can be read")
    });
    let paths = files.map(|file| file.expect("a file").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|ending| ending == "rs"))
        .collect();
    paths.sort();
    paths
}

/// What rustc says beside the messages: about names outside the macro, which nobody else knows, about lints, about what is no token.
const OF_RUSTC: [&str; 5] = [
    "error[E",
    "the lint level is defined here",
    "unknown start of token",
    "identifiers, which look alike",
    "this error originates in the macro",
];

#[test]
fn messages_are_those_of_the_macro() {
    let mut compared = 0;
    for path in programs() {
        let expected = fs::read_to_string(path.with_extension("stderr")).expect("messages");
        if OF_RUSTC.iter().any(|own| expected.contains(own)) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("the program can be read");
        let name = path.strip_prefix(folder()).expect("a file of the folder");
        let name = Path::new("tests/ui").join(name);
        let source = Source::new(&name.to_string_lossy(), &text).expect("tokens");
        let told: String = source
            .calls()
            .iter()
            .map(|found| rendered(&source, found, &check(found.tokens.clone()), false))
            .collect();
        assert_eq!(told.trim_end(), expected.trim_end(), "{}", name.display());
        compared += 1;
    }
    assert!(compared >= 140, "{compared} files");
}

#[test]
fn text_files_have_lines_and_columns_of_their_own() {
    let text = "// Two mechanisms.
struct First {
    param crank = 40mm;
    input phi = 0deg;
    let pin = polar(crank, phi);
}
impl First {
    fn pin(phi) -> Pin { pin }
}
/// The other one.
pub struct Second {
    param crank = 40mm;
    input phi = 0deg;
    let pin = polar(crnak, phi);
}
impl Second {
    fn pin(phi) -> SecondPin { pin }
}
";
    let source = Source::new("two.mech", text).expect("tokens");
    let [all] = source.calls() else {
        panic!("they may have each other as parts");
    };
    let checked = check_all(all.tokens.clone());
    let [first, second] = &checked[..] else {
        panic!("two mechanisms");
    };
    assert_eq!(rendered(&source, all, first, false), "");
    assert_eq!(second.name.as_deref(), Some("Second"));
    let told = rendered(&source, all, second, false);
    let expected = "error: unknown name `crnak`
       help: did you mean `crank`?
  --> two.mech:14:21
   |
14 |     let pin = polar(crnak, phi);
   |                     ^^^^^

";
    assert_eq!(told, expected);
}

#[test]
fn deep_nesting_is_a_limit() {
    let text = |depth: usize| {
        let [open, close] = ["(", ")"].map(|bracket| bracket.repeat(depth));
        format!("struct A {{ let a = {open}1mm{close}; }} impl A {{}}")
    };
    let messages = |depth| {
        let source = Source::new("a.mech", &text(depth)).expect("it is read");
        check(source.calls()[0].tokens.clone()).messages
    };
    assert!(messages(60).is_empty());
    // The macro has a limit of its own.
    assert!(
        messages(120)[0]
            .text
            .contains("nested more than 64 levels deep")
    );
    for text in [
        text(20_000),
        format!("fn main() {{ mechanism!{{ {} }} }}", text(200)),
    ] {
        let failure = Source::new("a.mech", &text).expect_err("too deep");
        let said = failure.to_string();
        assert!(said.contains("nested more than 128 deep"), "{said}");
    }
}

#[test]
fn what_is_no_token_is_told_with_its_place() {
    for (text, told) in [
        (
            "struct A {\n    param a = 1mm ± 1um;\n}",
            "error: the character `±` means nothing here\n --> a.mech:2:19\n",
        ),
        (
            "struct A {\n    param a = (1mm;\n}",
            "error: this cannot be read: a bracket has no partner, or a text or comment no end\n --> a.mech:3:1\n",
        ),
    ] {
        let failure = Source::new("a.mech", text).expect_err("no tokens");
        assert!(failure.to_string().starts_with(told), "{failure}");
    }
    for text in [
        "fn main() {}",
        "macro_rules! two { ($name:ident) => { mechanism! { struct $name {} impl $name {} } } }",
        "// mechanism! { struct A {} }",
    ] {
        let failure = Source::new("a.rs", text).expect_err("no mechanism");
        assert_eq!(
            failure.to_string(),
            "error: there is no call of `mechanism!` in `a.rs`\n"
        );
    }
    let failure = Source::new("a.rs", "").expect_err("no mechanism");
    assert_eq!(
        failure.to_string(),
        "error: there is no call of `mechanism!` in `a.rs`\n"
    );
}

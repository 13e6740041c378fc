//! Messages are those of the macro, word for word, with file, line and column.

#[path = "../../linkage-compiler/tests/messages/case_file.rs"]
mod case_file;

use std::fs;
use std::path::{Path, PathBuf};

use case_file::CaseFile;
use linkage_compiler::{check, check_all};
use linkage_engine::{Source, rendered};

/// Returns the files with an ending in a folder of the repository and in its folders.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut folders = vec![root.join(folder)];
    let mut paths = Vec::new();
    while let Some(folder) = folders.pop() {
        for file in fs::read_dir(folder).expect("the folder can be read") {
            let path = file.expect("a file").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == ending) {
                paths.push(path);
            }
        }
    }
    paths.sort();
    paths
}

/// All cases of the compiler: a test of `linkage-messages` compares them with the output of rustc.
#[test]
fn messages_are_those_of_the_compiler() {
    let mut compared = 0;
    for path in files("linkage-compiler/tests/messages", "txt") {
        let text = fs::read_to_string(&path).expect("cases");
        let cases = CaseFile::parsed(&text).expect("the form of cases").cases;
        for case in cases {
            let source = Source::new(&case.name, &case.mechanism).expect("tokens");
            let [call] = source.calls() else {
                panic!("{}: they may have each other as parts", case.name);
            };
            let checked = check_all(call.tokens.clone());
            let blocks = checked
                .iter()
                .map(|one| rendered(&source, call, one, false));
            let text: String = blocks.collect();
            assert_eq!(text.trim_end(), case.messages.trim_end(), "{}", case.name);
            compared += 1;
        }
    }
    assert!(compared >= 230, "{compared} cases");
}

/// Texts that rustc prints besides the messages: about names outside the macro, about lints, about
/// letters that are no token.
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
    for path in files("tests/messages/tests/ui", "rs") {
        let expected = fs::read_to_string(path.with_extension("stderr")).expect("messages");
        if OF_RUSTC.iter().any(|text| expected.contains(text)) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("the program can be read");
        let start = path
            .to_string_lossy()
            .rfind("tests/ui")
            .expect("its folder");
        let name = &path.to_string_lossy()[start..];
        let source = Source::new(name, &text).expect("tokens");
        let blocks = source.calls().iter().map(|call| {
            let checked = check(call.tokens.clone());
            rendered(&source, call, &checked, false)
        });
        let text: String = blocks.collect();
        assert_eq!(text.trim_end(), expected.trim_end(), "{name}");
        compared += source.calls().len();
    }
    assert!(compared >= 6, "{compared} mechanisms");
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
            "error: the character `±` means nothing here\n       help: write `+-`\n --> a.mech:2:19\n",
        ),
        (
            "struct A {\n    param a = 1mm € 1um;\n}",
            "error: the character `€` means nothing here\n --> a.mech:2:19\n",
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
            "there is no call of `mechanism!` in `a.rs`"
        );
    }
    let failure = Source::new("a.rs", "").expect_err("no mechanism");
    assert_eq!(
        failure.to_string(),
        "there is no call of `mechanism!` in `a.rs`"
    );
}

//! Every phase's text for several mechanisms, compared with files in `tests/golden`.
//!
//! `UPDATE=1 cargo test -p linkage-compiler --test phases golden` writes them anew; read the difference before you commit it.

mod brief;
mod features;
mod sample;

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::trace::{Trace, trace};
use proc_macro2::TokenStream;
use quote::quote;

use self::brief::brief;
use self::sample::Sample;

/// The mechanism whose generated items are shown as a whole.
const SAMPLE: &str = "crank_rocker";

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

fn read(name: &str) -> TokenStream {
    let path = folder().join(format!("{name}.mech"));
    let text = fs::read_to_string(&path).expect("the mechanism can be read");
    text.parse().expect("the mechanism is made of tokens")
}

/// The generated items, with the name of a drawn mechanism for its programs in other languages.
fn printed(mechanism: TokenStream) -> TokenStream {
    linkage_rust::compile(quote!([::linkage] #mechanism), |name, _| {
        format!("{name} as a text")
    })
}

fn compare(name: &str, phase: &str, text: &str) {
    let path = folder().join(format!("{name}.{phase}.txt"));
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, text).expect("the golden file can be written");
        return;
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        text == expected,
        "{phase} of {name} differs from {}; UPDATE=1 accepts the new text\n{text}",
        path.display()
    );
}

fn check(name: &str) {
    let Trace {
        syntax,
        model,
        structure,
        formulate,
        lower,
        passes: _,
        messages,
    } = trace(read(name));
    assert!(messages.is_empty(), "{messages:?}");
    let front = [
        ("1 syntax", syntax),
        ("2 model", model),
        ("3 structure", structure),
        ("4 formulate", formulate),
    ];
    let front = front.map(|(phase, text)| format!("== {phase}\n\n{}\n", text.trim_end()));
    compare(name, "1-front", &front.join("\n"));
    compare(name, "5-lower", &lower);
    let sample = (name != SAMPLE).then(|| Sample::new(&printed(read(SAMPLE))));
    compare(
        name,
        "6-emit",
        &brief(&printed(read(name)), sample.as_ref()),
    );
}

#[test]
fn crank_rocker() {
    check(SAMPLE);
}

#[test]
fn cam_press() {
    check("cam_press");
}

#[test]
fn eye_needle() {
    check("eye_needle");
}

#[test]
fn forces() {
    check("forces");
}

#[test]
fn favorit() {
    check("favorit");
}

#[test]
fn shaper() {
    check("shaper");
}

#[test]
fn loader() {
    check("loader");
}

#[test]
fn rssr() {
    check("rssr");
}

/// Parts: the text of the last mechanism, which has the others in it.
#[test]
fn machine() {
    check("machine");
}

/// What each pass makes of each function: programs are written where a pass changed something.
#[test]
fn passes() {
    let passes = trace(read(SAMPLE)).passes;
    let texts = passes
        .iter()
        .map(|(function, pass, program)| format!("function {function}, {pass}\n{program}\n"));
    compare(SAMPLE, "5-passes", &texts.collect::<String>());
}

/// Equal input gives equal output, whatever ran before in this process.
#[test]
fn output_is_deterministic() {
    for name in [
        "crank_rocker",
        "favorit",
        "shaper",
        "loader",
        "rssr",
        "wrist",
        "cam_press",
    ] {
        let first = printed(read(name)).to_string();
        let _ = printed(read("favorit"));
        assert_eq!(first, printed(read(name)).to_string(), "{name}");
    }
}

#[test]
fn wrist() {
    check("wrist");
}

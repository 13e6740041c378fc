//! Texts that are read in two stages, as the language server does.

use std::time::{Duration, Instant};

use linkage_editor::{Diagnostic, Document, Evaluation};

use crate::{after, text};

/// Links that do not reach each other.
const SHORT: &str = "struct Short { unit mm; param r = 80mm; input phi = 0deg; unknown psi = 0deg;
    unknown s = 9mm; loop polar(r, phi) + polar(30mm, psi) = (s, 60mm); }";

/// A mechanism whose assembly takes the solver a while.
const SLOW: &str = include_str!("../../../mechanisms/eye_needle.rs");

/// Reads a text to the end of the second stage.
fn solve(document: &mut Document, text: &str) -> Option<Evaluation> {
    let solving = document.read(text);
    solving.and_then(|solving| document.finish(solving.run()))
}

fn words<'d>(document: &'d Document, message: &Diagnostic) -> &'d str {
    &document.text()[message.range.clone()]
}

#[test]
fn messages_of_the_solver_stay_until_it_has_others() {
    let mut document = Document::new("short.mech", "");
    assert!(solve(&mut document, SHORT).is_none());
    let [before] = document.diagnostics() else {
        panic!("{:?}", document.diagnostics());
    };
    assert!(before.message.contains("cannot close"), "{before:?}");
    let meant = words(&document, before).to_owned();

    let longer = SHORT.replace("80mm", "8000mm");
    let solving = document.read(&longer).expect("other words");
    assert!(!document.is_solved());
    let [moved] = document.diagnostics() else {
        panic!("{:?}", document.diagnostics());
    };
    assert_eq!(words(&document, moved), meant);
    assert!(document.finish(solving.run()).is_none());
    let whole = Document::new("short.mech", &longer);
    assert_eq!(document.diagnostics(), whole.diagnostics());

    // A mistake in a name: the mechanism is not solved, so nothing more is known of it.
    let broken = longer.replace("(r,", "(rr,");
    assert!(document.read(&broken).is_none());
    assert_eq!(document.diagnostics().len(), 1);
    assert!(document.diagnostics()[0].message.contains("`rr`"));
}

#[test]
fn a_mistake_leaves_the_messages_of_other_mechanisms() {
    let two = |name: &str| format!("{SHORT} struct Other {{ unit mm; let x = 2 * {name}; }}");
    let mut document = Document::new("two.mech", "");
    let _ = solve(&mut document, &two("PI"));
    assert_eq!(document.diagnostics().len(), 1);
    let solving = document.read(&two("PIE"));
    let messages: Vec<&str> = document
        .diagnostics()
        .iter()
        .map(|found| words(&document, found))
        .collect();
    assert_eq!((messages.len(), messages[0]), (2, "PIE"), "{messages:?}");
    let present = document.diagnostics().to_vec();
    assert!(
        document
            .finish(solving.expect("one is sound").run())
            .is_none()
    );
    let all = document.diagnostics();
    assert!(all.len() == 2 && all.iter().all(|found| present.contains(found)));
}

#[test]
fn comments_are_not_solved() {
    let mut document = Document::new("short.mech", "");
    let _ = solve(&mut document, SHORT);
    let remarked = SHORT.replace("unknown s", "// The slider.\n    unknown  s");
    assert!(document.read(&remarked).is_none() && document.is_settled());
    let whole = Document::new("short.mech", &remarked);
    assert_eq!(document.diagnostics(), whole.diagnostics());
}

#[test]
fn results_of_earlier_texts_change_nothing() {
    let mut document = Document::new("slider.mech", "");
    let slider = text("slider");
    let first = document.read(&slider).expect("it is new");
    let longer = slider.replace("40mm", "41mm");
    let second = document.read(&longer).expect("another length");
    assert!(document.finish(first.run()).is_none() && !document.is_solved());
    let values = document.finish(second.run()).expect("it has values").run();
    let third = solve(&mut document, &slider).expect("it has values");
    assert!(!document.take_values(values));
    assert!(document.take_values(third.run()) && document.is_settled());
}

#[test]
fn values_are_the_last_ones_until_the_next() {
    let slider = text("slider");
    let mut document = Document::new("slider.mech", "");
    let values = solve(&mut document, &slider).expect("it has values");
    let at = after(&document, "let pin");
    assert!(document.hints().is_empty() && !document.is_settled());
    assert!(document.take_values(values.run()));
    let hints = document.hints();
    assert!(!hints.is_empty());
    let described = |document: &Document, at| document.hover(at).expect("a name").markdown;
    let hover = described(&document, at);
    assert!(
        hover.contains("at the reference\n") && hover.contains("operations: "),
        "{hover}"
    );

    let longer = slider.replace("40mm", "45mm");
    let values = solve(&mut document, &longer).expect("it has values");
    let at = after(&document, "let pin");
    let labels = |hints: &[linkage_editor::Hint]| -> Vec<String> {
        hints.iter().map(|hint| hint.label.clone()).collect()
    };
    assert_eq!(labels(&document.hints()), labels(&hints));
    assert!(described(&document, at).contains("before the last change"));
    assert!(document.take_values(values.run()));
    assert_ne!(labels(&document.hints()), labels(&hints));
    assert_eq!(
        document.hints(),
        Document::new("slider.mech", &longer).hints()
    );
    let whole = Document::new("slider.mech", &longer);
    assert_eq!(described(&document, at), described(&whole, at));

    let broken = longer.replace("polar(crank", "polar(cank");
    assert!(document.read(&broken).is_none());
    assert!(document.hints().is_empty());
    assert!(described(&document, at).contains("before the last mistakes"));
}

/// One document through all changes has the messages of one that is made for each text.
#[test]
fn changes_end_at_the_messages_of_the_whole_text() {
    let mut document = Document::new("a.mech", "");
    for (number, name) in ["slider", "joints", "cam", "geneva"].iter().enumerate() {
        let whole = text(name);
        let bytes = whole.char_indices().skip(number).step_by(397);
        for (byte, character) in bytes {
            let broken = Document::edit(&whole, byte..byte + character.len_utf8(), "");
            for text in [&broken, &whole] {
                let _ = solve(&mut document, text);
                let other = Document::new("a.mech", text);
                assert_eq!(
                    document.diagnostics(),
                    other.diagnostics(),
                    "{name} at {byte}"
                );
                assert_eq!(document.runs(), other.runs(), "{name} at {byte}");
            }
        }
    }
}

/// Only messages are known of Rust files.
#[test]
fn rust_files_have_no_values() {
    let file = format!("linkage::mechanism! {{ {} }}", text("slider"));
    let mut document = Document::new("slider.rs", "");
    assert!(solve(&mut document, &file).is_none());
    assert!(document.runs() && document.is_settled());
}

/// The first stage does not wait for the solver, on machines of every speed.
#[test]
fn reading_takes_a_part_of_the_time_of_solving() {
    let mut document = Document::new("slow.rs", "");
    let mut read = Duration::MAX;
    let mut solved = Duration::ZERO;
    for length in ["30mm", "31mm", "32mm"] {
        let text = format!("{SLOW}\n// {length}");
        let start = Instant::now();
        let solving = document.read(&text).expect("another text");
        read = read.min(start.elapsed());
        let start = Instant::now();
        let _ = solving.run();
        solved = solved.max(start.elapsed());
    }
    assert!(read * 4 < solved, "{read:?} of {solved:?}");
    assert!(read < Duration::from_secs(1), "{read:?}");
}

/// The text between the braces of `mechanism! { }` in a file of the largest examples.
fn example(file: &str) -> &str {
    let (_, text) = file.split_once("mechanism! {").expect("a call");
    text.rsplit_once('}').expect("its end").0
}

/// A text is compiled once for its messages, and once for its values with other functions:
/// `cargo test --release -p linkage-editor --test editor -- --ignored --nocapture`.
#[test]
#[ignore = "prints times, with optimisation"]
fn the_times_of_the_stages() {
    let axle = include_str!("../../../mechanisms/five_link_axle.rs");
    let machine = include_str!("../../../mechanisms/knitting_machine.rs");
    let examples = [
        ("slider", text("slider")),
        ("five_link_axle", example(axle).to_owned()),
        ("knitting_machine", example(machine).to_owned()),
    ];
    for (name, text) in examples {
        let mut times: [Vec<Duration>; 3] = Default::default();
        for _ in 0..5 {
            let mut document = Document::new(name, "");
            let timed = |times: &mut Vec<Duration>, begin: Instant| times.push(begin.elapsed());
            let begin = Instant::now();
            let solving = document.read(&text).expect("a text");
            timed(&mut times[0], begin);
            let begin = Instant::now();
            let solved = solving.run();
            timed(&mut times[1], begin);
            let evaluation = document.finish(solved).expect("values");
            let begin = Instant::now();
            assert!(document.take_values(evaluation.run()));
            timed(&mut times[2], begin);
        }
        let [names, messages, values] = times.map(|times| times.into_iter().min().unwrap());
        println!("{name}: names {names:?}, solution {messages:?}, values {values:?}");
    }
}

//! Documents in plain English: short sentences, nouns as subjects, no words that the style avoids, and few pages.

use std::fs;
use std::path::Path;

use crate::measures::{long_sentence, occurring, per_thousand};
use crate::pages;

/// Words of a sentence, which nine sentences out of ten do not exceed.
const WORDS_OF_A_SENTENCE: usize = 30;

/// A clause as a subject begins with this word.
const CLAUSE: &str = "what";
const CLAUSES_PER_THOUSAND: f64 = 2.0;

const AVOIDED: [&str; 10] = [
    "aboard",
    "anew",
    "at hand",
    "but for",
    "by hand",
    "in words",
    "of ours",
    "told",
    "whoever",
    "without a word",
];

/// Documents that readers read as a whole: a size in words, or in bytes.
const SIZES: [(&str, Size); 3] = [
    ("README.md", Size::Words(1200)),
    ("ARCHITECTURE.md", Size::Bytes(12 * 1024)),
    ("CHANGELOG.md", Size::Bytes(8 * 1024)),
];

enum Size {
    Words(usize),
    Bytes(usize),
}

/// Notes are dated and never change.
fn is_note(page: &Path) -> bool {
    page.starts_with("docs/notes")
}

fn faults(page: &Path, text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let long = long_sentence(text);
    if long > WORDS_OF_A_SENTENCE {
        faults.push(format!(
            "one sentence in ten has {long} words or more, at most {WORDS_OF_A_SENTENCE}"
        ));
    }
    let clauses = per_thousand(text, CLAUSE);
    if clauses > CLAUSES_PER_THOUSAND {
        faults.push(format!(
            "`{CLAUSE}` {clauses:.1} times in 1000 words, at most {CLAUSES_PER_THOUSAND}"
        ));
    }
    let avoided = occurring(text, &AVOIDED);
    if !avoided.is_empty() {
        faults.push(format!(
            "words that the style avoids: {}",
            avoided.join(", ")
        ));
    }
    let size = SIZES.iter().find(|(name, _)| page == Path::new(name));
    match size {
        Some((_, Size::Words(most))) if text.split_whitespace().count() > *most => {
            faults.push(format!(
                "{} words, at most {most}",
                text.split_whitespace().count()
            ));
        }
        Some((_, Size::Bytes(most))) if text.len() > *most => {
            faults.push(format!("{} bytes, at most {most}", text.len()));
        }
        _ => {}
    }
    faults
}

#[test]
fn documents_are_in_plain_english() {
    let pages = pages();
    let mut failures = Vec::new();
    for page in pages.iter().filter(|page| !is_note(page)) {
        let text = fs::read_to_string(page).expect("a page");
        let faults = faults(page, &text);
        let named = faults
            .iter()
            .map(|own| format!("{}: {own}", page.display()));
        failures.extend(named);
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// Faults of a text as a page of the book.
fn faults_of(text: &str) -> Vec<String> {
    faults(Path::new("docs/page.md"), text)
}

#[test]
fn each_fault_is_found() {
    let plain = "A program returns a point. ".repeat(100);
    assert!(faults_of(&plain).is_empty());
    let words = |count: usize| format!("{}end. ", "word ".repeat(count - 1));
    // Ten sentences, one of which may be long.
    let short = words(5).repeat(9);
    assert!(faults_of(&format!("{short}{}", words(31))).is_empty());
    assert!(faults_of(&words(30)).is_empty());
    assert_eq!(faults_of(&words(31)).len(), 1);
    assert_eq!(
        faults_of(&format!("{short}\n- {}\n- {}", words(31), words(31))).len(),
        1
    );
    // A clause as subject: 500 words in 100 sentences may have one.
    assert!(faults_of(&format!("{plain} What is it?")).is_empty());
    assert_eq!(
        faults_of(&format!("{plain} What is it? What is that?")).len(),
        1
    );
    // Over the end of a line, in a row of a table, in a heading.
    for avoided in [
        "all but\nfor one",
        "\n| row | told |",
        "\n## Drawn anew",
        "(by hand)",
    ] {
        assert_eq!(
            faults_of(&format!("{plain}{avoided}")).len(),
            1,
            "{avoided}"
        );
    }
    // Code and the targets of links do not count.
    let code = "`told anew` [a page](told.md) [another][what]\n\n```text\nby hand\n```\n\n[what]: told.md\n";
    assert!(faults_of(&format!("{plain}{code}")).is_empty());
}

#[test]
fn sizes_are_held() {
    for (name, size) in &SIZES {
        let (fits, exceeds) = match size {
            Size::Words(most) => ("a. ".repeat(*most), "a. ".repeat(most + 1)),
            Size::Bytes(most) => ("a".repeat(*most), "a".repeat(most + 1)),
        };
        assert!(faults(Path::new(name), &fits).is_empty(), "{name}");
        assert_eq!(faults(Path::new(name), &exceeds).len(), 1, "{name}");
    }
}

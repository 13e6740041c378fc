//! Faults in small comments.

use super::{Figures, most};
use crate::crates::from_texts;

fn figures_of(text: &str) -> Figures {
    let sources = from_texts(&[("linkage-c/src/lib.rs", text)]);
    Figures::of(&sources[0])
}

#[test]
fn each_fault_is_found() {
    let plain = "//! A module.\n\n/// Returns `what` it has.\n///\n/// ```\n/// told(what);\n/// ```\nfn f() {\n    \
                 // What is told here does not count.\n}\n";
    let figures = figures_of(plain);
    assert_eq!((figures.comments, figures.words), (2, 6));
    assert_eq!(figures.faults(), 0);
    let faults = |comment: &str| {
        let figures = figures_of(&format!("{plain}{comment}\nfn g() {{}}"));
        let (clauses, first, avoided) = (figures.clauses, figures.first_words, figures.avoided);
        (clauses, first, avoided, figures.long_lines)
    };
    assert_eq!(faults("/// What it has."), (1, 1, 0, 0));
    assert_eq!(faults("///\n/// `Code`, and what it has"), (1, 0, 0, 0));
    assert_eq!(faults("/// If so"), (0, 1, 0, 0));
    assert_eq!(faults("/// All but\n/// for one, anew."), (0, 0, 2, 0));
    assert_eq!(faults("/** Whether */"), (0, 1, 0, 0));
    assert_eq!(faults("/// One.\n\n// two\n/// By two."), (0, 1, 0, 0));
    assert_eq!(faults(&format!("// {}", "a".repeat(117))), (0, 0, 0, 0));
    assert_eq!(faults(&format!("// {}", "a".repeat(118))), (0, 0, 0, 1));
    assert_eq!(
        faults(&format!("const A: &str = \"\n// {}\";", "a".repeat(118))).3,
        0
    );
}

#[test]
fn figures_above_their_limits_are_found() {
    let figures = figures_of("/// What a thing.\nfn f() {}\n/// A thing of it\nfn g() {}");
    assert_eq!(figures.clauses_per_thousand().round(), 143.0);
    assert_eq!(figures.first_words_per_hundred(), 50.0);
    assert!(!figures.exceeds(most(143.0, 50.0, 0, 0)));
    assert!(figures.exceeds(most(142.0, 50.0, 0, 0)));
    assert!(figures.exceeds(most(143.0, 49.0, 0, 0)));
}

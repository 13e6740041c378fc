//! The pages on structured text and on new languages: pieces of code are those of the sources, and the program of the page
//! has the names of the printed file.

use linkage_corpus::given::Given;
use linkage_st::structured_text;

use crate::mechanisms::Read;

const PAGE: &str = include_str!("../../../docs/st.md");
const NEW_LANGUAGE: &str = include_str!("../../../docs/new-language.md");

const SOURCES: [&str; 6] = [
    include_str!("../../src/assemble.rs"),
    include_str!("../../src/blocks.rs"),
    include_str!("../../src/helpers.st"),
    include_str!("../../src/lib.rs"),
    include_str!("../../src/names.rs"),
    include_str!("../../src/program.rs"),
];

/// The blocks of a page in a language, in order.
fn blocks(page: &'static str, language: &str) -> Vec<&'static str> {
    let fence = format!("\n```{language}\n");
    let parts = page.split(&fence[..]).skip(1);
    parts
        .map(|own| own.split("```").next().expect("a block"))
        .collect()
}

#[test]
fn pieces_of_code_are_those_of_the_sources() {
    let pieces = [blocks(NEW_LANGUAGE, "rs"), blocks(NEW_LANGUAGE, "text")].concat();
    assert!(pieces.len() > 8, "{}", pieces.len());
    for piece in pieces {
        assert!(SOURCES.iter().any(|own| own.contains(piece)), "{piece}");
    }
}

#[test]
fn the_sizes_are_those_of_the_page() {
    let code = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with("//");
    let lines = |end: bool| {
        SOURCES
            .iter()
            .filter(move |own| own.starts_with("//!") == end)
    };
    let rust: usize = lines(true)
        .map(|own| own.lines().filter(code).count())
        .sum();
    let text: usize = lines(false).map(|own| own.lines().count()).sum();
    assert!(
        rust <= 520 && text <= 190,
        "{rust} lines of Rust, {text} of structured text"
    );
}

#[test]
fn the_program_has_the_names_of_the_file() {
    let given = Given::text(blocks(PAGE, "text")[0]);
    let printed = structured_text(&given.name, &given.unit).expect("a closed form");
    assert_eq!(printed.name, "Press");
    for name in ["Press", "Press_motion_result"] {
        assert!(
            printed.text.contains(&format!("\n{name} : STRUCT\n")),
            "{name}"
        );
    }
    for block in ["Press_assemble", "Press_motion"] {
        assert!(
            printed.text.contains(&format!(
                "\nFUNCTION_BLOCK {block}\nVAR_IN_OUT m : Press; END_VAR\n"
            )),
            "{block}"
        );
    }
    for line in [
        "    ram : LREAL; (* mm *)\n",
        "    phi : LREAL; (* rad, from 0 deg to 360 deg *)\n",
    ] {
        assert!(printed.text.contains(line), "{line}");
    }
    let read = Read::new(&given);
    let (mut mechanism, code) = read.assembled(None);
    assert_eq!(code, 0);
    let results = read.call(&mut mechanism, "motion", &[0.0]);
    assert_eq!(results, [190.0, 0.0]);
}

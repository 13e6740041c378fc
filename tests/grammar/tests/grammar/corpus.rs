//! The trees of `test/corpus`, which `tree-sitter test` compares, too.

use linkage_grammar::{read, tree};

const FILES: [&str; 4] = ["blocks", "comments", "expressions", "items"];

/// The line before and after a title.
const LINE: &str = "========================================\n";

/// Returns title, text and tree of each case of a file.
fn cases(file: &str) -> Vec<(&str, &str, String)> {
    let parts: Vec<&str> = file.split(LINE).skip(1).collect();
    let pairs = parts.chunks(2).map(|pair| (pair[0].trim(), pair[1]));
    let cases = pairs.map(|(title, rest)| {
        let (text, tree) = rest.split_once("\n---\n").expect("a text and a tree");
        let tree: Vec<&str> = tree.split_whitespace().collect();
        (title, text, tree.join(" "))
    });
    cases.collect()
}

#[test]
fn trees_are_those_of_the_corpus() {
    let mut count = 0;
    for name in FILES {
        let file = read(&format!(
            "editors/tree-sitter-linkage/test/corpus/{name}.txt"
        ));
        for (title, text, expected) in cases(&file) {
            let found = tree(text).root_node().to_sexp();
            assert_eq!(found, expected, "{name}: {title}");
            count += 1;
        }
    }
    assert_eq!(count, 16);
}

//! Invisible groups, in which fragments of a `macro_rules` macro arrive.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::diagnostic::Diagnostics;
use crate::syntax::{dump, parse};

fn tokens(source: &str) -> TokenStream {
    source.parse().expect("the source has tokens")
}

/// Replaces each `[...]` by an invisible group.
fn with_invisible_groups(stream: TokenStream) -> TokenStream {
    let replace = |token| match token {
        TokenTree::Group(group) => {
            let delimiter = match group.delimiter() {
                Delimiter::Bracket => Delimiter::None,
                other => other,
            };
            TokenTree::Group(Group::new(delimiter, with_invisible_groups(group.stream())))
        }
        other => other,
    };
    stream.into_iter().map(replace).collect()
}

#[test]
fn invisible_groups_are_opened() {
    for (source, expected) in [
        ("param a = [-3mm];", "param a = (-3mm)"),
        ("param [a] = [3mm] +- [1um];", "param a = 3mm +- 1um"),
        ("param a = [3mm +- 1um];", "param a = 3mm +- 1um"),
        ("param a = [3] mm;", "param a = 3mm"),
        ("let a = 2 * [b + c];", "let a = (2 * (b + c))"),
        ("let a = [[b]].x;", "let a = b.x"),
        (
            "input a = 1 in [0deg..360deg];",
            "input a = 1 in 0deg..360deg",
        ),
        (
            "input a = 1 in [[2 * b]..=[c]] at [omega];",
            "input a = 1 in (2 * b)..c at omega",
        ),
        ("input a = 1 in [2 * b]..[c];", "input a = 1 in (2 * b)..c"),
        ("let a = [(b, c)];", "let a = (b, c)"),
        (
            "torque [a + b] * [mm]^[2] on [b] from [frame];",
            "torque ((a + b) * mm^2) on b from frame",
        ),
        (
            "body a = pin [j] on [b] at [p + q], mass [m * n] at [(0, 1)];",
            "body a = pin j on b at (p + q), mass (m * n) at (0, 1)",
        ),
    ] {
        let stream = with_invisible_groups(tokens(&format!("[pub] struct A {{ {source} }}")));
        let mut diagnostics = Diagnostics::default();
        let definition = parse(stream, &mut diagnostics).pop();
        let definition = definition.expect("a struct block");
        assert!(diagnostics.is_empty(), "{source} {diagnostics:?}");
        assert_eq!(dump(&definition), format!("struct A\n  {expected}\n"));
        assert_eq!(definition.visibility.to_string(), "pub");
    }
}

/// `#[$m]`, and fragments within an attribute.
#[test]
fn invisible_groups_of_attributes_are_opened() {
    for (attribute, name, printed) in [
        ("[doc = \"A link.\"]", "doc", "# [doc = \"A link.\"]"),
        ("[derive(Debug)]", "derive", "# [derive (Debug)]"),
        (
            "derive([std::fmt::Debug], [Hash])",
            "derive",
            "# [derive (std :: fmt :: Debug , Hash)]",
        ),
        (
            "[cfg(all([feature = \"a\"], [[unix]]))]",
            "cfg",
            "# [cfg (all (feature = \"a\" , unix))]",
        ),
        (
            "doc = [concat!(\"a\", \"b\")]",
            "doc",
            "# [doc = concat ! (\"a\" , \"b\")]",
        ),
        (
            "[serde::rename] = \"b\"",
            "rename",
            "# [serde :: rename = \"b\"]",
        ),
    ] {
        // The attribute's own brackets are visible.
        let inside = with_invisible_groups(tokens(attribute));
        let brackets = TokenTree::Group(Group::new(Delimiter::Bracket, inside));
        let mut stream = tokens("#");
        stream.extend([brackets]);
        stream.extend(tokens("struct A { param a = 1mm; }"));
        let mut diagnostics = Diagnostics::default();
        let definition = parse(stream, &mut diagnostics).pop();
        let definition = definition.expect("a struct block");
        assert!(diagnostics.is_empty(), "{attribute} {diagnostics:?}");
        let [found] = &definition.attributes[..] else {
            panic!("{attribute}: one attribute");
        };
        assert_eq!(found.name, name);
        let bare = |text: &str| text.replace(' ', "");
        assert_eq!(bare(&found.tokens.to_string()), bare(printed));
    }
}

//! Grammar, messages, and items that survive a mistake.

mod groups;
mod mechanics;
mod mechanics_messages;
mod messages;

use super::{dump, parse};
use crate::diagnostic::Diagnostics;

/// The tree as text and the messages.
fn read(source: &str) -> (String, Vec<String>) {
    let mut diagnostics = Diagnostics::default();
    let tokens = source.parse().expect("the source has tokens");
    let definition = parse(tokens, &mut diagnostics).pop();
    let messages = diagnostics.texts();
    (definition.as_ref().map(dump).unwrap_or_default(), messages)
}

/// One item, as the tree's text.
fn item(source: &str) -> String {
    let (text, messages) = read(&format!("struct A {{ {source} }}"));
    assert_eq!(messages, Vec::<String>::new(), "{source}");
    text.lines().nth(1).unwrap_or_default().trim().to_owned()
}

#[test]
fn items() {
    for (source, expected) in [
        ("unit mm;", "unit mm"),
        ("const a = 1;", "const a = 1"),
        ("param a = 50mm +- 12um;", "param a = 50mm +- 12um"),
        ("param a = 50mm + - 12um", "param a = 50mm +- 12um"),
        ("param a = 50 mm +/- 12 um;", "param a = 50mm +- 12um"),
        ("param a = (50mm +- 12um);", "param a = 50mm +- 12um"),
        (
            "param a = 1mm + 2mm +- 1um + 2um;",
            "param a = (1mm + 2mm) +- (1um + 2um)",
        ),
        (
            "param a = (1 + 2) * 3 +- 1;",
            "param a = ((1 + 2) * 3) +- 1",
        ),
        ("param a = (1mm, 2mm,);", "param a = (1mm, 2mm)"),
        (
            "param a = (1mm +- 1um, 2mm);",
            "param a = (1mm +- 1um, 2mm)",
        ),
        (
            "param a = (1mm, 2mm) +- 1um;",
            "param a = (1mm, 2mm) +- 1um",
        ),
        ("param a = sqrt(2 + -1);", "param a = sqrt((2 + (-1)))"),
        ("param unit = 1;", "param unit = 1"),
        ("input a = 30deg;", "input a = 30deg"),
        ("input a = 30 in 0..360;", "input a = 30 in 0..360"),
        (
            "input a = 30deg in -0deg..=720deg;",
            "input a = 30deg in (-0deg)..720deg",
        ),
        ("unknown a = (1, 2);", "unknown a = (1, 2)"),
        ("unknown a;", "unknown a"),
        ("loop a + b = c;", "loop (a + b) = c"),
        ("/// Words.\n let a = b;", "let a = b"),
    ] {
        assert_eq!(item(source), expected, "{source}");
    }
}

#[test]
fn expressions() {
    for (source, expected) in [
        ("a + b * c - d", "((a + (b * c)) - d)"),
        ("a - b - c / d / e", "((a - b) - ((c / d) / e))"),
        ("-a * -b", "((-a) * (-b))"),
        ("-a.x", "(-a.x)"),
        ("(a + b).x", "(a + b).x"),
        ("a + -b", "(a + (-b))"),
        ("a +-b", "(a + (-b))"),
        ("f(a, b,)", "f(a, b)"),
        ("f()", "f()"),
        ("f(q, [a, b.x,])", "f(q, [a, b.x])"),
        ("v(p)[1][0]", "v(p)[1][0]"),
        ("(a, b, c)", "(a, b, c)"),
        ("(a,)", "(a)"),
        ("((a))", "a"),
        ("1_000.5e-3mm", "1000.5e-3mm"),
        ("2. * 5µm", "(2. * 5µm)"),
        ("3 turn / 2", "(3turn / 2)"),
        ("3 * mm ^ 2 / s^-1", "((3 * mm^2) / s^-1)"),
        ("-mm^2 * a", "((-mm^2) * a)"),
    ] {
        assert_eq!(
            item(&format!("let z = {source};")),
            format!("let z = {expected}")
        );
    }
}

#[test]
fn functions() {
    let (text, messages) = read(
        "/// Doc.\n #[derive(Debug)] pub(crate) struct A { }
         impl A { /// Path.\n pub fn path(phi,) -> Path { p, v: velocity(p), } fn none() -> N { p } }
         impl A { fn more(a, b) -> M { x: 1 } }",
    );
    assert_eq!(messages, Vec::<String>::new());
    let expected = "struct A\nfn path(phi) -> Path\n  p: p\n  v: velocity(p)\nfn none() -> N\n  \
                    p: p\nfn more(a, b) -> M\n  x: 1\n";
    assert_eq!(text, expected);
}

#[test]
fn the_rest_survives_a_mistake() {
    let source = "struct A { param a = ; param aa = input x = 3; param b = 3mm parma c = 1; param d = 4mm let e = a; }
                  impl A { fn f(x) -> F { a, b: +, c: d } fn g( -> G {} }";
    let source = source.replace("fn g( -> G {}", "fn g() { } fn h() -> H { e }");
    let (text, messages) = read(&source);
    let expected = "struct A\n  param a = <error>\n  param aa = <error>\n  input x = 3\n  param b = 3mm\n  param d = 4mm\n  let e = a\n\
                    fn f(x) -> F\n  a: a\n  b: <error>\n  c: d\nfn h() -> H\n  e: e\n";
    assert_eq!(text, expected, "{messages:#?}");
    assert_eq!(messages.len(), 6, "{messages:#?}");
}

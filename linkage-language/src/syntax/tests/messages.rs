//! Every message of the parser, once.

use super::read;

/// Source of the whole with its messages, facts and helps.
pub(super) fn check(source: &str, expected: &[&str]) {
    let (_, messages) = read(source);
    assert_eq!(messages.len(), expected.len(), "{source}: {messages:#?}");
    for (message, expected) in messages.iter().zip(expected) {
        assert!(
            message.contains(expected),
            "{source}:\n{message}\nlacks\n{expected}"
        );
    }
}

#[test]
fn expressions() {
    for (value, expected) in [
        ("1.mm", "help: write `1mm` or `1.0mm`"),
        (".5mm", "help: write `0.5mm`"),
        (
            "1,5mm",
            "the number `1,5mm` has a decimal comma\nhelp: the decimal sign is a point: write `1.5mm`",
        ),
        ("f(1) + (1 + 2,5)[0](2)", "expected `;`, found `(`"),
        ("2x", "; a product is written `2 * x`"),
        ("2x", "unknown unit `x`\nhelp: units are m mm "),
        ("3Nmm", "unknown unit `Nmm`\nhelp: write `3N*mm`"),
        ("3mm2", "unknown unit `mm2`\nhelp: write `3 * mm^2`"),
        (
            "3lbs",
            "unknown unit `lbs`\nhelp: write `3lb` for a mass, `3lbf` for a force",
        ),
        ("3feet", "unknown unit `feet`\nhelp: write `3ft`"),
        ("3bar", "unknown unit `bar`\nhelp: write `3 * 0.1MPa`"),
        (
            "if x { 1 }",
            "found keyword `if`\nhelp: there are no cases here: decide outside",
        ),
        ("3sec", "help: write `3s` for time, `3arcsec` for an angle"),
        (
            "3mm^2",
            "a number with a unit has no powers\nhelp: write `3 * mm^2`",
        ),
        (
            "3mm^-2",
            "a number with a unit has no powers\nhelp: write `3 * mm^-2`",
        ),
        ("3 mm^a", "help: write `3 * mm^2`"),
        (
            "3^2",
            "there is no operator for powers\nhelp: write `a * a` for a square",
        ),
        (
            "mm^a",
            "there is no operator for powers\nhelp: write `a * a` for a square; units have whole exponents up to 9: `mm^2`",
        ),
        ("mm^10", "units have whole exponents"),
        ("mm^2mm", "units have whole exponents"),
        (
            "mm^2^2",
            "there is no operator for powers\nhelp: write `a * a` for a square",
        ),
        ("f(x)^2", "there is no operator for powers"),
        ("12in", "unknown unit `in`\nhelp: write `12inch`"),
        ("45deg30arcmin", "help: write `45deg + 30arcmin`"),
        ("0x10mm", "`0x10mm` is not a decimal number"),
        (
            "1f32",
            "the type suffix `f32` has no meaning here\nhelp: write `1`",
        ),
        ("\"3\"", "expected a number, found `\"3\"`"),
        (
            "a^1.5",
            "there is no operator for powers\nhelp: write `a * a` for a square",
        ),
        ("a ** 2", "there is no operator for powers"),
        ("a % b", "expected `;`, found `%`"),
        (
            "2 x",
            "expected `;`, found `x`\nhelp: write `2 * x` for a product",
        ),
        ("(a)(b)", "help: write `(...) * (...)` for a product"),
        (
            "1 2",
            "help: write `1 +- 2` for a tolerance, `1 * 2` for a product",
        ),
        ("a as f64", "help: leave the conversion out"),
        (
            "v.norm()",
            "there are no methods here, only functions\nhelp: write `norm(...)`",
        ),
        (
            "v.0",
            "expected a component after `.`, found `0`\nhelp: components are `.x`, `.y` and `.z`",
        ),
        ("v.type", "found keyword `type`"),
        ("v[0, 1]", "expected one index"),
        ("v[]", "expected one index"),
        ("()", "expected an expression between `(` and `)`"),
        ("{ 1 }", "expected an expression, found `{`"),
        ("+a", "help: leave the sign `+` out"),
        ("std::f64::consts::PI", "a path cannot stand here"),
        ("self", "expected an expression, found keyword `self`"),
        ("a +/- b", "a tolerance cannot stand here"),
        ("", "expected an expression, found `;`"),
        (".", "expected an expression, found `.`"),
        ("a -> b", "expected an expression, found `>`"),
        ("f(a b)", "expected `,` or `)`, found `b`"),
        ("= a", "expected `=`, found `==`"),
    ] {
        check(
            &format!("struct A {{ let z ={value}; let y = 1; }}"),
            &[expected],
        );
    }
}

#[test]
fn deep_expressions() {
    let nested = format!("{}1{}", "(".repeat(200), ")".repeat(200));
    let signs = format!("{}1", "-".repeat(200));
    let chain = format!("1{}", " + 1".repeat(2000));
    let fields = format!("a{}", ".x".repeat(2000));
    for (value, expected) in [
        (nested, "nested more than 64 levels deep"),
        (signs, "nested more than 64 levels deep"),
        (chain, "more than 1000 operators"),
        (fields, "more than 1000 operators"),
    ] {
        check(&format!("struct A {{ let z = {value}; }}"), &[expected]);
    }
}

#[test]
fn items() {
    for (item, expected) in [
        (
            "parm a = 1;",
            "expected an item, found `parm`\nhelp: did you mean `param`?",
        ),
        (
            "42;",
            "expected an item, found `42`\nhelp: items are unit const param",
        ),
        ("gear a = 1;", "help: did you mean `gears`?"),
        ("point p = polar(1, 30deg);", "help: did you mean `let`?"),
        ("dimension a = 1;", "help: did you mean `param`?"),
        (
            "hinge a = b on c at d;",
            "expected an item, found `hinge`\nhelp: did you mean `pin`?",
        ),
        (
            "argument load;",
            "expected `=`, found `;`\nhelp: the value says its dimension: `argument load = 100N;`",
        ),
        ("fn f() {}", "help: functions belong in the `impl` block"),
        ("pub param a = 1;", "help: leave `pub` out"),
        (
            "param type = 1;",
            "`type` is a keyword of Rust and cannot be a name\nhelp: choose another name, like `type_`",
        ),
        ("param _ = 1;", "help: choose a name"),
        (
            "param r#type = 1;",
            "the raw identifier `r#type` cannot be a name",
        ),
        ("param 3 = 1;", "expected a name after `param`, found `3`"),
        ("let (a, b) = 1;", "expected a name after `let`, found `(`"),
        ("param a: f64 = 1;", "help: leave the type out"),
        ("param a 1;", "expected `=`, found `1`"),
        ("param a = 1 let b = 1;", "the item lacks its `;`"),
        ("param a = 1 +- 2 +- 3;", "a second tolerance"),
        ("param a = (1 +- 2, 3) +- 4;", "a second tolerance"),
        (
            "param a = ((1 +- 1, 2), 3);",
            "a component cannot be a vector",
        ),
        (
            "param a = ();",
            "expected an expression between `(` and `)`",
        ),
        ("param a = 1 +- ;", "expected an expression, found `;`"),
        ("const a = 1mm +- 2mm;", "a tolerance cannot stand here"),
        ("unknown a = 1 +-2;", "a tolerance cannot stand here"),
        ("input a = 1 +- 2 in 0..3;", "a tolerance cannot stand here"),
        (
            "input a = 1 in 0;",
            "expected `..` between the ends of the range, found `;`",
        ),
        ("input a = 1 in 0..;", "the range has no upper end"),
        (
            "input a = 1 in 0deg to 360deg;",
            "found `to`\nhelp: write both ends with `..` between them: `in 0deg..360deg`",
        ),
        (
            "input a = 1 in (0deg, 360deg);",
            "help: write both ends with `..` between them: `in 0deg..360deg`",
        ),
        (
            "unit 3;",
            "expected a length unit, found `3`\nhelp: write `unit mm;`",
        ),
        ("loop a == b;", "expected `=`, found `==`\nhelp: write `=`"),
        ("loop a;", "expected `=`, found `;`"),
        ("loop { a = b }", "`loop` is an equation here"),
        (
            "#[allow(x)] let a = 1;",
            "attribute `allow` on `let` has no effect",
        ),
        (
            "#![allow(x)] let a = 1;",
            "an inner attribute cannot stand here",
        ),
        ("# let a = 1;", "expected `[` after `#`"),
        ("#[] let a = 1;", "the attribute has no name"),
    ] {
        check(&format!("struct A {{ {item} let y = 1; }}"), &[expected]);
    }
}

#[test]
fn functions() {
    for (function, expected) in [
        ("f(a) -> F { a }", "expected a function, found `f`"),
        ("fn f -> F { a }", "expected `(` after `f`"),
        (
            "fn f(&self) -> F { a }",
            "help: list the inputs only: `(phi)`",
        ),
        ("fn f(a: f64) -> F { a }", "help: leave the type out"),
        ("fn f(a b) -> F { a }", "expected `,` or `)`, found `b`"),
        ("fn f(a) { a }", "expected `->` after `f(...)`"),
        ("fn f(a) -> Vec<F> { a }", "expected `{` after `Vec`"),
        ("fn f(a) -> F { }", "the function `f` has no quantity"),
        ("fn f(a) -> F;", "expected `{` after `F`"),
        (
            "fn f(a) -> F { norm(a) }",
            "the quantity has no field name\nhelp: write `norm: ...`",
        ),
        (
            "fn f(a) -> F { a.x }",
            "the quantity has no field name\nhelp: write `a_x: a.x` or",
        ),
        (
            "fn f(a) -> F { a; b }",
            "help: quantities are separated by commas",
        ),
        ("fn f(a) -> F { a b }", "expected `,`, found `b`"),
        (
            "fn f(a) -> F { #[x] a }",
            "attribute `x` on a quantity has no effect",
        ),
        ("fn f(a) -> F { type: a }", "`type` is a keyword"),
    ] {
        check(
            &format!("struct A {{ }} impl A {{ {function} fn g() -> G {{ y }} }}"),
            &[expected],
        );
    }
}

#[test]
fn blocks() {
    for (source, expected) in [
        ("", "there is no struct block"),
        (
            "impl A {}",
            "there is no struct block\nhelp: write `pub struct NAME { ... }`",
        ),
        (
            "enum A {}",
            "expected `struct NAME { ... }`, found keyword `enum`",
        ),
        ("struct A<T> { }", "help: leave the type parameters out"),
        (
            "struct A<'a> { let b = 1; }",
            "found `<`\nhelp: write `A` alone: a mechanism borrows nothing",
        ),
        ("struct A;", "expected `{` after `A`, found `;`"),
        (
            "struct A {} struct Bar {} impl Baz {}",
            "there is no struct `Baz` in this call\nhelp: did you mean `impl Bar`?",
        ),
        (
            "struct A {} impl B {}",
            "the struct is named `A`, its `impl` block `B`\nhelp: write `impl A`",
        ),
        (
            "struct A {} fn f() {}",
            "expected `impl NAME { ... }` or another `struct NAME { ... }`, found keyword `fn`",
        ),
        (
            "struct A {} #[inline] impl A {}",
            "attribute `inline` on `impl` has no effect",
        ),
    ] {
        check(source, &[expected]);
    }
}

//! Every message about items and functions, once.

use super::check;
use super::dimensions::NAMES;

#[test]
fn items() {
    for (items, expected) in [
        (
            "param l = 2mm;",
            &["the name `l` is defined twice", "`l` is first defined here"][..],
        ),
        (
            "param __l = 2mm;",
            &["the name `__l` starts with `__`, which generated code uses\nhelp: write `l`"],
        ),
        (
            "unit m;",
            &["a second `unit`", "`unit` is first given here"],
        ),
        (
            "loop l = a;",
            &["the sides of the loop differ: a length = an angle"],
        ),
        (
            "loop p = l;",
            &["the sides of the loop differ: a plane vector of lengths = a length"],
        ),
        (
            "loop later = l; let later = k;",
            &["`later` is used before its definition\nhelp: move the definition of `later` up"],
        ),
        (
            "const one = two; const two = 2;",
            &["`two` is used before its definition"],
        ),
        ("const one = one;", &["`one` is used in its own definition"]),
        (
            "const one = l;",
            &[
                "`l` is a parameter, which cannot be used here\nhelp: a constant may use numbers, functions and constants only",
            ],
        ),
        ("param one = k;", &["help: a value or tolerance may use"]),
        (
            "param one = 1mm +- k;",
            &["help: a value or tolerance may use"],
        ),
        (
            "input one = l;",
            &["help: the reference and range of an input may use"],
        ),
        (
            "unknown one = b;",
            &["`b` is an input, which cannot be used here\nhelp: an estimate may use"],
        ),
        (
            "param one = 1mm +- 1deg;",
            &["the nominal value is a length, its tolerance an angle"],
        ),
        (
            "param one = (1mm, 2mm) +- 1;",
            &["the nominal value is a length, its tolerance a number"],
        ),
        (
            "param one = 1mm +- (1um, 2um);",
            &["a length cannot have a plane vector of lengths as tolerance"],
        ),
        (
            "param one = 1mm +- -1um;",
            &["the tolerance -1um is negative\nhelp: write `+- 1um`"],
        ),
        (
            "param one = (1mm +- 1um, 2deg);",
            &["the components of a vector differ"],
        ),
        (
            "input one = (1mm, 2mm);",
            &["an input is an angle or a length, found a plane vector of lengths"],
        ),
        (
            "input one = 1mm * 2mm;",
            &["an input is an angle or a length, found a length^2"],
        ),
        (
            "input one = 1mm in 0deg..1deg;",
            &["the reference and the range of an input differ in dimension"],
        ),
        (
            "unknown one = l * k;",
            &["an unknown is an angle or a length, found a length^2"],
        ),
        (
            "let one = nope; loop one = l; let two = one.x;",
            &["unknown name `nope`"],
        ),
    ] {
        check(&format!("struct A {{ {NAMES} {items} }}"), expected);
    }
    check(
        "struct A { unit mn; }",
        &["`mn` is not a length unit\nhelp: did you mean"],
    );
    check(
        "struct A { unit deg; }",
        &["`deg` is not a length unit\nhelp: length units are m mm cm um inch"],
    );
    check("struct __ { }", &["starts with `__`"]);
}

#[test]
fn powers_of_length_are_limited() {
    let mut source = "struct A { param a0 = 1mm; ".to_owned();
    source.push_str("let b0 = a0 * a0; ");
    for index in 1..40 {
        source.push_str(&format!("let b{index} = b{} * b{}; ", index - 1, index - 1));
    }
    check(&(source + "}"), &["the power of length is beyond 32"]);
}

#[test]
fn functions() {
    for (functions, expected) in [
        (
            "fn f(b) -> F { p } fn f(b) -> G { p }",
            &[
                "the function `f` is named twice",
                "`f` is first defined here",
            ][..],
        ),
        (
            "fn f(b) -> F { p } fn g(b) -> F { p }",
            &["the result type `F` is named twice", "`F` is first"],
        ),
        (
            "fn f(b) -> F { p } fn f_sweep(b) -> G { p }",
            &["the function `f_sweep` is also generated for `f`"],
        ),
        (
            "fn f_sweep_into(b) -> G { p } fn f(b) -> F { p }",
            &["the function `f_sweep_into` is also generated for `f`"],
        ),
        (
            "fn f(b) -> A { p }",
            &["the result type `A` has the name of the mechanism"],
        ),
        (
            "fn f(b) -> AAssembly { p }",
            &["has the name of the assembly of `A`"],
        ),
        (
            "fn f(b) -> F { p } fn g(b) -> FColumns { p }",
            &["the type `FColumns` is also generated for sweeps of `f`"],
        ),
        ("fn __f(b) -> F { p }", &["the name `__f` starts with"]),
        ("fn f(b) -> F { __p: p }", &["the name `__p` starts with"]),
        (
            "fn f(bb) -> F { v: velocity(p) }",
            &["unknown input `bb`\nhelp: inputs are `b`"],
        ),
        (
            "fn f(phi) -> F { p }",
            &["unknown input `phi`\nhelp: inputs are `b`"],
        ),
        ("fn f(l) -> F { p }", &["`l` is a parameter, not an input"]),
        (
            "fn f(b, b) -> F { v: velocity(p) }",
            &["the input `b` is listed twice"],
        ),
        (
            "fn f(b) -> F { p, p: q }",
            &["the field `p` is listed twice", "`p` is first defined here"],
        ),
        ("fn f(b) -> F { w: p, v: norm(w) }", &["unknown name `w`"]),
    ] {
        check(
            &format!("struct A {{ {NAMES} }} impl A {{ {functions} }}"),
            expected,
        );
    }
    check(
        "struct A { param l = 1; } impl A { fn f(b) -> F { l } }",
        &["help: the mechanism has no input: write `()`"],
    );
    check(
        "struct A { input phi = 1; } impl A { fn f(phy) -> F { phi } }",
        &["help: did you mean `phi`?"],
    );
}

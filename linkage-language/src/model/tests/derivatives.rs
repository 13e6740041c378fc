//! Quantities that only functions know.

use super::dimensions::NAMES;
use super::{check, model};
use crate::model::dump;

fn with_function(inputs: &str, quantity: &str) -> String {
    let more = "input e = 1mm; let h = polar(l, b) + (e, 0);";
    format!("struct A {{ {NAMES} {more} }} impl A {{ fn f({inputs}) -> F {{ x: {quantity} }} }}")
}

#[test]
fn types() {
    for (inputs, quantity, expected) in [
        ("b", "velocity(h)", "a plane vector of lengths"),
        ("e", "velocity(h)", "a plane vector of numbers"),
        ("b", "acceleration(a * b)", "a number"),
        ("e", "jerk(norm(h))", "a length^-2"),
        ("b, e", "velocity(norm(h))", "[a length, a number]"),
        (
            "b, e",
            "acceleration(norm(h))",
            "[[a length, a number], [a number, a length^-1]]",
        ),
        ("b, e", "velocity(h)[1].x", "a number"),
        ("b, e", "acceleration(l)[0][1]", "a number"),
        ("b", "d(h, l)", "a plane vector of numbers"),
        ("b", "d(h, q.x, b)", "a plane vector of numbers"),
        ("b", "1 / d(a, b)", "a number"),
        (
            "b",
            "sensitivity(h, [l, a, q])",
            "[a plane vector of numbers, a plane vector of lengths, a plane vector of numbers, a plane vector of numbers]",
        ),
        ("b", "sensitivity(velocity(l), [l])", "[a number]"),
        ("b", "sensitivity(l, [q.y])[0]", "a number"),
        ("b", "velocity(sensitivity(l, [q.y]))", "[a number]"),
        ("b", "norm(velocity(h))", "a length"),
        ("", "d(l, k)", "a number"),
        ("", "margin()", "a number"),
        ("", "0", "a number"),
        ("b", "velocity(0)", "a number"),
    ] {
        let (mechanism, messages) = model(&with_function(inputs, quantity));
        let mechanism = mechanism.unwrap_or_else(|| panic!("{quantity}: {messages:#?}"));
        let text = dump(&mechanism);
        assert!(
            text.trim_end().ends_with(&format!(": {expected}")),
            "{quantity}: {text}"
        );
    }
}

#[test]
fn messages() {
    for (inputs, quantity, expected) in [
        (
            "",
            "velocity(h)",
            "`velocity` in a function without an input\nhelp: list the input: `fn name(b)`",
        ),
        (
            "b, e",
            "jerk(h)",
            "`jerk` needs one input, the function has 2",
        ),
        (
            "b",
            "velocity()",
            "`velocity` takes 1 argument, found 0\nhelp: write `velocity(quantity)`",
        ),
        (
            "b",
            "margin(b)",
            "`margin` takes no argument, found 1\nhelp: write `margin()`",
        ),
        ("b", "d()", "`d` takes 2 arguments, found 0"),
        (
            "b",
            "d(h)",
            "`d` takes a quantity and one or two variables, found no variable",
        ),
        ("b", "d(h, b, b, b)", "found 3 variables"),
        (
            "b",
            "d(h, c)",
            "derivative with respect to `c`, a constant\nhelp: variables are `b`, `e`, `l`, `k`, `a`, `n`, `p.x`",
        ),
        ("b", "d(h, 3)", "derivative with respect to a constant"),
        ("b", "d(h, PI)", "derivative with respect to a constant"),
        (
            "b",
            "d(h, zero)",
            "derivative with respect to `zero`, an unknown",
        ),
        (
            "b",
            "d(h, h)",
            "derivative with respect to `h`, a derived quantity",
        ),
        (
            "b",
            "d(h, l + k)",
            "derivative with respect to an expression",
        ),
        (
            "b",
            "d(h, dir(b).x)",
            "derivative with respect to an expression",
        ),
        (
            "b",
            "d(h, p)",
            "derivative with respect to `p`, a vector\nhelp: name a component, like `p.x`",
        ),
        (
            "b",
            "d(h, p.z)",
            "`p`, a plane vector of lengths, has no component `z`\nhelp: components are `.x`, `.y`",
        ),
        (
            "b",
            "d(h, l.x)",
            "`l`, a length, has no component `x`\nhelp: write `l`",
        ),
        (
            "b",
            "d(h, zerro)",
            "unknown name `zerro`\nhelp: did you mean `zero`?",
        ),
        ("b", "sensitivity()", "found no argument"),
        ("b", "sensitivity(h, l)", "expected a list of parameters"),
        ("b", "sensitivity(h, [])", "the list of parameters is empty"),
        (
            "b",
            "sensitivity(h, [p, p.x])",
            "a parameter is listed twice",
        ),
        (
            "b",
            "sensitivity(h, [b])",
            "a sensitivity is with respect to parameters, found an input\nhelp: write `d(q, x)`",
        ),
        (
            "b",
            "sensitivity(h) + h",
            "an array of 16 entries cannot be used in an expression\nhelp: take one entry: `[0]`",
        ),
        ("b", "-sensitivity(h)", "cannot be used in an expression"),
        (
            "b",
            "norm(sensitivity(h))",
            "cannot be used in an expression",
        ),
        (
            "b",
            "(sensitivity(l), 1)",
            "cannot be used in an expression",
        ),
        ("b", "sensitivity(h).x", "cannot be used in an expression"),
        (
            "b",
            "sensitivity(h)[16]",
            "entry 16 of an array of 16 entries\nhelp: write a number from 0 to 15",
        ),
        ("b", "sensitivity(h)[l]", "an index must be a whole number"),
        (
            "b",
            "sensitivity(h)[1mm]",
            "an index must be a whole number",
        ),
        (
            "b",
            "sensitivity(sensitivity(sensitivity(sensitivity(h))))",
            "an array of 65536 entries, more than 10000",
        ),
    ] {
        check(&with_function(inputs, quantity), &[expected]);
    }
    let source = "struct A { param l = 1; } impl A { fn f() -> F { v: velocity(l) } }";
    check(source, &["help: declare an `input` in the struct block"]);
    let source = "struct A { const c = 1; } impl A { fn f() -> F { v: sensitivity(c) } }";
    check(source, &["`sensitivity` in a mechanism without parameters"]);
    let source = "struct A { const c = 1; } impl A { fn f() -> F { v: d(c, c) } }";
    check(source, &["help: declare an `input` or a `param`"]);
}

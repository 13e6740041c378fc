//! Units as factors, forces and times where they do not belong, arguments.

use super::{check, model};
use crate::model::{ExprKind, Mechanism};

fn resolved(items: &str) -> Mechanism {
    let (mechanism, messages) = model(&format!("struct A {{ {items} }}"));
    mechanism.unwrap_or_else(|| panic!("{messages:#?}"))
}

/// A derived quantity that is one number, and the text of its type.
fn number(unit: &str, text: &str) -> (f64, String) {
    let mechanism = resolved(&format!("unit {unit}; let a = {text};"));
    let value = &mechanism.lets[0].value;
    match &value.kind {
        ExprKind::Number(number) => (*number, value.ty.to_string()),
        ExprKind::Negate(inner) => match inner.kind {
            ExprKind::Number(number) => (-number, value.ty.to_string()),
            _ => panic!("{text}: {value:?}"),
        },
        _ => panic!("{text}: {value:?}"),
    }
}

#[test]
fn a_number_and_its_units_are_rounded_once() {
    for (unit, text, expected, words) in [
        ("mm", "129.94g", 0.12994, "a mass"),
        ("inch", "129.94g", 0.12994, "a mass"),
        ("mm", "49663.7g*mm^2", 49.6637, "a moment of inertia"),
        ("m", "49663.7g*mm^2", 49.6637e-6, "a moment of inertia"),
        ("mm", "2.5N/mm", 2.5, "a stiffness"),
        ("m", "2.5N/mm", 2500.0, "a stiffness"),
        ("mm", "9.80665m/s^2", 9806.65, "an acceleration"),
        ("inch", "25.4mm*mm", 25.4 / 645.16, "a length^2"),
        ("inch", "645.16 * mm^2", 1.0, "a length^2"),
        ("m", "1inch*inch", 0.00064516, "a length^2"),
        ("mm", "3kg*m*s^-2", 3000.0, "a force"),
        ("mm", "3J", 3000.0, "a moment"),
        ("m", "3kW", 3000.0, "a power"),
        ("mm", "7MPa", 7.0, "a pressure"),
        ("mm", "3min", 180.0, "a time"),
        ("mm", "6 / min", 0.1, "a frequency"),
        (
            "mm",
            "60turn/min",
            std::f64::consts::TAU,
            "an angular speed",
        ),
        ("mm", "180 / deg * deg", 180.0, "an angle"),
        ("mm", "90 / deg", 16200.0 / std::f64::consts::PI, "a number"),
        ("inch", "56lb", 25.40117272, "a mass"),
        ("mm", "83lbf", 369.2023940666215, "a force"),
        ("inch", "1lbf*ft", 53.378659383126, "a moment"),
        ("m", "1psi", 6894.757293168362, "a pressure"),
        ("inch", "1psi", 4.4482216152605, "a pressure"),
        ("inch", "1lbf/inch^2", 4.4482216152605, "a pressure"),
        ("mm", "1ft", 304.8, "a length"),
        ("inch", "1ft", 12.0, "a length"),
        ("m", "32 * ft/s^2", 9.7536, "an acceleration"),
        ("mm", "60rpm", std::f64::consts::TAU, "an angular speed"),
        ("mm", "30 * rpm", std::f64::consts::PI, "an angular speed"),
        ("mm", "-3N*(mm*s)", -3.0, "a damping of rotation"),
        ("mm", "0.2N/(mm/s)", 0.2, "a damping"),
        ("mm", "mm * 3", 3.0, "a length"),
        ("mm", "cm * N", 10.0, "a moment"),
    ] {
        assert_eq!(
            number(unit, text),
            (expected, words.to_owned()),
            "{text} in {unit}"
        );
    }
}

#[test]
fn units_beside_names() {
    let dump =
        |items: &str| crate::model::dump(&resolved(&format!("unit mm; param r = 3; {items}")));
    assert!(dump("let a = r * cm;").contains("let a = (r * 10.0): a length\n"));
    assert!(
        dump("let a = r * N / (r * cm^2);")
            .contains("let a = ((r * 1.0) / (r * 100.0)): a pressure\n")
    );
    assert!(dump("let a = 2 * 3 * mm;").contains("let a = ((2.0 * 3.0) * 1.0): a length\n"));
    // A name of the mechanism hides the unit.
    assert!(dump("let mm = 7; let a = 2 * mm;").contains("let a = (2.0 * mm): a number\n"));
    let (_, messages) = model("struct A { let a = 2 * mm; let mm = 7; }");
    assert!(
        messages[0].contains("`mm` is used before its definition"),
        "{messages:#?}"
    );
}

#[test]
fn misplaced_units() {
    for (item, message) in [
        (
            "let a = mm;",
            "unknown name `mm`\nhelp: write the unit as a factor: `1 * mm`",
        ),
        (
            "let a = 3mm + mm;",
            "unknown name `mm`\nhelp: write the unit as a factor: `1 * mm`",
        ),
        (
            "let a = sin(deg);",
            "unknown name `deg`\nhelp: write the unit as a factor: `1 * deg`",
        ),
        // A name of an angle, as a rule.
        (
            "let psi = 3deg; let a = psi^2;",
            "there is no operator for powers, but of units: `psi` is a derived quantity\nhelp: write `psi * psi` for a square",
        ),
        (
            "let a = mm^2;",
            "the unit `mm^2` without a number\nhelp: write `1 * mm^2`",
        ),
        (
            "let a = 3 + mm^2;",
            "the unit `mm^2` without a number\nhelp: write `1 * mm^2`",
        ),
        (
            "param r = 3; let a = r^2;",
            "there is no operator for powers, but of units: `r` is a parameter\nhelp: write `r * r` for a square",
        ),
        ("let a = 2 * x^2;", "unknown name `x`"),
        (
            "let a = 1e300 * m^9 * m^9;",
            "the number with its units is too large for a 64-bit number",
        ),
        (
            "let a = 3m*m^9*m^9*m^9*m^9;",
            "the number with its units is in a power of a unit beyond all use",
        ),
        (
            "let a = 3turn*turn^9*turn^9*turn^9*turn^9*turn^9*turn^9*turn^9*turn^9;",
            "beyond all use",
        ),
    ] {
        check(&format!("struct A {{ unit um; {item} }}"), &[message]);
    }
}

#[test]
fn forces_and_times_do_not_move_anything() {
    for (item, message) in [
        (
            "input phi = 3N;",
            "an input is an angle or a length, found a force",
        ),
        (
            "input phi = 3rad/s;",
            "an input is an angle or a length, found an angular speed",
        ),
        (
            "unknown x = 3s;",
            "an unknown is an angle or a length, found a time",
        ),
        (
            "unknown x = 3deg; loop 3N * x = 2N;",
            "a loop is about lengths and angles, found a force on both sides",
        ),
    ] {
        check(&format!("struct A {{ {item} }}"), &[message]);
    }
}

#[test]
fn dimensions_of_mechanics_in_messages() {
    for (item, message) in [
        ("let a = 3N + 2kg;", "cannot add a force and a mass"),
        (
            "let a = 3N*mm + 2N/mm;",
            "cannot add a moment and a stiffness",
        ),
        (
            "let a = (3m/s, 1N);",
            "differ in dimension: a speed and a force",
        ),
        (
            "let a = 3N*N + 2kg/mm;",
            "cannot add a force^2 and a mass*length^-1",
        ),
        (
            "param m = 3kg +- 5mm;",
            "the nominal value is a mass, its tolerance a length",
        ),
    ] {
        check(&format!("struct A {{ {item} }}"), &[message]);
    }
    // Kilograms and newtons are units of one dimension.
    check(
        "struct A { param mass = 3kg +- 1N*s^2/m; let a = 3kg*m/s^2 + 1N; }",
        &[],
    );
    check(
        "struct A { param m = 3kg +- 1N*s^2/m; let a = 3kg*m/s^2 + 1N; }",
        &[
            "`m` is a parameter, which cannot be used here\nhelp: a value or tolerance may use numbers, functions and constants only; the name hides the unit `m`",
            "cannot add a force^2*length^-2*time^2 and a force\nhelp: `m` is a parameter here, not the unit",
        ],
    );
}

#[test]
fn arguments() {
    let function = "impl A { fn f(phi, press) -> F { a: press * dir(phi) } }";
    let items = "input phi = 3deg at omega, epsilon; const C = 2; argument press = C * 250N; param r = 3; unknown x = 2deg;";
    for (more, messages) in [
        ("let load = press * r;", &[][..]),
        (
            "loop x = phi * (press / 1N);",
            &[
                "a loop depends on the argument `press`\nhelp: nothing that moves depends on arguments: declare a `param` or an `input`",
            ],
        ),
        (
            "let a = press / 1N; let b = 2 * a; loop x = b;",
            &["a loop depends on the argument `press`"],
        ),
        (
            "loop x = omega * 1s;",
            &["a loop depends on the argument `omega`"],
        ),
        (
            "param m = press;",
            &["`press` is an argument, which cannot be used here"],
        ),
        (
            "unknown y = press;",
            &["`press` is an argument, which cannot be used here"],
        ),
        (
            "input y = 2 * press;",
            &["`press` is an argument, which cannot be used here"],
        ),
        (
            "argument y = r;",
            &[
                "`r` is a parameter, which cannot be used here\nhelp: the value of an argument may use numbers",
            ],
        ),
        (
            "argument y = (1N, 2N);",
            &[
                "an argument is a scalar, found a plane vector of forces\nhelp: declare one argument for each component",
            ],
        ),
        (
            "let omega = 3;",
            &[
                "the name `omega` is defined twice",
                "`omega` is first defined here",
            ],
        ),
        (
            "input y = 3mm at press;",
            &[
                "the name `press` is defined twice",
                "`press` is first defined here",
            ],
        ),
    ] {
        check(
            &format!("struct A {{ {items} {more} }} {function}"),
            messages,
        );
    }
}

#[test]
fn functions_list_arguments() {
    let items = "input phi = 3deg at omega, epsilon; input s = 3mm at v; argument press = 500N;";
    for (function, messages) in [
        ("fn f(press, s, omega) -> F { a: press * omega }", &[][..]),
        (
            "fn f(pres) -> F { a: 1 }",
            &["unknown input `pres`\nhelp: did you mean `press`?"],
        ),
        (
            "fn f(press, press) -> F { a: press }",
            &["the input `press` is listed twice"],
        ),
        (
            "fn f(omega) -> F { a: velocity(phi) }",
            &["`velocity` in a function without an input\nhelp: list the input: `fn name(phi)`"],
        ),
        ("fn f(phi, omega) -> F { a: velocity(phi * omega) }", &[]),
        (
            "fn f(phi, omega) -> F { a: d(phi * omega, omega) }",
            &["derivative with respect to `omega`, an argument"],
        ),
        (
            "fn f(phi, press) -> F { a: sensitivity(press, [press]) }",
            &["a sensitivity is with respect to parameters, found an argument"],
        ),
    ] {
        check(
            &format!("struct A {{ {items} param r = 3; }} impl A {{ {function} }}"),
            messages,
        );
    }
    let (mechanism, _) = model(&format!(
        "struct A {{ {items} }} impl A {{ fn f(s, press, v, phi) -> F {{ a: s, b: velocity(s) }} }}"
    ));
    let mechanism = mechanism.expect("it resolves");
    let function = &mechanism.evaluators[0];
    assert_eq!(function.inputs, [1, 5, 4, 0]);
    assert_eq!(mechanism.input_name(5), "press");
    assert_eq!(
        function.quantities[1].value.ty.to_string(),
        "an array of 2 entries"
    );
}

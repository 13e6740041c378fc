//! Operands that can be added, multiplied and passed.

use super::model;
use crate::model::{Mechanism, dump};

/// Names for the cases: lengths `l k`, angles `a b`, number `n`, plane vectors `p q`, numbers `u`,
/// space vectors `s t`.
pub(super) const NAMES: &str = "unit mm; param l = 1mm; param k = 2mm; param a = 1deg; \
    input b = 1rad; param n = 2; param p = (1mm, 2mm); param q = (3mm, 4mm); param u = (1, 2); \
    param s = (1mm, 2mm, 3mm); param t = (1, 2, 3); unknown zero = 0; const c = 3mm;";

pub(super) fn with_let(value: &str) -> String {
    format!("struct A {{ {NAMES} let value = {value}; }}")
}

fn last_line(mechanism: &Mechanism) -> String {
    dump(mechanism)
        .lines()
        .last()
        .unwrap_or_default()
        .to_owned()
}

#[test]
fn types_of_expressions() {
    for (value, expected) in [
        ("l + k", "a length"),
        ("l * k", "a length^2"),
        ("l / k", "a number"),
        ("1 / l", "a length^-1"),
        ("sqrt(l)", "a length^(1/2)"),
        ("sqrt(l * k)", "a length"),
        ("a + b", "an angle"),
        ("a + PI / 2", "an angle"),
        ("2 * a", "an angle"),
        ("a + n", "an angle"),
        ("a / b", "a number"),
        ("l * a", "a length"),
        ("p + q", "a plane vector of lengths"),
        ("p * n", "a plane vector of lengths"),
        ("l * u", "a plane vector of lengths"),
        ("p / l", "a plane vector of numbers"),
        ("-p", "a plane vector of lengths"),
        ("p.x", "a length"),
        ("s.z", "a length"),
        ("(l, 0)", "a plane vector of lengths"),
        ("(0, 0)", "a plane vector of zeros"),
        ("-0.0", "zero"),
        ("0 * l", "a length"),
        ("0 + p", "a plane vector of lengths"),
        ("p - (0, 0)", "a plane vector of lengths"),
        ("(0, 0, 0) + s", "a space vector of lengths"),
        ("polar(l, a)", "a plane vector of lengths"),
        ("polar(0, 0)", "a plane vector of numbers"),
        ("polar(n, 0.5rad)", "a plane vector of numbers"),
        ("dir(b)", "a plane vector of numbers"),
        ("rotate(p, a)", "a plane vector of lengths"),
        ("turn(s, t, a)", "a space vector of lengths"),
        ("dot(p, q)", "a length^2"),
        ("dot(s, t)", "a length"),
        ("cross(p, q)", "a length^2"),
        ("cross(s, t)", "a space vector of lengths"),
        ("norm(p)", "a length"),
        ("distance(p, q)", "a length"),
        ("distance(p, 0)", "a length"),
        ("unit(s)", "a space vector of numbers"),
        ("angle(p - q)", "an angle"),
        ("triangle_angle(l, k, 3mm)", "an angle"),
        ("sin(a) + cos(0.3rad) + tan(b)", "a number"),
        ("asin(n) + acos(0) + atan(l / k)", "an angle"),
        ("atan2(l, k)", "an angle"),
        ("hypot(l, 0)", "a length"),
        ("abs(a)", "an angle"),
        ("min(l, max(k, 0))", "a length"),
        ("PI", "a number"),
        ("zero + a", "an angle"),
        ("c + l", "a length"),
    ] {
        let (mechanism, messages) = model(&with_let(value));
        let mechanism = mechanism.unwrap_or_else(|| panic!("{value}: {messages:#?}"));
        let line = last_line(&mechanism);
        assert!(line.ends_with(&format!(": {expected}")), "{value}: {line}");
    }
}

#[test]
fn bare_zero_beside_a_vector_becomes_a_vector() {
    let source = format!("struct A {{ {NAMES} loop p - q = 0; }}");
    let (mechanism, messages) = model(&source);
    let mechanism = mechanism.unwrap_or_else(|| panic!("{messages:#?}"));
    let expected = "loop (p - q) = (0.0, 0.0): a plane vector of lengths";
    assert_eq!(last_line(&mechanism), expected);
}

#[test]
fn user_names_win() {
    let source =
        "struct A { const PI = 3; param d = 1mm; param norm = 2mm; param dot = d + norm; }";
    let (_, messages) = model(source);
    assert_eq!(
        messages.len(),
        2,
        "defaults cannot use parameters: {messages:#?}"
    );
    let source = "struct A { const PI = 3mm; param d = PI; param norm = (d0, PI); const d0 = 1mm; }
                  impl A { fn f() -> F { x: d(norm(norm), d), d, norm } }";
    let (mechanism, messages) = model(source);
    assert!(mechanism.is_some(), "{messages:#?}");
}

#[test]
fn declared_zeros_fit_their_use() {
    let source = "struct A { param r = 1mm; param e = 0; param o = (0, 0); param lift = 1deg;
        param ratio = 0; param x = 0; param y = 0; input s = 0; unknown theta = 0; unknown slide = 0;
        loop o + polar(r, theta + lift) + (x, y) = (s + ratio * r, e) + (slide, 0); }";
    let (mechanism, messages) = model(source);
    let mechanism = mechanism.unwrap_or_else(|| panic!("{messages:#?}"));
    let dimension = |index: usize| mechanism.parameters[index].ty.to_string();
    assert_eq!(dimension(1), "a length");
    assert_eq!(dimension(2), "a plane vector of lengths");
    assert_eq!(dimension(4), "a number");
    assert_eq!([dimension(5), dimension(6)], ["a length"; 2]);
    assert_eq!(mechanism.inputs[0].dimension.to_string(), "a length");
    assert_eq!(mechanism.unknowns[0].ty.to_string(), "a number");
    assert_eq!(mechanism.unknowns[1].ty.to_string(), "a length");
}

#[test]
fn unknowns_without_an_estimate_fit_their_use() {
    let source = "struct A { param r = 1mm; input phi = 30deg; unknown theta; unknown slide; unknown apex; unknown ball; unknown n;
        loop polar(r, phi) + polar(2 * r, theta) = (slide, 0);
        loop distance(apex, (slide, 0)) = r; loop distance(apex, (0, 0)) = r;
        loop ball = (r, slide, r); loop norm(n) = 1; loop dot(n, (1, 0, 0)) = 0; loop dot(n, (0, 1, 1)) = 0.1; }";
    let (mechanism, messages) = model(source);
    let mechanism = mechanism.unwrap_or_else(|| panic!("{messages:#?}"));
    let types: Vec<String> = mechanism
        .unknowns
        .iter()
        .map(|unknown| unknown.ty.to_string())
        .collect();
    let expected = [
        "a number",
        "a length",
        "a plane vector of lengths",
        "a space vector of lengths",
        "a space vector of numbers",
    ];
    assert_eq!(types, expected);
}

//! Numbers without a unit: refused as angles, fine as numbers.

use super::{check, model};

/// In a mechanism with the angles `a` and `b`, the length `l` and the number `n`.
fn with_names(items: &str) -> String {
    format!(
        "struct A {{ unit mm; param l = 2mm; param a = 3deg; param n = 2; input b = 1deg; {items} }}"
    )
}

#[test]
fn angles_have_a_unit() {
    let reference = "the reference of the angle `t` has no unit: `30` would be 30 rad\n\
                     help: write `30deg`, or `30rad`";
    for (items, expected) in [
        ("input t = 30; let p = polar(l, t);", &[reference][..]),
        ("input t = 30; let p = rotate((l, l), -t);", &[reference]),
        (
            "input t = 30; let p = turn((l, 0, 0), (0, 0, 1), t + a);",
            &[reference],
        ),
        ("input t = 30; let c = cos(2 * t / 3 - b);", &[reference]),
        ("input t = 30; let c = sin(n * t);", &[reference]),
        ("input t = 30; let u = t + b;", &[reference]),
        ("input t = 30; let u = min(t, b);", &[reference]),
        (
            "input t = 30; let u = 2 * t; let v = -u; let p = polar(l, v);",
            &[reference],
        ),
        (
            "input t = 30; unknown x = 5deg; loop x = n * t;",
            &[reference],
        ),
        (
            "input t = 30; unknown x = 0; loop x = n * t; let p = dir(x);",
            &[reference],
        ),
        (
            "input t = 30deg in 0..360;",
            &["the upper end of the range of the angle `t` has no unit: `360` would be 360 rad"],
        ),
        ("input t = 30 in 0deg..360deg;", &[reference]),
        (
            "input t = 0 in -(180)..180; let p = polar(l, t);",
            &[
                "the lower end of the range of the angle `t` has no unit: `-180` would be -180 rad\n\
             help: write `-180deg`, or `-180rad`",
                "the upper end of the range of the angle `t`",
            ],
        ),
        (
            "unknown x = -40.5; loop polar(l, x) = (l, 0);",
            &[
                "the estimate of the angle `x` has no unit: `-40.5` would be -40.5 rad\n\
             help: write `-40.5deg`, or `-40.5rad`",
            ],
        ),
        (
            "unknown x = 40; loop x + b = a;",
            &["the estimate of the angle `x`"],
        ),
        (
            "let p = polar(l, 30);",
            &["the angle of `polar` has no unit: `30` would be 30 rad"],
        ),
        (
            "let p = dir(-(0.5));",
            &["the angle of `dir` has no unit: `-0.5` would be -0.5 rad"],
        ),
        (
            "let p = rotate((l, l), 90);",
            &["the angle of `rotate` has no unit"],
        ),
        (
            "let p = turn((l, l, l), (0, 0, 1), 90);",
            &["the angle of `turn` has no unit"],
        ),
        (
            "let s = sin(1) + cos(-2) + tan(3);",
            &[
                "the angle of `sin` has no unit: `1` would be 1 rad",
                "the angle of `cos` has no unit: `-2` would be -2 rad",
                "the angle of `tan` has no unit: `3` would be 3 rad",
            ],
        ),
    ] {
        check(&with_names(items), expected);
    }
}

#[test]
fn numbers_have_none() {
    for items in [
        "let p = polar(l, 0) + rotate((l, 0), PI / 2) + dir(l / l) * l + polar(l, 2 * 0.5);",
        "let s = sin(0.0) + cos(-(0)) + asin(0.5) + acos(0.1) + atan(3) + tan(n);",
        // Numbers that angles are computed with.
        "input t = 0.25 in 0..1; let p = polar(l, 2 * PI * t);",
        "input t = 0.25 in 0..1; let p = polar(l, 360deg * t);",
        "const full = 2 * PI; input t = 0.25 in 0..1; let p = polar(l, full * t + b);",
        "input t = 0.25 in 0..1; let p = polar(t * l, b);",
        "input t = 0.25 in 0..1; let p = (t * l, (1 - t) * l) + polar(l, t * b);",
        "input t = 0.25; input u = 4; let p = polar(l, t * u) + polar(l, t / u);",
        "input t = 0.25; let p = polar(l, asin(t));",
        "unknown x = 2; loop x * l = 3 * l;",
        // Zero is the same in every unit.
        "input t = 0 in 0..0; unknown x = 0; loop x = t + b; let p = dir(x + 2 * PI);",
        "input t = PI / 6 in -PI..PI; unknown x = PI / 3; loop x = t + b;",
    ] {
        let (mechanism, messages) = model(&with_names(items));
        assert!(mechanism.is_some(), "{items}: {messages:#?}");
    }
}

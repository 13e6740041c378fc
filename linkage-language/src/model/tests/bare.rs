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

#[test]
fn lengths_that_lack_their_unit() {
    for (items, expected) in [
        (
            "param crank = 50; let q = polar(crank, b) + polar(l, a);",
            &["`50` has no unit, but `crank` is used as a length\nhelp: write `50mm`"][..],
        ),
        (
            "param crank = 50 +- 0.1; loop polar(crank / n, b) + polar(l, a) = (l, 0);",
            &["help: write `50mm`, and give the tolerance a unit, too"],
        ),
        (
            "param frame = (140, -2.5, 0); let p = (l, l, l) - frame;",
            &[
                "`(140, -2.5, 0)` has no unit, but `frame` is used as a length\nhelp: write `(140mm, -2.5mm, 0)`",
            ],
        ),
        (
            "const frame = (140, 0); let foot = 2 * frame; loop rotate(foot, b) = (l, l);",
            &["`(140, 0)` has no unit, but `frame` is used as a length"],
        ),
        (
            "unknown s = 150; unknown t = 10deg; loop polar(l, b) + polar(3 * l, t) = (s, 0);",
            &["`150` has no unit, but `s` is used as a length\nhelp: write `150mm`"],
        ),
        (
            "input s = 150 in 100..200; let p = (s, l);",
            &["help: write `150mm`, and give the range a unit, too"],
        ),
        // Each is noticed when the one before has its unit.
        (
            "param c = 5; param d = 6; param e = 7; param k = 3;
          loop polar(c, b) + polar(d, k * b) = (l, 0) + e * dir(b);",
            &[
                "`5` has no unit, but `c` is",
                "`6` has no unit, but `d` is",
                "`7` has no unit, but `e` is",
            ],
        ),
        (
            "param c = 5; param e = 0; let v = (c, e) + (l, l); let w = (e, l);",
            &["`5` has no unit, but `c` is"],
        ),
        (
            "param c = 5; loop dot((l, c), (l, c)) = c * c;",
            &["`5` has no unit, but `c` is"],
        ),
        (
            "param c = 5; let body = frame((c, 0, 0), (1, 0, 0), (0, 1, 0));",
            &["`5` has no unit, but `c` is"],
        ),
        (
            "param c = 5; body link = pin on frame at (c, 0), turns b;",
            &["`5` has no unit, but `c` is"],
        ),
        // A direction is a vector of numbers.
        (
            "unknown u = (0, 0.7, 0.6); loop norm(u) = 1mm;",
            &["the sides of the loop differ: a number = a length"],
        ),
        // A number as well as a length: where they meet is the only place that can be named.
        (
            "param c = 5; let u = c + l; let v = c * b; let w = c + a;",
            &["cannot add a number and a length"],
        ),
        (
            "param c = 5; param d = 6; let u = c * d + l;",
            &["cannot add a number and a length"],
        ),
        ("let u = 5 + l;", &["help: give the number its unit: `5mm`"]),
    ] {
        check(&with_names(items), expected);
    }
}

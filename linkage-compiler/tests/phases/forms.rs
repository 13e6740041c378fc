//! Groups are recognised by their mathematics: one mechanism, many ways to write its loops.

use linkage_compiler::trace::{Trace, trace};

/// Compiles loops around a crank.
fn traced(items: &str) -> Trace {
    let text = format!(
        "pub struct M {{
            unit mm;
            param a = 40mm; param b = 120mm; param c = 80mm; param d = 100mm; param e = 7mm;
            param lift = 25deg;
            input phi = 40deg in 0deg..80deg;
            {items}
        }}"
    );
    trace(text.parse().expect("tokens"))
}

/// The groups found, or the messages.
fn groups(items: &str) -> Vec<String> {
    let trace = traced(items);
    if !trace.messages.is_empty() {
        return trace.messages;
    }
    let found = trace
        .structure
        .lines()
        .filter(|line| line.starts_with("loops"));
    found.map(str::to_owned).collect()
}

#[track_caller]
fn expect(items: &str, expected: &[&str]) {
    assert_eq!(groups(items), expected, "{items}");
}

const ANGLES: &str = "unknown t = 20deg; unknown p = 57deg;";

#[test]
fn two_links() {
    for loops in [
        "loop polar(a, phi) + polar(b, t) = (d, 0) + polar(c, p);",
        "loop dir(phi) * a + dir(t) * b = c * dir(p) + (d, 0mm);",
        "loop 0 = polar(a, phi) + polar(b, t) - (d, 0) - polar(c, p);",
        "loop (d, 0) - polar(a, phi) = -polar(c, p) + b * dir(t);",
        "loop polar(a, phi) + polar(b, t + 0 * p) = (d, 0) + polar(c, p);",
        "let arm = (b, 0mm); loop polar(a, phi) + rotate(arm, t) = (d, 0) + rotate((c, 0), p);",
        "loop polar(a, phi) + polar(b - e, t) + polar(e, t) = (d, 0) + polar(c, p);",
        "loop polar(a, phi) + rotate((0, -b), t + 90deg) = (d, 0) - polar(c, p + 180deg);",
        "let k = t + 90deg; loop polar(a, phi) + polar(b, k - 90deg) = (d, 0) + polar(c, p);",
        "let pin = polar(a, phi) + polar(b, t); let end = pin - polar(c, p); loop end = (d, 0);",
        "loop polar(a, phi) + (b * cos(t), b * sin(t)) = (d + c * cos(p), c * sin(p));",
    ] {
        expect(
            &format!("{ANGLES} {loops}"),
            &["loops 1: two rotors for t, p"],
        );
    }
}

#[test]
fn links_with_offsets_and_mirrored_angles() {
    expect(
        &format!(
            "{ANGLES} loop polar(a, phi) + polar(b, t) + polar(e, t + lift) = (d, 0) + polar(c, p);"
        ),
        &["loops 1: two rotors for t, p"],
    );
    expect(
        "unknown t = -20deg; unknown p = -57deg;
         loop polar(a, phi) + polar(b, -t) = (d, 0) + polar(c, -p);",
        &["loops 1: two rotors for t, p"],
    );
    expect(
        "unknown t = 200deg; unknown p = 57deg;
         loop polar(a, phi) + polar(-b, t) = (d, 0) + polar(c, p);",
        &["loops 1: two rotors for t, p"],
    );
    expect(
        "unknown t = 20deg; unknown r = 37deg;
         loop polar(a, phi) + polar(b, t) = (d, 0) + polar(c, t + r);",
        &["loops 1: two rotors for t, r"],
    );
}

/// Constants, literals, inputs and sums in places where the two components of a vector are built differently.
#[test]
fn offsets_in_all_spellings() {
    for side in ["e", "10mm", "2 * e", "e / 2", "e + 1mm", "-3cm"] {
        for angle in [
            "t",
            "t + lift",
            "t + 5deg",
            "phi + t - 40deg",
            "lift + phi + t - 40deg",
        ] {
            expect(
                &format!(
                    "{ANGLES} loop polar(a, phi) + rotate((b, {side}), {angle}) = (d, 0) + polar(c, p);"
                ),
                &["loops 1: two rotors for t, p"],
            );
        }
    }
    for loops in [
        "loop polar(a, phi) + polar(b, t + lift) + polar(10mm, t + 2 * lift) = (d, 0) + polar(c, p);",
        "loop polar(a, phi) + polar(b, t) + polar(e, t + lift) + polar(3mm, t - lift) = (d, 0) + polar(c, p);",
        "loop polar(a, phi) + polar(b, t) = (d, 0) + rotate(rotate((c, 10mm), lift), p - 20deg);",
    ] {
        expect(
            &format!("{ANGLES} {loops}"),
            &["loops 1: two rotors for t, p"],
        );
    }
    expect(
        "unknown t = 20deg; input s = 110mm; loop distance(rotate((b, 10mm), t + lift), (d, d)) = s;",
        &["loops 1: two rotors for t"],
    );
    expect(
        "unknown bend = 130deg; unknown s = 90mm;
         loop (d, 0) + polar(e, phi + bend + lift) + polar(s, phi + bend) = polar(a, phi);",
        &["loops 1: slide on rotor for bend, s"],
    );
    expect(
        "param n = 2; unknown t = 80deg; loop t / n = phi;",
        &["loops 1: relation for t"],
    );
}

#[test]
fn loops_by_components_points_and_distances() {
    for loops in [
        "loop a * cos(phi) + b * cos(t) = d + c * cos(p); loop a * sin(phi) + b * sin(t) = c * sin(p);",
        "loop a * sin(phi) + b * sin(t) = c * sin(p); loop d + c * cos(p) - b * cos(t) = a * cos(phi);",
    ] {
        expect(
            &format!("{ANGLES} {loops}"),
            &["loops 1 2: two rotors for t, p"],
        );
    }
    expect(
        &format!(
            "{ANGLES} unknown q = (150mm, 60mm);
             loop polar(a, phi) + polar(b, t) = q; loop (d, 0) + polar(c, p) = q;"
        ),
        &["loops 1 2: two rotors for t, p, q"],
    );
    expect(
        "unknown q = (150mm, 60mm); loop distance(polar(a, phi), q) = b; loop distance((d, 0), q) = c;",
        &["loops 1 2: two rotors for q"],
    );
    expect(
        "unknown p = 57deg; loop b = distance(polar(a, phi), (d, 0) + polar(c, p));",
        &["loops 1: two rotors for p"],
    );
    expect(
        "unknown p = 57deg; loop b - norm((d, 0) + polar(c, p) - polar(a, phi)) = 0;",
        &["loops 1: two rotors for p"],
    );
}

#[test]
fn a_link_and_a_slide() {
    for (slide, loops) in [
        ("150mm", "loop polar(a, phi) + polar(b, t) = (x, e);"),
        ("-150mm", "loop (-x, e) = polar(b, t) + polar(a, phi);"),
        (
            "150mm",
            "loop polar(a, phi) + polar(b, t) = x * dir(lift) + (e, e);",
        ),
        (
            "-150mm",
            "loop polar(a, phi) + polar(b, t) + polar(x, lift) = (e, e);",
        ),
        (
            "150mm",
            "loop polar(a, phi) + polar(b, t) = unit((3mm, 1mm)) * x + (e, e);",
        ),
        ("75mm", "loop polar(a, phi) + polar(b, t) = x * (2, 0.1);"),
        (
            "150mm",
            "loop polar(a, phi) + polar(b, t) = polar(e, phi) + polar(x, lift - phi / 3);",
        ),
    ] {
        expect(
            &format!("unknown t = -20deg; unknown x = {slide}; {loops}"),
            &["loops 1: rotor and slide for t, x"],
        );
    }
    expect(
        "unknown q = (155mm, 40mm); loop distance(q, polar(a, phi)) = b;
         loop dot(q, dir(lift + 90deg)) = -3 * e;",
        &["loops 1 2: trigonometric for q"],
    );
    expect(
        "unknown q = (150mm, 40mm); loop distance(q, polar(a, phi)) = b;
         loop cross(q - (e, 0), (d, e)) = 0;",
        &["loops 1 2: trigonometric for q"],
    );
    expect(
        "unknown q = (150mm, 7mm); loop q.y = e; loop distance(q, polar(a, phi)) = b;",
        &["loops 1: linear for q", "loops 2: rotor and slide for q"],
    );
}

#[test]
fn a_slide_on_a_turning_link() {
    for (slide, loops) in [
        ("90mm", "loop polar(a, phi) = (d, 0) + polar(s, t);"),
        ("70mm", "loop polar(a, phi) = (d, 0) + rotate((s, e), t);"),
        (
            "70mm",
            "let u = dir(t); loop polar(a, phi) = (d, 0) + s * u + e * rotate(u, 90deg);",
        ),
        (
            "-70mm",
            "loop polar(a, phi) - polar(e, t + 90deg) = (d, 0) - polar(s, t);",
        ),
        (
            "35mm",
            "loop polar(a, phi) = (d, 0) + dir(t) * (2 * s + e);",
        ),
    ] {
        expect(
            &format!("unknown t = 170deg; unknown s = {slide}; {loops}"),
            &["loops 1: slide on rotor for t, s"],
        );
    }
    expect(
        "unknown t = 150deg; unknown p = 175deg; unknown s = 80mm;
         loop p = t + lift;
         loop polar(a, phi) = (d, 0) + polar(s, t) + polar(e, p);",
        &["loops 1 2: slide on rotor for t, p, s"],
    );
}

#[test]
fn two_slides_and_scalar_loops() {
    expect(
        "unknown x = 30mm; unknown y = 25mm; loop (x, y) = polar(a, phi);",
        &["loops 1: two slides for x, y"],
    );
    expect(
        "unknown x = -30mm; unknown y = 25mm; loop (x, 0) + polar(a, phi) = (0, y);",
        &["loops 1: two slides for x, y"],
    );
    expect(
        "unknown t = -20deg; let q = polar(a, phi) + polar(b, t); loop q.y = e;",
        &["loops 1: trigonometric for t"],
    );
    expect(
        "unknown t = -20deg; unknown x = 150mm; let q = polar(a, phi) + polar(b, t);
         loop q.y = e; loop q.x = x;",
        &["loops 1: trigonometric for t", "loops 2: linear for x"],
    );
    expect(
        "unknown x = 150mm; let v = (x, 0) - polar(a, phi); loop dot(v, v) = b * b;",
        &["loops 1: rotor and slide for x"],
    );
    expect(
        "unknown x = 150mm; loop x * x + a * x * cos(phi) = b * b;",
        &["loops 1: quadratic for x"],
    );
    expect(
        "unknown t = 10deg; loop t = phi / 2 - 10deg;",
        &["loops 1: relation for t"],
    );
    expect(
        "unknown t = 60deg; unknown s = -20deg; loop t + s = phi; loop t - s = 2 * phi;",
        &["loops 1 2: relation for t, s"],
    );
    expect(
        "unknown t = 26deg; let q = polar(a, phi) + (d, d); loop t = angle(q);",
        &["loops 1: relation for t"],
    );
}

#[test]
fn groups_come_in_the_order_in_which_they_can_be_solved() {
    expect(
        "unknown g = 20deg; unknown h = 90deg; unknown t = 20deg; unknown p = 57deg;
         let k = (d, 0) + polar(c / 2, p + lift);
         loop k + polar(b, g) = (2 * d, 0) + polar(c, h);
         loop polar(a, phi) + polar(b, t) = (d, 0) + polar(c, p);",
        &[
            "loops 2: two rotors for t, p",
            "loops 1: two rotors for g, h",
        ],
    );
}

#[test]
fn coupled_groups_are_named_by_class() {
    // Three legs on a ternary link.
    let triad = "unknown t1 = 60deg; unknown t2 = 100deg; unknown t3 = 80deg; unknown u = 10deg;
        let p = polar(a, phi) + polar(b, t1);
        loop p + polar(c, u) = (d, 0) + polar(b, t2);
        loop p + polar(c, u + lift) = (d, d) + polar(b, t3);";
    // A closed contour of four links, two of them ternary.
    let tetrad = "unknown t1 = 60deg; unknown t2 = 10deg; unknown t3 = 20deg; unknown t4 = 100deg;
        loop polar(a, phi) + polar(b, t1) + polar(c, t2) = (d, 0) + polar(b, t4);
        loop polar(a, phi) + polar(c, t1 + lift) + polar(c, t3) = (d, 0) + polar(b, t4 - lift);";
    for (text, class) in [
        (triad, "RR-RR-RR, class 3 order 3"),
        (tetrad, "contour of 4, class 4 order 2"),
    ] {
        let found = traced(text).formulate;
        assert!(found.starts_with(class), "{found}");
    }
}

#[test]
fn a_distance_may_be_given_by_another_distance() {
    let point = "unknown p = (70mm, 100mm); let pin = polar(a, phi); let pivot = (d, 0mm);";
    for loops in [
        "loop distance(p, pin) = distance(pivot, (0mm, e)); loop distance(p, pivot) = b;",
        "loop distance(pivot, (0mm, e)) = distance(p, pin); loop b = distance(p, pivot);",
    ] {
        expect(
            &format!("{point} {loops}"),
            &["loops 1 2: two rotors for p"],
        );
    }
}

#[test]
fn what_cannot_be_solved_at_all_is_said_once() {
    for (items, message) in [
        (
            "param n = 0; unknown x = 1mm; loop n * x = a;",
            "it does not change with `x`",
        ),
        (
            "param n = 2; unknown t = 20deg; unknown p = 57deg;
             loop polar(a, t) + polar(b, p) = polar(a * acos(n), phi);",
            "is not a finite number",
        ),
        (
            "unknown t = 20deg; unknown p = 57deg; unknown x = 1mm;
             loop polar(a, t) + polar(a, p) = (9 * d, 0); loop x * cos(t) = a;",
            "cannot close",
        ),
    ] {
        let messages = groups(items);
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert!(messages[0].contains(message), "{messages:?}");
    }
}

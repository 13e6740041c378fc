//! Axes of `turn` and arguments of `unit` that are zero, axes of frames that are zero or parallel: found where their numbers are known, and only there.

use linkage_compiler::trace::trace;

/// The messages for a loop of which `vector` is the axis.
fn messages(vector: &str) -> Vec<String> {
    let text = format!(
        "pub struct M {{
            unit mm;
            const zero = (0, 0, 0);
            const a = (0.1, 0.2, 0.3);
            const b = 3 * a;
            param l = 20mm;
            param none = (0, 0, 0);
            param p = (1mm, 2mm, 3mm);
            param q = (1mm, 2mm, 3mm);
            input phi = 30deg;
            input s = 10mm in 5mm..15mm;
            unknown psi = 15deg;
            let normal = cross(a, b);
            let slide = (s - 10mm) * a;
            let turned = turn(l * (1, 1, 0), {vector}, phi);
            loop dot(turned, (cos(psi), sin(psi), 1)) = 0.9 * l;
        }}"
    );
    trace(text.parse().expect("tokens")).messages
}

#[test]
fn what_is_zero_is_reported() {
    for (vector, fact, help) in [
        (
            "(0, 0, 0)",
            ": it is (0, 0, 0)",
            "write a direction such as `(0, 0, 1)`, of any length",
        ),
        ("zero", ": `zero` is (0, 0, 0)", "write a direction"),
        ("-none / 2", ": `none` is (0, 0, 0)", "write a direction"),
        (
            "cross(a, b)",
            ": it is `cross` of parallel vectors, (0.1, 0.2, 0.3) and (0.3, 0.6, 0.9)",
            "choose vectors that are not parallel",
        ),
        (
            "2 * normal",
            ": `normal` is `cross` of parallel vectors",
            "choose",
        ),
        (
            "p - q",
            ": it is the difference of equal vectors, (1mm, 2mm, 3mm)",
            "choose vectors that differ from each other",
        ),
        (
            "q.x * (q - q)",
            ": it is the difference of equal vectors",
            "choose",
        ),
        ("cross(zero, a)", ": it is (0, 0, 0)", "write"),
        (
            "l * sin(180deg) * a",
            ": it is (0mm, 0mm, 0mm)",
            "give it a length",
        ),
        ("(cos(90deg), 0, 0)", ": it is (0, 0, 0)", "write"),
        (
            "a + b - 4 * a",
            ": it is the difference of equal vectors",
            "choose",
        ),
        (
            "turn(p, a, phi) - turn(p, a, phi)",
            ": it is the difference of equal vectors\n",
            "choose",
        ),
        (
            "slide",
            " at the reference input `phi = 30deg`, `s = 10mm`: `slide` is (0mm, 0mm, 0mm)",
            "choose a reference input at which it has a direction",
        ),
    ] {
        let found = messages(vector);
        let [message] = &found[..] else {
            panic!("{vector}: {found:#?}");
        };
        let start = "the axis of `turn` has no direction";
        assert!(
            message.starts_with(&format!("{start}{fact}")),
            "{vector}: {message}"
        );
        assert!(
            message.contains(&format!("\nhelp: {help}")),
            "{vector}: {message}"
        );
    }
    let unit = messages("unit(p - q)");
    assert!(
        unit[0].starts_with("the vector of `unit` has no direction"),
        "{unit:#?}"
    );
}

#[test]
fn what_has_a_direction_is_not() {
    for vector in [
        "(0, 0, 1e-12)",
        "(1e-12, 1e-30, 0)",
        "a",
        "p - 1.000001 * q",
        "cross(a, (0.1, 0.2, 0.30001))",
        "p - 2 * s * a",
        "(cos(psi), sin(psi), 0)",
        "(psi - psi, 1, 0)",
    ] {
        let found = messages(vector);
        let reported = found.iter().any(|m| m.contains("no direction"));
        assert!(!reported, "{vector}: {found:#?}");
    }
}

/// The messages about a frame with these directions, the angle `psi` unknown.
fn messages_of_frame(x: &str, z: &str) -> Vec<String> {
    let text = format!(
        "pub struct M {{
            const a = (0.1, 0.2, 0.3);
            param p = (1m, 2m, 3m);
            input s = 10mm in 5mm..15mm;
            unknown psi = 15deg;
            let body = frame(p, {x}, {z});
            loop body.origin.x * cos(psi) + body.y.x * s = 0.9 * p.x;
        }}"
    );
    trace(text.parse().expect("tokens")).messages
}

#[test]
fn parallel_axes_are_reported() {
    for (x, z, expected) in [
        (
            "(0, 0, 0)",
            "a",
            "the x axis of `frame` has no direction: it is (0, 0, 0)",
        ),
        (
            "a",
            "p - p",
            "the z axis of `frame` has no direction: it is",
        ),
        (
            "a",
            "-3 * a",
            "the z axis of `frame` is parallel to its x axis, (0.1, 0.2, 0.3) and (-0.3, -0.6, -0.9)\nhelp",
        ),
        (
            "p",
            "a",
            "is parallel to its x axis, (1m, 2m, 3m) and (0.1, 0.2, 0.3)\nhelp: choose another vector",
        ),
        (
            "(0.01m, 0.01m, s)",
            "(1, 1, 1)",
            "at the reference input `s = 0.01m`, (0.01m, 0.01m, 0.01m) and (1, 1, 1)\nhelp: choose a reference input",
        ),
    ] {
        let found = messages_of_frame(x, z);
        let [message] = &found[..] else {
            panic!("{x} {z}: {found:#?}");
        };
        assert!(message.contains(expected), "{x} {z}: {message}");
    }
    for (x, z) in [
        ("a", "(0.1, 0.2, 0.30001)"),
        ("(1e-9, 0, 0)", "(1e-9, 1e-12, 0)"),
        ("(cos(psi), sin(psi), 0)", "(cos(psi), sin(psi), 0)"),
        ("(0.01m, 0.01m, 1.001 * s)", "(1, 1, 1)"),
    ] {
        let found = messages_of_frame(x, z);
        let reported = found.iter().any(|m| m.contains("axis of"));
        assert!(!reported, "{x} {z}: {found:#?}");
    }
}

#[test]
fn guides_and_axes_of_joints() {
    let messages = |joint: &str, load: &str| {
        let text = format!(
            "pub struct M {{
                unit mm;
                const zero = (0, 0, 0);
                input phi = 30deg;
                let p = (20mm * cos(phi), 20mm * sin(phi), 0mm);
                body wheel = pin j on frame at (0mm, 0mm, 0mm) about (0, 0, 1), turns phi;
                body part = {joint};
                force {load} on part at p;
            }}
            impl M {{ fn f(phi) -> R {{ r: unit(reaction(j)), t: torque(phi) }} }}"
        );
        trace(text.parse().expect("tokens")).messages
    };
    let (fixed, load) = ("fixed on wheel at p", "(1N, 0N, 0N)");
    let none = messages(fixed, load);
    assert!(none.is_empty(), "{none:#?}");
    for (joint, load, expected) in [
        (
            "slide on wheel at p along zero",
            load,
            "the guide of a `slide` has no direction: `zero` is (0, 0, 0)\nhelp: write a direction",
        ),
        (
            "pin on wheel at p about (0, 0, 0), turns 0deg",
            load,
            "the axis of a joint has no direction: it is (0, 0, 0)",
        ),
        (
            fixed,
            "3N * unit(zero)",
            "the vector of `unit` has no direction: `zero` is (0, 0, 0)",
        ),
    ] {
        let found = messages(joint, load);
        assert!(found.iter().any(|m| m.contains(expected)), "{found:#?}");
    }
}

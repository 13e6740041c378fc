//! Groups in space are recognised by their mathematics: one mechanism, many ways to write its loops.

use linkage_compiler::trace::trace;

/// The groups found, whether they close or not; without any, the messages.
fn groups(items: &str) -> Vec<String> {
    let text = format!(
        "pub struct M {{
            unit mm;
            param a = 40mm; param l = 160mm; param r = 90mm; param tilt = 25deg; param swing = 10deg;
            param pivot = (110mm, 20mm, 15mm); param k = (0.3, -0.2, 1);
            input phi = 40deg;
            let pin = (a * cos(phi), a * sin(phi), 0mm);
            let axis = turn(turn((0, 0, 1), (0, 1, 0), tilt), (1, 0, 0), swing);
            {items}
        }}"
    );
    let trace = trace(text.parse().expect("tokens"));
    let found = trace.structure.lines();
    let found: Vec<&str> = found.filter(|line| line.starts_with("loops")).collect();
    match found.is_empty() {
        true => trace.messages,
        false => found.into_iter().map(str::to_owned).collect(),
    }
}

#[track_caller]
fn expect(items: &str, expected: &[&str]) {
    assert_eq!(groups(items), expected, "{items}");
}

#[test]
fn a_link_to_a_rocker() {
    for end in [
        "let end = pivot + turn((r, 0, 0), axis, psi);",
        "let end = pivot + turn((r, 2mm, 7mm), k, psi - 30deg);",
        "let end = pivot - turn(turn((0, r, 0), axis, phi), axis, -psi);",
        "let end = pivot + turn((0, 50mm, 10mm), (1, 1, 0), psi);",
        "let end = turn((7mm, 50mm, 10mm), (1, -3, 0.7), psi);",
        "let end = pivot + (r * cos(psi), 0mm, r * sin(psi));",
        "let up = cross(axis, (1, 0, 0)); let over = cross(up, axis);
         let end = pivot + r * (unit(over) * cos(psi) + unit(up) * sin(psi));",
    ] {
        for equation in [
            "loop distance(pin, end) = l;",
            "loop l = norm(end - pin);",
            "loop distance(end, pin) - l = 0;",
            "loop dot(end - pin, end - pin) = l * l;",
            "loop sqrt(dot(end - pin, end - pin)) = l;",
            "loop distance(pin, end) / l = 1;",
            "loop 2 * distance(pin, end) = l + l;",
            "loop l * l - dot(pin - end, pin - end) = 0;",
            "loop distance(pin, end) + a - l = a * cos(phi);",
            "loop l - a = 2 * a - (distance(pin, end) + r);",
            "loop dot(end - pin, end - pin) + a * a - l * l = 0;",
            "let v = end - pin; loop v.x * v.x + v.y * v.y + v.z * v.z = l * l;",
        ] {
            expect(
                &format!("unknown psi = 80deg; {end} {equation}"),
                &["loops 1: link to rotor for psi"],
            );
        }
        expect(
            &format!(
                "unknown psi = 80deg; unknown c = (50mm, 80mm, 30mm); {end}
                 loop pin + c = end; loop norm(c) = l;"
            ),
            &["loops 1 2: link to rotor for psi, c"],
        );
        expect(
            &format!(
                "unknown psi = 80deg; unknown n = (0.3, 0.8, 0.5); {end}
                 loop pin + l * n = end; loop norm(n) = 1;"
            ),
            &["loops 1 2: link to rotor for psi, n"],
        );
    }
}

#[test]
fn a_rocker_on_a_moving_body() {
    // The axis turns with an unknown angle found before.
    expect(
        "unknown psi = 80deg; unknown chi = 20deg;
         loop distance(pin, pivot + turn((r, 0, 0), axis, psi)) = l;
         let moving = (cos(psi), sin(psi), 0);
         loop distance(pin + (0, 0, 3 * r), turn((r, 1mm, 2mm), moving, chi)) = 2 * l;",
        &[
            "loops 1: link to rotor for psi",
            "loops 2: link to rotor for chi",
        ],
    );
    // What has no circle is solved as a polynomial.
    expect(
        "unknown psi = 80deg;
         loop distance(pin, pivot + (r * cos(psi), 2 * r * sin(psi), 0)) = l;",
        &["loops 1: coupled for psi"],
    );
}

#[test]
fn a_choice_is_no_circle() {
    // Twice as wide as high for most `r`, whatever it is where lengths are tried.
    for end in [
        "let end = pivot + (max(r, 2mm) * cos(psi), 2mm * sin(psi), 0mm);",
        "let end = pivot + (r * cos(psi), min(r, 200mm) * sin(psi), 0mm);",
    ] {
        expect(
            &format!("unknown psi = 80deg; {end} loop distance(pin, end) = l;"),
            &["loops 1: coupled for psi"],
        );
    }
    expect(
        "unknown psi = 80deg; let end = pivot + (-r * cos(psi), abs(r) * sin(psi), 0mm);
         loop distance(pin, end) = l;",
        &["loops 1: link to rotor for psi"],
    );
    // A root that is not defined for all lengths.
    expect(
        "unknown psi = 80deg; let end = pivot + turn((sqrt(r * r - a * a), 0mm, 0mm), axis, psi);
         loop distance(pin, end) = l;",
        &["loops 1: link to rotor for psi"],
    );
}

#[test]
fn a_link_to_a_slide() {
    for equation in [
        "loop distance(pin, pivot + s * axis) = l;",
        "loop norm(pin - pivot - 2 * s * k) = l;",
        "let v = (s, 3mm, 4mm) - pin; loop dot(v, v) = l * l;",
    ] {
        expect(
            &format!("unknown s = 80mm; {equation}"),
            &["loops 1: link to slide for s"],
        );
    }
}

#[test]
fn points() {
    let corner = "let corner = (0, -r, 3mm);";
    for (equations, expected) in [
        (
            "loop distance(p, pin) = l; loop distance(pivot, p) = l; loop norm(corner - p) = l;",
            &["loops 1 2 3: point for p"][..],
        ),
        (
            "loop distance(p, pin) = l; loop dot(p - pivot, p - pivot) = l * l; loop dot(k, p - corner) = 0;",
            &["loops 1 2 3: point for p"],
        ),
        (
            "loop distance(2 * p, pin) = l; loop dot(axis, p) = r; loop dot(k, p - corner) = 0;",
            &["loops 1 2 3: point for p"],
        ),
        (
            "loop p.z = 20mm; loop distance(p, pin) = l; loop distance(p, corner) = l;",
            &["loops 1: linear for p", "loops 2 3: point for p"],
        ),
        (
            "loop p.z = 20mm; loop p.x = r; loop distance(p, corner) = l;",
            &[
                "loops 1: linear for p",
                "loops 2: linear for p",
                "loops 3: link to slide for p",
            ],
        ),
    ] {
        let items = format!("unknown p = (40mm, 20mm, 130mm); {corner} {equations}");
        expect(&items, expected);
        let lengths = format!(
            "unknown x = 40mm; unknown y = 20mm; unknown z = 130mm; let p = (x, y, z); {corner} {equations}"
        );
        assert_eq!(groups(&lengths).len(), expected.len(), "{lengths}");
    }
}

#[test]
fn directions() {
    expect(
        "unknown n = (0, 0, 1); loop norm(n) = 1; loop dot(n, axis) = cos(80deg);
         loop dot(n, pin) = a * cos(tilt);",
        &["loops 1 2 3: point for n"],
    );
    // Universal joint and spherical four-bar.
    for angle in ["0", "cos(80deg)"] {
        expect(
            &format!(
                "unknown psi = 80deg; let u = (0, cos(phi), sin(phi));
                 loop dot(u, turn((0, 1, 0.1), axis, psi)) = {angle};"
            ),
            &["loops 1: trigonometric for psi"],
        );
    }
}

#[test]
fn vector_loops() {
    expect(
        "unknown x = 10mm; unknown y = 20mm; unknown z = 30mm;
         loop pin + x * axis + y * k = pivot + z * (0, cos(phi), 1);",
        &["loops 1: three slides for x, y, z"],
    );
    expect(
        "unknown x = 10mm; unknown y = 20mm; unknown z = 30mm;
         let end = pin + x * axis + y * k - z * (0.1, cos(phi), 1);
         loop end.x = r; loop end.y = 0; loop dot(end, k) = a;",
        &["loops 1 2 3: three slides for x, y, z"],
    );
    expect(
        "unknown x = 10mm; unknown y = 20mm; unknown psi = 30deg;
         loop pin + x * axis + y * k = pivot + turn((r, 0, 0), (0, 1, 0), psi);",
        &[
            "loops 1: trigonometric for psi",
            "loops 1: linear for x",
            "loops 1: linear for y",
        ],
    );
    // A guide that turns with the unknown angle, across the other guide.
    expect(
        "unknown x = 10mm; unknown y = 200mm; unknown psi = 30deg;
         loop pin + x * (0, 0, 1) = y * (cos(psi), sin(psi), 0) + r * (-sin(psi), cos(psi), 0.2);",
        &[
            "loops 1: trigonometric for psi",
            "loops 1: linear for x",
            "loops 1: linear for y",
        ],
    );
    // The plane's loops stay what they are.
    expect(
        "unknown t = 30deg; unknown psi = 90deg; unknown z = 10mm;
         loop (pin.x, pin.y) + polar(l, t) = (pivot.x, pivot.y) + polar(r, psi);
         loop distance((0, 0, z), pivot + (0, r * cos(psi), r * sin(psi))) = l;",
        &[
            "loops 1: two rotors for t, psi",
            "loops 2: link to slide for z",
        ],
    );
}

#[test]
fn chains_and_loops_that_must_be_solved_together() {
    expect(
        "unknown psi = 80deg; unknown chi = 100deg;
         let u = pivot + turn((r, 0, 0), axis, psi);
         let v = turn((0, r, 0), k, chi) - pivot;
         loop distance(pin, u) = l;
         loop distance(u, v) = 2 * l;",
        &[
            "loops 1: link to rotor for psi",
            "loops 2: link to rotor for chi",
        ],
    );
    expect(
        "unknown x = 10deg; unknown y = 100deg; unknown z = 200deg;
         let u = pin + turn((r, 0, 0), axis, x);
         let v = pivot + turn((0, r, 0), k, y);
         let w = (0, 0, r) + turn((0, r, 0), (1, 0, 0), z);
         loop distance(u, v) = l; loop distance(v, w) = l; loop distance(w, u) = l;",
        &["loops 1 2 3: coupled for x, y, z"],
    );
}

#[test]
fn the_miss_across_guides_is_a_length() {
    // 100 mm apart along z, of which the lever spans 60, whatever the angle between the guides.
    let text = "pub struct M {
        unit mm;
        input phi = 0.1rad;
        unknown s = 50mm; unknown t = 50mm; unknown psi = 10deg;
        loop s * (1, 0, 0) + t * (cos(phi), sin(phi), 0)
            = (70mm, 20mm, -100mm) + turn((0mm, 60mm, 0mm), (1, 0, 0), psi);
    }";
    let messages = trace(text.parse().expect("tokens")).messages;
    assert!(messages[0].contains("misses by 40mm"), "{messages:?}");
}

#[test]
fn the_miss_of_a_direction_is_a_number() {
    let text = "pub struct M {
        unit mm;
        unknown psi = 10deg; unknown n = (1, 0, 0);
        loop 10mm * n = (150mm, 0mm, 0mm) + (60mm * cos(psi), 60mm * sin(psi), 0mm);
        loop norm(n) = 1;
    }";
    let messages = trace(text.parse().expect("tokens")).messages;
    assert!(messages[0].contains("misses by 8\n"), "{messages:?}");
}

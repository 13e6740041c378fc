//! What messages propose to write, written: the mechanism is then accepted.

use linkage_compiler::check;

fn messages(text: &str) -> Vec<String> {
    let checked = check(text.parse().expect("brackets have partners"));
    checked.messages.into_iter().map(|own| own.text).collect()
}

/// The one message about a mechanism.
fn message(text: &str) -> String {
    match &messages(text)[..] {
        [one] => one.clone(),
        other => panic!("{text}: {other:#?}"),
    }
}

/// What stands in back-ticks in the help of a message.
fn proposed(message: &str) -> Vec<&str> {
    let (_, help) = message.split_once("help:").expect("there is help");
    help.split('`').skip(1).step_by(2).collect()
}

#[test]
fn ranges_in_which_it_works() {
    let four_bar = |crank: u32, coupler: u32, rocker: u32, range: &str| {
        format!(
            "struct M {{ unit mm; input phi = 60deg {range}; unknown theta = 20deg; unknown psi = 70deg;
             loop polar({crank}mm, phi) + polar({coupler}mm, theta) = (100mm, 0) + polar({rocker}mm, psi); }}
             impl M {{ fn f(phi) -> F {{ psi }} }}"
        )
    };
    let slider = |range: &str| {
        format!(
            "struct M {{ unit mm; input s = 66mm {range}; unknown theta = 60deg; unknown t = -80mm;
             loop (s, 20mm) + polar(70mm, theta) = (100mm, -t); }}
             impl M {{ fn f(s) -> F {{ t }} }}"
        )
    };
    let guide = |range: &str| {
        format!(
            "struct M {{ unit mm; input phi = 10deg {range}; unknown theta = 10deg; unknown s = 90mm;
             loop polar(50mm, phi) + (60mm, 0) = polar(s, theta) + polar(20mm, theta + 90deg); }}
             impl M {{ fn f(phi) -> F {{ s }} }}"
        )
    };
    let whole = "in -300deg..400deg";
    type Mechanism<'a> = &'a dyn Fn(&str) -> String;
    let cases: [(Mechanism, &str); 6] = [
        (&|range| four_bar(80, 75, 80, range), whole),
        (&|range| four_bar(20, 120, 30, range), whole),
        (&|range| four_bar(80, 70, 90, range), "in 20deg..400deg"),
        (&|range| four_bar(40, 100, 40, range), "in 20deg..300deg"),
        (&slider, "in 10mm..300mm"),
        (&guide, whole),
    ];
    for (mechanism, range) in cases {
        let message = message(&mechanism(range));
        let proposals = proposed(&message);
        let range = proposals.iter().find(|own| own.starts_with("in "));
        let text = mechanism(range.unwrap_or_else(|| panic!("{message}")));
        assert_eq!(messages(&text), [""; 0], "{text}");
    }
}

#[test]
fn relations_for_a_parallelogram() {
    let mechanism = |unknowns: &str, rest: &str| {
        format!(
            "struct M {{ unit mm; input phi = 60deg in 10deg..300deg; {unknowns}
             {rest} unknown chi = 40deg; unknown s = 150mm;
             loop polar(50mm, psi) + polar(120mm, chi) = (s, 20mm); }}
             impl M {{ fn f(phi) -> F {{ psi, theta, v: velocity(s) }} }}"
        )
    };
    let cases = [
        (
            "unknown theta = 0deg; unknown psi = 70deg;",
            "loop polar(40mm, phi) + polar(100mm, theta) = (100mm, 0) + polar(40mm, psi);",
            ["let theta = 0deg;", "let psi = phi;"],
        ),
        (
            "unknown theta = 50deg; unknown psi = 80deg;",
            "loop polar(40mm, phi) + polar(100mm, theta) = polar(100mm, 30deg) + polar(40mm, psi - 30deg);",
            ["let theta = 30deg;", "let psi = phi + 30deg;"],
        ),
    ];
    for (unknowns, own, expected) in cases {
        let chi = "unknown chi = -20deg;";
        let written = mechanism(unknowns, own).replace("unknown chi = 40deg;", chi);
        let message = message(&written);
        assert!(message.contains("is a parallelogram"), "{message}");
        let proposals = proposed(&message);
        assert_eq!(proposals[..2], expected, "{message}");
        let text = mechanism(&proposals[..2].concat(), "").replace("unknown chi = 40deg;", chi);
        assert_eq!(messages(&text), [""; 0], "{text}");
    }
}

#[test]
fn listed_assemblies() {
    let four_bar = |unknowns: &str| {
        format!(
            "struct M {{ unit mm; input phi = 60deg in 0deg..360deg; {unknowns}
             loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi); }}
             impl M {{ fn f(phi) -> F {{ psi }} }}"
        )
    };
    let tripod = |unknowns: &str| {
        format!(
            "struct M {{ unit inch; param r = 120mm; {unknowns}
             loop distance(tip, (4, 0, 0)) = r; loop distance(tip, (-2, 90mm, 0)) = r;
             loop distance(tip, (-2, -90mm, 0)) = r; }}
             impl M {{ fn f() -> F {{ tip }} }}"
        )
        .replace("(4,", "(4inch,")
        .replace("(-2,", "(-2inch,")
    };
    let platform = |unknowns: &str| {
        format!(
            "struct M {{ unit mm; input phi = 60deg in 50deg..70deg; {unknowns}
             let a = polar(40mm, phi) + polar(50mm, leg_a);
             loop a + polar(60mm, tilt) = (120mm, 0) + polar(50mm, leg_b);
             loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(50mm, leg_c); }}
             impl M {{ fn f(phi) -> F {{ a }} }}"
        )
    };
    type Mechanism<'a> = &'a dyn Fn(&str) -> String;
    let cases: [(Mechanism, &str, usize); 6] = [
        (&four_bar, "unknown theta; unknown psi;", 2),
        (&four_bar, "unknown theta = 20deg; unknown psi = 260deg;", 2),
        (&tripod, "unknown tip;", 2),
        (&tripod, "unknown tip = (0mm, 0mm, 900mm);", 2),
        (
            &platform,
            "unknown tilt; unknown leg_a; unknown leg_b; unknown leg_c;",
            2,
        ),
        (
            &platform,
            "unknown tilt = 20deg; unknown leg_a = 20deg; unknown leg_b = 200deg; unknown leg_c = 290deg;",
            2,
        ),
    ];
    for (mechanism, unknowns, count) in cases {
        let message = message(&mechanism(unknowns));
        let listed = message
            .lines()
            .filter(|line| line.starts_with("    unknown"));
        let listed: Vec<&str> = listed.collect();
        assert_eq!(listed.len(), count, "{message}");
        for unknowns in listed {
            let text = mechanism(unknowns);
            assert_eq!(messages(&text), [""; 0], "{text}");
        }
    }
}

/// The thresholds themselves: what is a little nearer is accepted.
#[test]
fn estimates_at_the_threshold() {
    // The rod lies along the x axis, and the slider at 100mm.
    let slider = |theta: &str, s: &str| {
        let text = format!(
            "struct M {{ unit mm; input y = 0mm; unknown theta = {theta}; unknown s = {s};
             loop (0, y) + polar(100mm, theta) = (s, 60mm); }}
             impl M {{ fn f(y) -> F {{ s }} }}"
        );
        messages(&text)
    };
    let found = 0.6_f64.asin().to_degrees();
    let theta = |by: f64| format!("{}deg", found + by);
    assert_eq!(slider(&theta(59.9), "80mm"), [""; 0]);
    assert_eq!(slider(&theta(-59.9), "80mm"), [""; 0]);
    assert_eq!(slider(&theta(360.0 - 59.9), "80mm"), [""; 0]);
    assert_eq!(slider(&theta(20.0), "129.9mm"), [""; 0]);
    assert_eq!(slider(&theta(20.0), "30.1mm"), [""; 0]);
    for message in [
        slider(&theta(60.1), "80mm"),
        slider(&theta(-60.1), "80mm"),
        slider(&theta(20.0), "130.1mm"),
        slider(&theta(20.0), "29.9mm"),
    ] {
        let [message] = &message[..] else {
            panic!("one message, not {message:#?}");
        };
        assert!(message.contains("from its estimate"), "{message}");
        assert!(message.contains("has two assemblies"), "{message}");
    }
}

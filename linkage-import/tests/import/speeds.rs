//! Several motors with speeds become one motion, compared with circles that are cut.

use std::f64::consts::TAU;

use linkage_engine::Mechanism;

use crate::files::of_text;

/// Two cranks of 1 inch and 0.5 inch whose rods meet, with the attributes of both motors.
fn five_bar(motors: [&str; 2]) -> String {
    let [first, second] = motors;
    let text = format!(
        "<linkage2><program units=\"Inches\"/>\
         <connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" {first}/>\
         <connector id=\"1\" x=\"96\" y=\"0\"/>\
         <connector id=\"2\" x=\"120\" y=\"288\"/>\
         <connector id=\"3\" x=\"192\" y=\"48\"/>\
         <connector id=\"4\" x=\"192\" y=\"0\" anchor=\"true\" input=\"true\" {second}/>\
         <Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link>\
         <Link id=\"1\"><connector id=\"1\"/><connector id=\"2\"/></Link>\
         <Link id=\"2\"><connector id=\"2\"/><connector id=\"3\"/></Link>\
         <Link id=\"3\"><connector id=\"3\"/><connector id=\"4\"/></Link></linkage2>"
    );
    of_text(&text, "five_bar.linkage2").text
}

/// The point left of the way between two centres with these distances from both.
fn cut(a: [f64; 2], b: [f64; 2], radii: [f64; 2]) -> [f64; 2] {
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    let apart = x.hypot(y);
    let along = (apart * apart + radii[0] * radii[0] - radii[1] * radii[1]) / (2.0 * apart);
    let across = (radii[0] * radii[0] - along * along).sqrt();
    let [x, y] = [x / apart, y / apart];
    [a[0] + along * x - across * y, a[1] + along * y + across * x]
}

#[test]
fn motors_run_by_one_time() {
    // Clockwise at 60 degrees per second, counterclockwise at 150.
    let text = five_bar(["rpm=\"10\"", "rpm=\"-25\""]);
    assert!(
        text.contains("    input phi1 = 0deg in 0deg..720deg;\n"),
        "{text}"
    );
    assert!(
        text.contains("    let phi2 = 90deg - 2.5 * phi1;\n"),
        "{text}"
    );
    assert!(
        text.contains("    // The motors run together, as in the file. "),
        "{text}"
    );
    assert!(!text.contains("to and fro"), "{text}");
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("a drive");
    let radii = [(0.25f64).hypot(3.0), (0.75f64).hypot(2.5)];
    for step in 0..=360 {
        let time = 12.0 * f64::from(step) / 360.0;
        let [first, second] = [-60.0 * time, 90.0 + 150.0 * time].map(f64::to_radians);
        let a = [first.cos(), first.sin()];
        let b = [2.0 + 0.5 * second.cos(), 0.5 * second.sin()];
        let wanted = cut(a, b, radii);
        // A period of twelve seconds is two turns.
        let results = assembly.results("points", &[2.0 * TAU + first]);
        for (name, wanted) in [("c1", a), ("c2", wanted), ("c3", b)] {
            let [x, y] = results.vector::<2>(name);
            let error = (x - wanted[0]).hypot(y - wanted[1]);
            assert!(error < 1e-9, "{name} at {time} s: {error}\n{text}");
        }
    }
}

#[test]
fn speeds_without_a_short_ratio_are_a_quotient() {
    let text = five_bar(["rpm=\"40\"", "rpm=\"30\""]);
    assert!(
        text.contains("    let phi1 = 0deg + 240/180 * (phi2 - 90deg);\n"),
        "{text}"
    );
    assert!(
        text.contains("input phi2 = 90deg in 0deg..1080deg;"),
        "{text}"
    );
}

/// A motor that the user of the program turns has no speed.
#[test]
fn manual_motors_are_inputs() {
    let text = five_bar(["rpm=\"10\"", "rpm=\"30\" alwaysmanual=\"true\""]);
    assert_eq!(text.matches("    input phi").count(), 2, "{text}");
    assert!(text.contains("pub fn points(phi1, phi2)"), "{text}");
    assert!(
        text.contains("    // Inputs without a rate move to and fro, "),
        "{text}"
    );
    assert!(!text.contains("run together"), "{text}");
}

//! A margin belongs to the mechanism, not to the way in which its loops are written.

use std::f64::consts::TAU;

use linkage_compiler::check;
use linkage_symbolic::interpret::run;
use linkage_symbolic::program::Source;

/// Positions over a turn.
const POSITIONS: usize = 360;

/// The margin of a mechanism over a turn of `phi`.
fn margins(items: &str) -> Vec<f64> {
    let text = format!(
        "struct M {{ unit mm; param r = 80mm; param l = 120mm; input phi = 60deg; {items} }}
         impl M {{ fn f(phi) -> F {{ m: margin() }} }}"
    );
    let checked = check(text.parse().expect("brackets have partners"));
    let Some(unit) = checked.unit else {
        panic!("{text}: {:#?}", checked.messages);
    };
    let dimensions: Vec<f64> = unit.scalars().map(|scalar| scalar.nominal).collect();
    let modes = unit.modes();
    let load = |source, phi: f64, prepared: &[f64]| match source {
        Source::Parameter(index) => dimensions[index],
        Source::Input(_) => phi,
        Source::Mode(index) if modes[index] => 1.0,
        Source::Mode(_) => -1.0,
        Source::Prepared(slot) => prepared[slot],
        _ => f64::NAN,
    };
    let prepared = run(&unit.prepare, |source| load(source, f64::NAN, &[]));
    let places = (0..POSITIONS).map(|k| TAU * k as f64 / POSITIONS as f64);
    let program = &unit.functions[0].called.program;
    let margins = places.map(|phi| run(program, |source| load(source, phi, &prepared))[0]);
    margins.collect()
}

/// The margin is the same at each position, however it is written, and its largest value is 1.
fn expect_alike(spellings: &[&str]) {
    let first = margins(spellings[0]);
    let best = first.iter().fold(0.0, |best: f64, x| best.max(*x));
    assert!((0.999..=1.0 + 1e-12).contains(&best), "{best}");
    for other in &spellings[1..] {
        for (k, (a, b)) in first.iter().zip(margins(other)).enumerate() {
            assert!((a - b).abs() < 1e-9, "{other} at {k}: {a} and {b}");
        }
    }
}

#[test]
fn a_four_bar() {
    // 90 degrees between coupler and rocker are reached: 120^2 + 80^2 is between (160 - 40)^2 and (160 + 40)^2.
    expect_alike(&[
        "unknown theta = 30deg; unknown psi = 90deg;
         loop polar(40mm, phi) + polar(l, theta) = (150mm, 0) + polar(r, psi);",
        "unknown h = 15deg; unknown psi = 90deg;
         loop polar(40mm, phi) + polar(l, 2 * h) = (150mm, 0) + polar(r, psi);",
        "unknown theta = 30deg; unknown h = 45deg; let psi = 2 * h;
         loop polar(40mm, phi) + polar(l, theta) = (150mm, 0) + polar(r, psi);",
        "unknown psi = 90deg; let w = (150mm, 0) + polar(r, psi) - polar(40mm, phi);
         loop dot(w, w) = l * l;",
        "unknown psi = 90deg; let w = (150mm, 0) + polar(r, psi) - polar(40mm, phi);
         loop w.x * w.x + w.y * w.y - l * l = 0;",
        "unknown h = 45deg; let w = (150mm, 0) + polar(r, 2 * h) - polar(40mm, phi);
         loop dot(w, w) = l * l;",
        "unknown psi = 90deg; let end = (150mm, 0) + polar(r, psi);
         loop distance(polar(40mm, phi), end) = l;",
        "unknown p = (150mm, 80mm);
         loop distance(p, polar(40mm, phi)) = l; loop distance(p, (150mm, 0)) = r;",
        "unknown p = (150mm, 80mm); let v = p - polar(40mm, phi); let w = p - (150mm, 0);
         loop dot(v, v) = l * l; loop dot(w, w) = r * r;",
    ]);
}

#[test]
fn a_slider_crank() {
    expect_alike(&[
        "unknown theta = -20deg; unknown s = 130mm;
         loop polar(40mm, phi) + polar(l, theta) = (s, 10mm);",
        "unknown h = -10deg; unknown s = 130mm;
         loop polar(40mm, phi) + polar(l, 2 * h) = (s, 10mm);",
        "unknown s = 130mm; loop distance((s, 10mm), polar(40mm, phi)) = l;",
        "unknown s = 130mm; let v = (s, 10mm) - polar(40mm, phi); loop dot(v, v) = l * l;",
    ]);
}

/// A guide without offset: 1 where the slider is farthest from the pivot, 0 where it meets it.
#[test]
fn a_swinging_guide() {
    expect_alike(&[
        "unknown theta = 20deg; unknown s = 110mm;
         loop (r, 0) + polar(40mm, phi) = s * dir(theta);",
        "unknown theta = 20deg; unknown s = 110mm; let a = rotate((0, 40mm), phi - 90deg);
         loop a - polar(s, theta) = (-r, 0);",
        "unknown theta = -20deg; unknown s = 110mm; let turned = -phi;
         loop polar(40mm, turned) + polar(s, theta + 180deg) + (r, 0) = 0;",
    ]);
    let near = margins(
        "unknown theta = 30deg; unknown s = 80mm;
         loop (40mm, 0) + polar(40.01mm, phi) = s * dir(theta);",
    );
    // Half a turn on.
    let least = near.iter().fold(1.0, |least: f64, x| least.min(*x));
    assert!((least - 0.01 / 80.01).abs() < 1e-9, "{least}");
    assert_eq!(near[POSITIONS / 2], least);
}

/// With an offset it is 1 where the slider is farthest, too; the guide hangs on a link whose angle is the sum of two.
#[test]
fn a_guide_with_an_offset() {
    expect_alike(&[
        "unknown theta = 20deg; unknown s = 110mm;
         loop (r, 0) + polar(40mm, phi) = polar(s, theta) + polar(20mm, theta + 90deg);",
        // The row across the guide, in lengths and in areas.
        "unknown theta = 20deg; loop cross(dir(theta), (r, 0) + polar(40mm, phi)) = 20mm;",
        "unknown theta = 20deg; loop cross(polar(l, theta), (r, 0) + polar(40mm, phi)) = 20mm * l;",
    ]);
    expect_alike(&[
        "unknown chi; loop chi = 2 * phi; unknown theta = 20deg; unknown s = 110mm;
         loop (r, 0) + polar(40mm, chi + 10deg - phi) = polar(s, theta);",
        "unknown theta = 20deg; unknown s = 110mm;
         loop (r, 0) + polar(40mm, phi + 10deg) = polar(s, theta);",
    ]);
}

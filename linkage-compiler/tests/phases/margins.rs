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

/// The margins of all spellings are the same at each position; where one has none the others have none either.
fn expect_same(spellings: &[&str]) {
    let first = margins(spellings[0]);
    assert!(first.iter().any(|x| x.is_finite()));
    for other in &spellings[1..] {
        for (k, (a, b)) in first.iter().zip(margins(other)).enumerate() {
            let same = (a - b).abs() < 1e-9 || a.is_nan() && b.is_nan();
            assert!(same, "{other} at {k}: {a} and {b}");
        }
    }
}

/// A guide through a fixed point, with and without an offset, at points of a four-bar: the way to them through crank and coupler and the one through
/// the rocker are one mechanism.
#[test]
fn a_guide_at_a_point_of_a_four_bar() {
    let loops =
        "unknown theta = 30deg; unknown psi = 90deg; let a = polar(40mm, phi); let d = (150mm, 0);
                 loop a + polar(l, theta) = d + polar(r, psi);";
    for guide in ["polar(s, tau)", "polar(s, tau) + polar(15mm, tau + 90deg)"] {
        let spelled = |loops: &str, point: &str| {
            format!(
                "{loops} unknown tau = 40deg; unknown s = 90mm; loop {point} = (60mm, 20mm) + {guide};"
            )
        };
        let points = [
            "a + polar(l, theta)",
            "d + polar(r, psi)",
            "0.5 * (a + polar(l, theta) + d + polar(r, psi))",
            "3 * d + 3 * polar(r, psi) - 2 * a - 2 * polar(l, theta)",
        ];
        let end = points.map(|point| spelled(loops, point));
        expect_same(&end.each_ref().map(|text| &text[..]));
        let coupler = [
            "a + polar(70mm, theta + 25deg)",
            "d + polar(r, psi) - polar(l, theta) + polar(70mm, theta + 25deg)",
        ];
        let coupler = coupler.map(|point| spelled(loops, point));
        expect_same(&coupler.each_ref().map(|text| &text[..]));
        let rocker = [
            "d + polar(30mm, psi - 40deg)",
            "a + polar(l, theta) - polar(r, psi) + polar(30mm, psi - 40deg)",
        ];
        let rocker = rocker.map(|point| spelled(loops, point));
        expect_same(&rocker.each_ref().map(|text| &text[..]));
        // Other spellings of the four-bar.
        let distance = "unknown psi = 90deg; let a = polar(40mm, phi); let d = (150mm, 0);
                        loop distance(a, d + polar(r, psi)) = l;";
        let point = "unknown p = (150mm, 80mm); loop distance(p, polar(40mm, phi)) = l; loop distance(p, (150mm, 0)) = r;";
        let relative = "unknown theta = 30deg; unknown chi = 60deg; let a = polar(40mm, phi); let d = (150mm, 0);
                        loop a + polar(l, theta) = d + polar(r, theta + chi);";
        let others = [
            end[0].clone(),
            spelled(distance, "d + polar(r, psi)"),
            spelled(point, "p"),
            spelled(relative, "d + polar(r, theta + chi)"),
            spelled(relative, "a + polar(l, theta)"),
        ];
        expect_same(&others.each_ref().map(|text| &text[..]));
    }
}

#[test]
fn a_guide_at_the_slider_of_a_crank() {
    let loops = "unknown theta = -20deg; unknown x = 130mm; let a = polar(40mm, phi);
                 loop a + polar(l, theta) = (x, 10mm);";
    let spelled = |point: &str| {
        format!(
            "{loops} unknown tau = 100deg; unknown s = 90mm; loop {point} = (60mm, -80mm) + polar(s, tau);"
        )
    };
    expect_same(&[&spelled("(x, 10mm)"), &spelled("a + polar(l, theta)")]);
}

/// The second four-bar hangs on the first, and the guide on both; then a guide on the lever of a swinging guide.
#[test]
fn a_guide_behind_two_loops() {
    let loops = "unknown theta = 30deg; unknown psi = 90deg; let a = polar(40mm, phi); let d = (150mm, 0);
                 loop a + polar(l, theta) = d + polar(r, psi);
                 let e = d + polar(60mm, psi + 20deg); let f = (270mm, 10mm);
                 unknown alpha = 0deg; unknown beta = 80deg; loop e + polar(130mm, alpha) = f + polar(90mm, beta);";
    let spelled = |point: &str| {
        format!(
            "{loops} unknown tau = 60deg; unknown s = 90mm; loop {point} = (200mm, -30mm) + polar(s, tau);"
        )
    };
    expect_same(&[
        &spelled("f + polar(90mm, beta)"),
        &spelled("e + polar(130mm, alpha)"),
        &spelled(
            "a + polar(l, theta) - polar(r, psi) + polar(60mm, psi + 20deg) + polar(130mm, alpha)",
        ),
    ]);
    let loops = "unknown theta = 20deg; unknown x = 110mm; loop (r, 0) + polar(40mm, phi) = polar(x, theta) + polar(7mm, theta + 90deg);";
    let spelled = |point: &str| {
        format!(
            "{loops} unknown tau = 130deg; unknown s = 60mm; loop {point} = (90mm, -30mm) + polar(s, tau);"
        )
    };
    expect_same(&[
        &spelled("polar(50mm, theta)"),
        &spelled(
            "(r, 0) + polar(40mm, phi) - polar(x, theta) - polar(7mm, theta + 90deg) + polar(50mm, theta)",
        ),
    ]);
}

/// The joint of coupler and rocker on a guide through a fixed point: that point is nearer to it by way of the rocker, or by way of the crank.
#[test]
fn a_guide_at_a_joint_is_measured_by_the_shortest_way() {
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let (origin, d) = ([0.0, 0.0], [150.0, 0.0]);
    for (fixed, guide, by_rocker) in [
        ([60.0, 20.0], [40, 90], true),
        ([-40.0, -100.0], [45, 250], false),
    ] {
        let ways = [40.0 + 120.0 + apart(fixed, origin), 80.0 + apart(fixed, d)];
        assert_eq!(ways[1] < ways[0], by_rocker);
        let longest = ways[0].min(ways[1]);
        let ([x, y], [tau, s]) = (fixed, guide);
        let found = margins(&format!(
            "unknown theta = 30deg; unknown psi = 90deg;
             loop polar(40mm, phi) + polar(l, theta) = (150mm, 0) + polar(r, psi);
             unknown tau = {tau}deg; unknown s = {s}mm; loop (150mm, 0) + polar(r, psi) = ({x}mm, {y}mm) + polar(s, tau);"
        ));
        let mut seen = 0;
        for (k, margin) in found.iter().enumerate() {
            let phi = TAU * k as f64 / POSITIONS as f64;
            let a = [40.0 * phi.cos(), 40.0 * phi.sin()];
            let diagonal = apart(a, d);
            // The transmission angle, and the joint above the line from crank to frame.
            let mu =
                (120.0_f64.powi(2) + 80.0_f64.powi(2) - diagonal.powi(2)) / (2.0 * 120.0 * 80.0);
            let foot = (diagonal.powi(2) + (120.0 + 80.0) * (120.0 - 80.0)) / (2.0 * diagonal);
            let height = (120.0_f64.powi(2) - foot * foot).sqrt();
            let [u, v] = [0, 1].map(|k| (d[k] - a[k]) / diagonal);
            let joint = [a[0] + foot * u - height * v, a[1] + foot * v + height * u];
            let guide = apart(joint, fixed) / longest;
            let expected = guide.min((1.0 - mu * mu).sqrt());
            assert!(
                (margin - expected).abs() < 1e-12,
                "{fixed:?} at {k}: {margin}, not {expected}"
            );
            seen += usize::from(expected == guide);
        }
        assert!(seen > 50, "{seen}");
    }
}

//! Mechanisms that once were accepted and wrong, or refused with the wrong words, or crashed the compiler: short, so that mutations hit
//! what matters.

/// A four-bar: what stands before its loop, and the loop.
macro_rules! four_bar {
    ($name:literal, $declared:literal, $loop:literal) => {
        concat!(
            "struct ",
            $name,
            " { unit mm; ",
            $declared,
            " loop ",
            $loop,
            "; } impl ",
            $name,
            " { fn motion(phi) -> Motion { psi, v: velocity(psi), m: margin() } fn other(phi) -> Motion { theta } }"
        )
    };
}

/// A scalar loop of an angle or number, or of a length.
macro_rules! scalar {
    ($declared:literal, $loop:literal) => {
        concat!(
            "struct A { unit mm; param k = 1; param l = 5mm; input phi = 10deg in 0deg..20deg; unknown ",
            $declared,
            "; loop ",
            $loop,
            "; } impl A { fn f(phi) -> F { m, s: sensitivity(m) } }"
        )
    };
}

pub(super) const TRAPS: [&str; 22] = [
    // Bare numbers as angles and lengths.
    four_bar!(
        "A",
        "param crank = 50; param c = 120mm; param r = 100mm; input phi = 30 in 0..360; unknown theta = 40; unknown psi = 80;",
        "polar(crank, phi) + polar(c, theta) = (140mm, 0) + polar(r, psi)"
    ),
    // Estimates that are not met: the crossed assembly, a wrong sign, none at all.
    four_bar!(
        "T",
        "param crank = 50mm; input phi = 30deg in 0deg..360deg; unknown theta = 40deg; unknown psi = 260deg;",
        "polar(crank, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi)"
    ),
    four_bar!(
        "U",
        "param crank = 50mm; input phi = 30deg in 0deg..360deg; unknown theta; unknown psi;",
        "polar(crank, phi) - polar(120mm, theta) = (140mm, 0) + polar(100mm, psi)"
    ),
    // Change points, unused and unfinite parameters.
    four_bar!(
        "Motion",
        "param crank = 50mm; param spare = 7mm; let odd = sqrt(crank - 2 * crank); input phi = 30deg in 0deg..360deg; unknown theta = 0deg; unknown psi = 30deg;",
        "polar(crank, phi) + polar(140mm, theta) = (140mm, 0) + polar(crank, psi)"
    ),
    // Ranges in other words, lifetimes, forwarded attributes.
    four_bar!(
        "X<'a>",
        "param crank = 50mm; input phi = 30deg in 0deg to 360deg; unknown theta = 40deg; unknown psi = 80deg;",
        "polar(crank, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi)"
    ),
    four_bar!(
        "Big",
        "param crank = 5e155mm; input phi = 30deg; unknown theta = 40deg; unknown psi = 80deg;",
        "polar(crank, phi) + polar(12e155mm, theta) = (14e155mm, 0) + polar(10e155mm, psi)"
    ),
    // One mechanism in several spellings.
    four_bar!(
        "Twice",
        "param crank = 50mm; input phi = 30deg in 0deg..360deg; unknown h = 20deg; let theta = 2 * h; unknown psi = 80deg;",
        "polar(crank, phi) + polar(120mm, 2 * h) = (140mm, 0) + polar(100mm, psi)"
    ),
    four_bar!(
        "Square",
        "param crank = 50mm; param c = 120mm; input phi = 30deg in 0deg..360deg; unknown psi = 80deg; let theta = phi; let w = (140mm, 0) + polar(100mm, psi) - polar(crank, phi);",
        "dot(w, w) = c * c"
    ),
    // Angle relations that are not finite; loops without meaning.
    scalar!("m = 10deg", "m = acos(k + 1)"),
    scalar!("m = 10deg", "m = l / (1mm * (k - 1))"),
    scalar!("m = 10mm; unknown t = 5deg; loop t = phi", "m = 0/0 * t * 1mm"),
    scalar!("m = 10deg", "0 = norm(m * (1, 2))"),
    scalar!("m = 10deg", "norm((m, 2 * m)) = 0"),
    scalar!("m = 10mm", "0 = norm(m * (1, 2)) - l"),
    // A link too short, a guide, an inertia with the wrong unit.
    "struct Short { unit mm; param crank = 50mm; param rod = 40mm; input phi = 10deg in 0deg..360deg; unknown theta = -10deg; unknown slide = 90mm;
     loop polar(crank, phi) + polar(rod, theta) = (slide, 0);
     body wheel = pin a on frame at (0, 0), turns phi, mass 1kg at (0, 0), inertia 240kg*mm; }
     impl Short { fn slide(phi) -> Slide { slide } fn torque(phi) -> Torque { t: torque(phi) } }",
    "struct Pivot { unit mm; param r = 20mm; input phi = 10deg in 0deg..360deg; unknown s = 80mm; unknown psi = 5deg;
     loop polar(r, phi) = (-70mm, 0) + polar(s, psi); } impl Pivot { fn s(phi) -> S { s, psi, m: margin() } }",
    // Three cranks on one rod.
    "struct Cranks { unit mm; param r = 20mm; input phi = 10deg in 0deg..360deg; unknown a = 10deg; unknown b = 10deg; unknown t = 0deg;
     loop polar(r, phi) + polar(50mm, t) = (50mm, 0) + polar(r, a);
     loop polar(r, phi) + polar(90mm, t) = (90mm, 0) + polar(r, b); } impl Cranks { fn f(phi) -> F { t, a, b } }",
    // Triads: with several inputs, with a dyad before and behind, of too high a degree.
    "struct Platform { unit mm; param r = 51.6mm; param l = 89.1mm; param s = 83.9mm; param g = 192mm;
     input p = 90deg in 80deg..100deg; input q = 210deg in 200deg..220deg;
     unknown tilt = 0deg; unknown x = 60deg; unknown y = 180deg; unknown z = -60deg;
     let a = polar(r, p) + polar(l, x);
     loop a + polar(s, tilt) = (g, 0) + polar(r, q) + polar(l, y);
     loop a + polar(s, tilt + 60deg) = (g / 2, g) + polar(l, z); } impl Platform { fn f(p, q) -> F { a, tilt, v: velocity(a) } }",
    "struct Chain { unit mm; param crank = 20mm; param leg = 50mm; input phi = 60deg in 40deg..80deg;
     unknown tilt = 20deg; unknown x = 20deg; unknown y = 100deg; unknown z = 290deg; unknown lean = 100deg; unknown slide = 80mm;
     let a = polar(crank, phi) + polar(leg, x);
     loop a + polar(60mm, tilt) = (120mm, 0) + polar(leg, y);
     loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(leg, z);
     loop a + polar(70mm, lean) = (0, slide); } impl Chain { fn f(phi) -> F { a, slide } }",
    "struct High { unit mm; param l = 10mm; input phi = 10deg; unknown t = 20deg; unknown s = 10mm;
     loop polar(l, t) + polar(l, 3 * t) + polar(l, 5 * t) = (s, s * s / l); } impl High { fn f(phi) -> F { t, s, phi } }",
    // Space: equal links of a large size, and what is degenerate.
    "struct Rssr { param crank = 1e9m; param tilt = 20deg; input phi = 0deg; unknown psi = 100deg;
     let pin = turn((0, crank, 0), (1, 0, 0), phi); let end = (1m, 0m, 0m) + turn((crank, 0, 0), (0, 0, 1), psi);
     loop distance(pin, end) = crank; } impl Rssr { fn f(phi) -> F { psi, end, m: margin() } }",
    "struct Flat { unit mm; input a = 10mm in 5mm..15mm; input b = 10mm in 5mm..15mm; unknown p = (0mm, 0mm, 10mm);
     loop distance(p, (0, 0, 0)) = a; loop distance(p, (0, 0, 0)) = b; loop dot(p, (0, 0, 1)) = a; } impl Flat { fn f(a, b) -> F { p } }",
];

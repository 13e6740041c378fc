//! Guides, closed contours, groups that could have been solved one after the other.

use crate::{expect_alike, spellings};

// Two bodies, joined by two links.
spellings! {
    [
        input phi = 30deg;
        unknown alpha = -47deg; unknown beta = -106deg; unknown gamma = 11deg; unknown delta = 98deg;
        let a = polar(11mm, phi);
        let base = (150mm, 27mm);
        let c1 = a + polar(84mm, alpha); let d1 = a + polar(70mm, alpha + 25deg);
        let c2 = base + polar(73mm, beta); let d2 = base + polar(86mm, beta - 85deg);
        let c = c1 + polar(64mm, gamma) - c2; let d = d1 + polar(64mm, delta) - d2;
    ]
    two_chains { loop c = (0, 0); loop d = (0, 0); }
    around_the_contour { loop c = (0, 0); loop c = d; }
    mixed { loop c + d = (0, 0); loop c = 2 * d; }
}

#[test]
fn a_contour() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        expect_alike(&[
            ("two chains", two_chains(phi)),
            ("around the contour", around_the_contour(phi)),
            ("mixed", mixed(phi)),
        ]);
    }
}

// A link with three joints: on a crank by a link, on a guide, and on a guide of its own through a fixed point.
spellings! {
    [
        input phi = 30deg;
        unknown x2 = -121mm; unknown x3 = 153mm; unknown theta = 1deg;
        let p1 = polar(27mm, phi);
        let guide = (96mm, -1mm) + polar(x2, 170deg);
        let fixed = (28mm, 84mm);
    ]
    from_the_link {
        unknown x1 = -21deg;
        let e1 = p1 + polar(102mm, x1);
        loop e1 + polar(97mm, theta) = guide;
        loop e1 + polar(42mm, theta + 30deg) = fixed + polar(x3, theta - 35deg);
    }
    from_the_guide {
        unknown x1 = -21deg;
        let e1 = guide - polar(97mm, theta);
        loop p1 + polar(102mm, x1) = e1;
        loop e1 + polar(42mm, theta + 30deg) = fixed + polar(x3, theta - 35deg);
    }
    a_distance_and_centimetres {
        let e1 = guide - polar(97mm, theta);
        loop distance(e1, p1) = 102mm;
        loop 0.1 * (e1 + polar(42mm, theta + 30deg) - fixed - polar(x3, theta - 35deg)) = (0, 0);
    }
}

#[test]
fn guides() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        expect_alike(&[
            ("from the link", from_the_link(phi)),
            ("from the guide", from_the_guide(phi)),
            ("a distance", a_distance_and_centimetres(phi)),
        ]);
    }
}

/// Two dyads, the second of which hangs on the first: the sines of their transmission angles and the margin of all assemblies.
macro_rules! dyads {
    ($name:ident { $($loops:tt)* }) => {
        fn $name(phi: f64) -> Vec<([f64; 2], f64)> {
            linkage_interpreted::interpreted! {
                struct Mechanism {
                    unit mm;
                    input phi = 60deg;
                    unknown theta = 30deg; unknown psi = 80deg; unknown alpha = 10deg; unknown beta = 95deg;
                    let first = polar(40mm, phi) + polar(140mm, theta) - (150mm, 0) - polar(90mm, psi);
                    let second = polar(70mm, psi + 40deg) + polar(150mm, alpha) - (130mm, 20mm) - polar(100mm, beta);
                    $($loops)*
                }
                impl Mechanism {
                    fn position(phi) -> Position { mu: theta - psi, nu: alpha - beta, margin: margin() }
                }
            }
            let found = Mechanism::default().assemblies_at(phi).expect("it is no dead point");
            let places = found.iter().map(|one| one.position(phi));
            places.map(|p| ([p.mu.sin().abs(), p.nu.sin().abs()], p.margin)).collect()
        }
    };
}

dyads! { one_after_the_other { loop first = (0, 0); loop second = (0, 0); } }
dyads! { together { loop first + second = (0, 0); loop first = second; } }

/// Mixed loops of two groups fall apart again: the margin is the least one of both, as for separate loops.
#[test]
fn dyads_in_mixed_loops() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        let (separate, mixed) = (one_after_the_other(phi), together(phi));
        assert!(!mixed.is_empty());
        assert_eq!(separate.len(), mixed.len());
        for ([mu, nu], margin) in separate.into_iter().chain(mixed) {
            assert!((margin - mu.min(nu)).abs() < 1e-12, "{mu} {nu}: {margin}");
        }
    }
}

// A guide at a joint of a coupled group, which all of its legs lead to.
spellings! {
    [
        input phi = 30deg;
        unknown x1 = 86deg; unknown x2 = -177deg; unknown x3 = -24deg; unknown theta = -71deg;
        let e1 = polar(18mm, phi) + polar(79mm, x1);
        let e2 = (126mm, -13mm) + polar(69mm, x2);
        loop e1 + polar(110mm, theta) = e2;
        loop e1 + polar(107mm, theta + 75deg) = (30mm, 139mm) + polar(107mm, x3);
        unknown tau = -11deg; unknown s = 48mm;
        let slider = (-3mm, -77mm) + polar(s, tau) + polar(70mm, tau + 90deg);
    ]
    at_the_leg { loop slider = e2; }
    at_the_link { loop slider = e1 + polar(110mm, theta); }
    by_the_third_leg { loop slider + polar(107mm, theta + 75deg) - polar(110mm, theta) = (30mm, 139mm) + polar(107mm, x3); }
}

#[test]
fn a_guide_at_a_coupled_group() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        expect_alike(&[
            ("at the leg", at_the_leg(phi)),
            ("at the link", at_the_link(phi)),
            ("by the third leg", by_the_third_leg(phi)),
        ]);
    }
}

// Two bodies that turn about axes of their own, joined by two links with ball joints.

/// Points of the first body, then of the second, and the margin.
type Place = ([[f64; 3]; 4], f64);

macro_rules! spatial_spellings {
    ($($name:ident { $($items:tt)* })*) => {
        $(fn $name(phi: f64) -> Vec<Place> {
            linkage_interpreted::interpreted! {
                struct Mechanism {
                    unit mm;
                    input phi = 40deg;
                    unknown b = 50deg;
                    let r = (150mm + 55mm * cos(b), 40mm, 55mm * sin(b));
                    let s = (150mm + 45mm * cos(b - 60deg), 80mm, 45mm * sin(b - 60deg));
                    $($items)*
                }
                impl Mechanism {
                    fn position(phi) -> Position { p, q, r, s, margin: margin() }
                }
            }
            let found = Mechanism::default().assemblies_at(phi).expect("it is no dead point");
            let places = found.iter().map(|one| one.position(phi));
            places.map(|at| ([at.p, at.q, at.r, at.s].map(Into::into), at.margin)).collect()
        })*

        const SPELLINGS: &[(&str, fn(f64) -> Vec<Place>)] = &[$((stringify!($name), $name)),*];
    };
}

spatial_spellings! {
    distances {
        unknown a = 30deg;
        let p = (20mm * cos(phi), 60mm * cos(a), 20mm * sin(phi) + 60mm * sin(a));
        let q = (20mm * cos(phi) + 40mm, 50mm * cos(a + 70deg), 20mm * sin(phi) + 50mm * sin(a + 70deg));
        loop distance(p, r) = 169mm;
        loop distance(q, s) = 164mm;
    }
    squares {
        unknown a = 30deg;
        let p = (20mm * cos(phi), 60mm * cos(a), 20mm * sin(phi) + 60mm * sin(a));
        let q = (20mm * cos(phi) + 40mm, 50mm * cos(a + 70deg), 20mm * sin(phi) + 50mm * sin(a + 70deg));
        let v = p - r;
        let w = s - q;
        loop dot(v, v) = 169mm * 169mm;
        loop dot(w, w) = 164mm * 164mm;
    }
    from_body_to_body {
        unknown bend = -20deg;
        let a = b + bend;
        let p = (20mm * cos(phi), 60mm * cos(a), 20mm * sin(phi) + 60mm * sin(a));
        let q = (20mm * cos(phi) + 40mm, 50mm * cos(a + 70deg), 20mm * sin(phi) + 50mm * sin(a + 70deg));
        loop distance(p, r) = 169mm;
        loop distance(q, s) = 164mm;
    }
    halves {
        unknown h = 15deg;
        let p = (20mm * cos(phi), 60mm * cos(2 * h), 20mm * sin(phi) + 60mm * sin(2 * h));
        let q = (20mm * cos(phi) + 40mm, 50mm * cos(2 * h + 70deg), 20mm * sin(phi) + 50mm * sin(2 * h + 70deg));
        loop distance(p, r) = 169mm;
        loop distance(q, s) = 164mm;
    }
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    a.map(|x| x / dot(a, a).sqrt())
}

/// The determinant for the links' directions over that for the best directions, which are sought one after the other.
fn expected(phi: f64, [p, q, r, s]: [[f64; 3]; 4]) -> f64 {
    let base = [20.0 * phi.cos(), 0.0, 20.0 * phi.sin()];
    let about_x = |point: [f64; 3]| [0.0, base[2] - point[2], point[1]];
    let about_y = |point: [f64; 3]| [-point[2], 0.0, point[0] - 150.0];
    let columns = [[about_x(p), about_y(r)], [about_x(q), about_y(s)]];
    // (u.a)(v.d) - (u.b)(v.c), and what it is the product with `v` or with `u` of.
    let [[a, b], [c, d]] = columns;
    let for_first =
        |v: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| a[k] * dot(v, d) - b[k] * dot(v, c)) };
    let for_second =
        |u: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| d[k] * dot(u, a) - c[k] * dot(u, b)) };
    let links = [unit(difference(p, r)), unit(difference(q, s))];
    let mut best = [0.3, 0.5, -0.8];
    for _ in 0..2000 {
        best = unit(for_first(unit(for_second(best))));
    }
    let largest = dot(for_second(best), unit(for_second(best)));
    (dot(links[1], for_second(links[0])) / largest).abs()
}

#[test]
fn two_links_in_space() {
    let mut seen = 0;
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        for (name, of) in SPELLINGS {
            for (points, margin) in of(phi) {
                let expected = expected(phi, points);
                let close = (margin - expected).abs() < 1e-9 && margin <= 1.0;
                assert!(close, "{name} at {phi}: {margin}, not {expected}");
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "{seen}");
}

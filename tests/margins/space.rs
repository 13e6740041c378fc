//! Two bodies that turn about axes of their own, joined by two links with ball joints.

/// Points of the first body, then of the second, and the margin.
type Place = ([[f64; 3]; 4], f64);

macro_rules! spellings {
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

spellings! {
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

//! A link with three joints on three links, the first of which hangs on the crank.

use std::f64::consts::TAU;

/// The crank's angle and all dimensions.
#[derive(Clone, Copy, Debug)]
struct Case {
    phi: f64,
    ground: f64,
    sides: [f64; 2],
    legs: [f64; 3],
    pivots: [[f64; 2]; 2],
}

/// The joints of the link with three, and the directions of the others.
struct Legs {
    ends: [[f64; 2]; 3],
    directions: [[f64; 2]; 3],
}

/// One spelling: margins and legs of all assemblies.
type Spelling = fn(Case) -> Vec<(f64, Legs)>;

macro_rules! spellings {
    ($($module:ident { $($items:tt)* })*) => {
        $(mod $module {
            use super::{Case, Legs};

            linkage_interpreted::interpreted! {
                struct Mechanism {
                    unit mm;
                    param ground = 40mm;
                    param b = 100mm;
                    param c = 80mm;
                    param q1 = 130mm;
                    param q2 = 110mm;
                    param q3 = 120mm;
                    param a2 = (220mm, 20mm);
                    param a3 = (60mm, 230mm);
                    input phi = 60deg;
                    let p1 = polar(ground, phi);
                    $($items)*
                    let e2 = e1 + polar(b, theta);
                    let e3 = e1 + polar(c, theta + 60deg);
                }
                impl Mechanism {
                    fn position(phi) -> Position { p1, e1, e2, e3, margin: margin() }
                }
            }

            pub(super) fn all(case: Case) -> Vec<(f64, Legs)> {
                let Case { phi, ground, sides: [b, c], legs: [q1, q2, q3], pivots: [a2, a3] } = case;
                let mechanism = Mechanism { ground, b, c, q1, q2, q3, a2: a2.into(), a3: a3.into() };
                let found = mechanism.assemblies_at(phi).expect("it is no dead point");
                let legs = found.iter().map(|assembly| {
                    let p = assembly.position(phi);
                    let ends: [[f64; 2]; 3] = [p.e1, p.e2, p.e3].map(Into::into);
                    let pivots = [p.p1.into(), a2, a3];
                    let directions = std::array::from_fn(|i| {
                        let [x, y] = [0, 1].map(|k| ends[i][k] - pivots[i][k]);
                        [x, y].map(|own: f64| own / f64::hypot(x, y))
                    });
                    (p.margin, Legs { ends, directions })
                });
                legs.collect()
            }
        })*

        const SPELLINGS: &[(&str, Spelling)] = &[$((stringify!($module), $module::all)),*];
    };
}

spellings! {
    from_the_first_leg {
        unknown t1 = 66deg; unknown t2 = 155deg; unknown t3 = -40deg; unknown theta = -60deg;
        let e1 = p1 + polar(q1, t1);
        loop e1 + polar(b, theta) = a2 + polar(q2, t2);
        loop e1 + polar(c, theta + 60deg) = a3 + polar(q3, t3);
    }
    from_the_second_leg {
        unknown t1 = 66deg; unknown t2 = 155deg; unknown t3 = -40deg; unknown theta = -60deg;
        let e1 = a2 + polar(q2, t2) - polar(b, theta);
        loop e1 = p1 + polar(q1, t1);
        loop e1 + polar(c, theta + 60deg) = a3 + polar(q3, t3);
    }
    multiples {
        unknown t1 = 66deg; unknown t2 = 155deg; unknown t3 = -40deg; unknown h = -30deg;
        let theta = 2 * h;
        let e1 = p1 + polar(q1, t1);
        loop 3 * (e1 + polar(b, theta)) = 3 * (a2 + polar(q2, t2));
        loop a3 + polar(q3, t3) = e1 + polar(c, theta + 60deg);
    }
    halves {
        unknown h1 = 33deg; unknown h2 = 77deg; unknown t3 = -40deg; unknown theta = -60deg;
        let e1 = p1 + polar(q1, 2 * h1);
        loop e1 + polar(b, theta) = a2 + polar(q2, 2 * h2);
        loop e1 + polar(c, theta + 60deg) = a3 + polar(q3, t3);
    }
    distances {
        unknown e1 = (72mm, 154mm); unknown theta = -60deg;
        loop distance(e1, p1) = q1;
        loop distance(e1 + polar(b, theta), a2) = q2;
        loop distance(e1 + polar(c, theta + 60deg), a3) = q3;
    }
    squares {
        unknown e1 = (72mm, 154mm); unknown theta = -60deg;
        let v1 = e1 - p1;
        let v2 = e1 + polar(b, theta) - a2;
        let v3 = e1 + polar(c, theta + 60deg) - a3;
        loop dot(v1, v1) = q1 * q1;
        loop dot(v2, v2) = q2 * q2;
        loop dot(v3, v3) = q3 * q3;
    }
    coordinates {
        unknown x = 72mm; unknown y = 154mm; unknown theta = -60deg;
        let e1 = (x, y);
        loop distance(e1, p1) = q1;
        loop distance(e1 + polar(b, theta), a2) = q2;
        loop distance(e1 + polar(c, theta + 60deg), a3) = q3;
    }
    a_bend_at_the_first_joint {
        unknown t1 = 66deg; unknown t2 = 155deg; unknown t3 = -40deg; unknown bend = -126deg;
        let theta = t1 + bend;
        let e1 = p1 + polar(q1, t1);
        loop e1 + polar(b, theta) = a2 + polar(q2, t2);
        loop e1 + polar(c, theta + 60deg) = a3 + polar(q3, t3);
    }
    a_bend_at_the_second_joint {
        unknown t1 = 66deg; unknown bend = 215deg; unknown t3 = -40deg; unknown theta = -60deg;
        let e1 = p1 + polar(q1, t1);
        loop e1 + polar(b, theta) = a2 + polar(q2, theta + bend);
        loop e1 + polar(c, theta + 60deg) = a3 + polar(q3, t3);
    }
}

/// The determinant of the links' lines over half of what the link with three joints measures around them.
fn expected(legs: &Legs) -> f64 {
    let [e1, e2, e3] = legs.ends;
    let [u1, u2, u3] = legs.directions;
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let apart = |a: [f64; 2], b: [f64; 2]| f64::hypot(a[0] - b[0], a[1] - b[1]);
    let moments = [cross(e1, u1), cross(e2, u2), cross(e3, u3)];
    let determinant =
        moments[0] * cross(u2, u3) + moments[1] * cross(u3, u1) + moments[2] * cross(u1, u2);
    let half = 0.5 * (apart(e1, e2) + apart(e2, e3) + apart(e3, e1));
    determinant.abs() / half
}

#[test]
fn a_triad_has_one_margin() {
    let mut seen = 0;
    for k in 0..60 {
        let part = f64::from(k) / 60.0;
        let size = [1.0, 1e-3, 1e4][k as usize % 3];
        let legs = [0.0, 0.37, 0.71].map(|shift| 125.0 + 20.0 * (TAU * (3.0 * part + shift)).sin());
        let case = Case {
            phi: TAU * part,
            ground: size * 40.0,
            sides: [100.0, 80.0].map(|x| size * x),
            legs: legs.map(|x| size * x),
            pivots: [[220.0, 20.0], [60.0, 230.0]].map(|a| a.map(|x| size * x)),
        };
        for (name, all) in SPELLINGS {
            let found = all(case);
            seen += found.len();
            for (margin, legs) in &found {
                let expected = expected(legs);
                assert!(
                    *margin > 0.0 && *margin <= 1.0,
                    "{name}, {case:?}: {margin}"
                );
                let close = (margin - expected).abs() < 1e-9;
                assert!(close, "{name}, {case:?}: {margin}, not {expected}");
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}

/// Links across an equilateral triangle's radii hold it best. Turned against the radii by any angle, its cosine remains: none where all meet in
/// the centre.
#[test]
fn the_best_is_one_and_the_worst_is_nothing() {
    let (radius, length) = (60.0, 70.0);
    let centre = [150.0, 140.0];
    for turned in [0.0, 60.0, -80.0, 89.9] {
        let wanted = f64::to_radians(turned).cos();
        let pivots = [210.0, 330.0, 90.0].map(|degrees: f64| {
            let (at, along) = (degrees.to_radians(), (degrees + 90.0 + turned).to_radians());
            [
                centre[0] + radius * at.cos() - length * along.cos(),
                centre[1] + radius * at.sin() - length * along.sin(),
            ]
        });
        let [[x, y], a2, a3] = pivots;
        let side = radius * 3f64.sqrt();
        let case = Case {
            phi: y.atan2(x),
            ground: x.hypot(y),
            sides: [side, side],
            legs: [length; 3],
            pivots: [a2, a3],
        };
        for (name, all) in SPELLINGS {
            let found = all(case);
            let near = found.iter().map(|(margin, _)| (margin - wanted).abs());
            let nearest = near.fold(1.0, f64::min);
            assert!(nearest < 1e-9, "{name}, {turned}: {nearest:e}");
        }
    }
}

//! Coupled groups beyond a triad: a closed contour of four links, in two written forms, and two platforms
//! on a common pin.

use crate::contour::Contour;
use crate::legs::turned;
use crate::newton;
use crate::platforms::Platforms;
use crate::random::{Random, effort};
use std::f64::consts::TAU;

const REFERENCE: f64 = 30.0 / 180.0 * std::f64::consts::PI;
/// Loops are missed by less than this.
const ROUNDING: f64 = 4e-13;
const SETS: usize = 25;

macro_rules! contour {
    ($module:ident { $($loops:tt)* }) => {
        mod $module {
            linkage::mechanism! {
                pub(super) struct Mechanism {
                    unit mm;
                    param crank = 11mm;
                    param base = (150mm, 27mm);
                    param p = 84mm;
                    param q = 70mm;
                    param at_p = 25deg;
                    param r = 73mm;
                    param s = 86mm;
                    param at_r = -85deg;
                    param upper = 64mm;
                    param lower = 64mm;
                    input phi = 30deg in 0deg..360deg;
                    unknown alpha = -47deg;
                    unknown beta = -106deg;
                    unknown gamma = 11deg;
                    unknown delta = 98deg;
                    let a = polar(crank, phi);
                    let c1 = a + polar(p, alpha);
                    let c2 = base + polar(r, beta);
                    let d1 = a + polar(q, alpha + at_p);
                    let d2 = base + polar(s, beta + at_r);
                    $($loops)*
                }

                impl Mechanism {
                    pub(super) fn position(phi) -> Position {
                        alpha: dir(alpha), beta: dir(beta),
                        miss_1: c1 + polar(upper, gamma) - c2, miss_2: d1 + polar(lower, delta) - d2,
                    }
                    pub(super) fn motion(phi) -> Motion { c1, v: velocity(c1), a: acceleration(c1) }
                }
            }
        }
    };
}

contour!(two_chains {
    loop c1 + polar(upper, gamma) = c2;
    loop d1 + polar(lower, delta) = d2;
});

contour!(around_the_contour {
    loop c1 + polar(upper, gamma) = c2;
    loop polar(p, alpha) + polar(upper, gamma) + polar(s, beta + at_r)
        = polar(q, alpha + at_p) + polar(lower, delta) + polar(r, beta);
});

// Neither loop has an angle to itself.
contour!(mixed {
    loop c1 + polar(upper, gamma) + polar(lower, delta) + d1 = c2 + d2;
    loop polar(p, alpha) + polar(upper, gamma) + polar(s, beta + at_r)
        = polar(q, alpha + at_p) + polar(lower, delta) + polar(r, beta);
});

/// The same contour for the independent count.
fn contour(d: &[f64; 11], phi: f64) -> Contour {
    let [crank, x, y, p, q, at_p, r, s, at_r, upper, lower] = *d;
    Contour {
        pivots: [turned([crank, 0.0], phi), [x, y]],
        ends: [
            [[p, 0.0], turned([q, 0.0], at_p)],
            [[r, 0.0], turned([s, 0.0], at_r)],
        ],
        lengths: [upper, lower],
    }
}

/// Whether two pairs of directions are the same.
fn alike(one: &[f64], two: &[f64], tolerance: f64) -> bool {
    one.iter()
        .zip(two)
        .all(|(a, b)| ((a - b) / 2.0).sin().abs() < tolerance)
}

macro_rules! contour_tests {
    ($test:ident $module:ident) => {
        #[test]
        fn $test() {
            use $module::{Mechanism, MechanismAssembly};
            let m = Mechanism::default();
            let default = [
                m.crank, m.base.x, m.base.y, m.p, m.q, m.at_p, m.r, m.s, m.at_r, m.upper, m.lower,
            ];
            let angles = |assembly: &MechanismAssembly, phi: f64| {
                let found = assembly.position(phi);
                let miss = crate::largest([
                    found.miss_1.x,
                    found.miss_1.y,
                    found.miss_2.x,
                    found.miss_2.y,
                ]);
                (
                    [
                        found.alpha.y.atan2(found.alpha.x),
                        found.beta.y.atan2(found.beta.x),
                    ],
                    miss,
                )
            };
            let mut random = Random::new(21);
            let mut counts = [0; 8];
            for set in 0..SETS * effort() {
                let d = random.near(default, [0.0, 0.05, 0.2, 0.5][set.min(set % 4)]);
                let phi = if set == 0 {
                    REFERENCE
                } else {
                    random.between(0.0, TAU)
                };
                let Some(poses) = contour(&d, phi).poses() else {
                    continue;
                };
                let [crank, x, y, p, q, at_p, r, s, at_r, upper, lower] = d;
                let mechanism = Mechanism {
                    crank,
                    base: [x, y].into(),
                    p,
                    q,
                    at_p,
                    r,
                    s,
                    at_r,
                    upper,
                    lower,
                };
                let found = mechanism.assemblies_at(phi).expect("it can be listed");
                let places: Vec<_> = found.iter().map(|assembly| angles(assembly, phi)).collect();
                let listed = |pose: &[f64; 2]| {
                    places
                        .iter()
                        .filter(|(at, _)| alike(pose, at, 1e-9))
                        .count()
                        == 1
                };
                let right = poses.len() == found.len() && poses.iter().all(listed);
                assert!(
                    right,
                    "{d:?} at {phi}: expected {poses:?}, found {places:?}"
                );
                assert!(
                    places.iter().all(|(_, miss)| *miss < ROUNDING),
                    "{places:?}"
                );
                counts[found.len()] += 1;
                // Each of them along the cycle.
                for (assembly, (at, _)) in found
                    .iter()
                    .zip(&places)
                    .filter(|_| set % 5 == 0 && phi < 6.0)
                {
                    follow(&d, phi, *at, &|phi| angles(assembly, phi).0);
                }
            }
            println!("contours with 0, 1, .. assemblies: {counts:?}");
            assert_eq!(mechanism_class(&Mechanism::STRUCTURE), (4, 2));
        }
    };
}

fn follow(d: &[f64; 11], phi: f64, start: [f64; 2], found: &dyn Fn(f64) -> [f64; 2]) {
    let misses = |phi: f64, x: &[f64; 2]| contour(d, phi).misses(*x);
    let (mut at, mut here) = (phi, start);
    for step in 1..=30 {
        let next = phi + (TAU - phi) * f64::from(step) / 30.0;
        let there = newton::follow(&misses, here, (at, next));
        let angles = found(next);
        match there {
            Ok(expected) => {
                let near_the_end = newton::follow(&misses, expected, (next, next + 0.02)).is_err();
                let right = alike(&angles, &expected, 1e-9) || (angles[0].is_nan() && near_the_end);
                assert!(right, "{d:?} at {next}: {angles:?}, not {expected:?}");
                (at, here) = (next, expected);
            }
            // It may come back from the other side of the cycle, but not here.
            Err(end) if next - end < 0.02 => {
                assert!(angles[0].is_nan() || next - end < 1e-3, "{angles:?}")
            }
            Err(_) => return,
        }
    }
}

fn mechanism_class(structure: &linkage::Structure) -> (usize, usize) {
    let group = &structure.groups[0];
    (group.class as usize, group.order as usize)
}

contour_tests!(contour_of_two_chains two_chains);
contour_tests!(contour_around around_the_contour);
contour_tests!(contour_without_an_angle_of_its_own mixed);

linkage::mechanism! {
    /// Two platforms.
    struct Six {
        unit mm;
        param crank = 10mm;
        param a2 = (109mm, 1mm);
        param a3 = (195mm, 20mm);
        param a4 = (105mm, 172mm);
        param l1 = 60mm;
        param l2 = 73mm;
        param l3 = 61mm;
        param l4 = 84mm;
        param b = 80mm;
        param c = 90mm;
        param at_c = 75deg;
        param d = 96mm;
        param e = 80mm;
        param at_e = 90deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 92deg;
        unknown x2 = -172deg;
        unknown x3 = -153deg;
        unknown x4 = -43deg;
        unknown one = -68deg;
        unknown two = -62deg;
        let e1 = polar(crank, phi) + polar(l1, x1);
        let pin = e1 + polar(c, one + at_c);
        loop e1 + polar(b, one) = a2 + polar(l2, x2);
        loop pin + polar(d, two) = a3 + polar(l3, x3);
        loop pin + polar(e, two + at_e) = a4 + polar(l4, x4);
    }

    impl Six {
        fn position(phi) -> SixPosition {
            e1, one: dir(one), two: dir(two),
            miss_1: e1 + polar(b, one) - a2 - polar(l2, x2),
            miss_2: pin + polar(d, two) - a3 - polar(l3, x3),
            miss_3: pin + polar(e, two + at_e) - a4 - polar(l4, x4),
        }
    }
}

fn platforms(m: &Six, phi: f64) -> Platforms {
    Platforms {
        pivots: [
            turned([m.crank, 0.0], phi),
            m.a2.into(),
            m.a3.into(),
            m.a4.into(),
        ],
        lengths: [m.l1, m.l2, m.l3, m.l4],
        ends: [
            [m.b, 0.0],
            turned([m.c, 0.0], m.at_c),
            [m.d, 0.0],
            turned([m.e, 0.0], m.at_e),
        ],
    }
}

#[test]
fn two_platforms_on_a_pin() {
    let pose = |assembly: &SixAssembly, phi: f64| {
        let p = assembly.position(phi);
        let misses = [p.miss_1, p.miss_2, p.miss_3].map(|miss| miss.norm());
        let angles = [p.one, p.two].map(|v| v.y.atan2(v.x));
        (
            [
                p.e1.x / Platforms::SIZE,
                p.e1.y / Platforms::SIZE,
                angles[0],
                angles[1],
            ],
            crate::largest(misses),
        )
    };
    let mut random = Random::new(22);
    let mut counts = [0; 19];
    for set in 0..6 * effort() {
        let m = Six::default();
        let [crank, l1, l2, l3, l4, b, c, d, e] = random.near(
            [m.crank, m.l1, m.l2, m.l3, m.l4, m.b, m.c, m.d, m.e],
            [0.0, 0.05, 0.2][set % 3],
        );
        let m = Six {
            crank,
            l1,
            l2,
            l3,
            l4,
            b,
            c,
            d,
            e,
            ..m
        };
        let phi = if set == 0 {
            REFERENCE
        } else {
            random.between(0.0, TAU)
        };
        let Some(poses) = platforms(&m, phi).poses() else {
            continue;
        };
        let found = m.assemblies_at(phi).expect("it can be listed");
        let places: Vec<_> = found.iter().map(|assembly| pose(assembly, phi)).collect();
        let listed = |expected: &[f64; 4]| {
            places
                .iter()
                .filter(|(at, _)| alike(expected, at, 1e-9))
                .count()
                == 1
        };
        let right = poses.len() == found.len() && poses.iter().all(listed);
        assert!(
            right,
            "{m:?} at {phi}: expected {poses:?}, found {places:?}"
        );
        assert!(
            places.iter().all(|(_, miss)| *miss < ROUNDING),
            "{places:?}"
        );
        counts[found.len()] += 1;
    }
    println!("two platforms with 0, 1, .. assemblies: {counts:?}");

    // Over the whole cycle as fine steps lead.
    let m = Six::default();
    let linkage = m.assemble().expect("it closes");
    let misses = |phi: f64, x: &[f64; 4]| platforms(&m, phi).misses(x);
    let (mut at, mut here) = (REFERENCE, pose(&linkage, REFERENCE).0);
    for step in 1..=60 {
        let next = REFERENCE + TAU * f64::from(step) / 60.0;
        here = newton::follow(&misses, here, (at, next)).expect("no turning point");
        at = next;
        let (found, miss) = pose(&linkage, next);
        assert!(
            alike(&found, &here, 1e-10) && miss < ROUNDING,
            "{found:?}, not {here:?}"
        );
    }
}

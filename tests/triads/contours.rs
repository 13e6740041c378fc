//! Coupled groups beyond a triad: a closed contour of four links, in three written forms.

use crate::legs::{Point, turned};
use crate::polynomial::Trigonometric;
use crate::{alike, effort, newton};
use linkage_random::Random;
use std::f64::consts::TAU;

const REFERENCE: f64 = 30.0 / 180.0 * std::f64::consts::PI;
/// Loops are missed by less than this.
const ROUNDING: f64 = 4e-13;
const SETS: usize = 25;

macro_rules! contour {
    ($module:ident { $($loops:tt)* }) => {
        mod $module {
            linkage_interpreted::interpreted! {
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
            assert_eq!(mechanism_class(&Mechanism::structure()), (4, 2));
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

// A closed contour of four links, class IV: two ternary links, joined by two binary ones, each on a pivot.

/// Two ternary links and what joins them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contour {
    pub(crate) pivots: [Point; 2],
    /// Where the binary links hang on the first and on the second ternary link.
    pub(crate) ends: [[Point; 2]; 2],
    pub(crate) lengths: [f64; 2],
}

impl Contour {
    /// What each binary link misses for given directions of the ternary links, over its length.
    pub(crate) fn misses(&self, [alpha, beta]: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|k| {
            let [x, y] = self.between(k, alpha);
            let end = turned(self.ends[1][k], beta);
            let square = (x - end[0]).powi(2) + (y - end[1]).powi(2);
            (square / self.lengths[k].powi(2) - 1.0) / 2.0
        })
    }

    /// From the second pivot to where a binary link begins.
    fn between(&self, k: usize, alpha: f64) -> Point {
        let end = turned(self.ends[0][k], alpha);
        let [one, two] = self.pivots;
        [one[0] + end[0] - two[0], one[1] + end[1] - two[1]]
    }

    /// Cosine and sine of the second direction for a given first one, from both lengths, as numerators
    /// over one denominator.
    fn second(&self, alpha: f64) -> [f64; 3] {
        let rows: [[f64; 3]; 2] = std::array::from_fn(|k| {
            let ([x, y], [u, v]) = (self.between(k, alpha), self.ends[1][k]);
            let rest = x * x + y * y + u * u + v * v - self.lengths[k].powi(2);
            [x * u + y * v, y * u - x * v, rest / 2.0]
        });
        let [[a, b, e], [c, d, f]] = rows;
        [e * d - b * f, a * f - e * c, a * d - b * c]
    }

    /// All pairs of directions; `None` where two of them nearly coincide.
    pub(crate) fn poses(&self) -> Option<Vec<[f64; 2]>> {
        let polynomial = Trigonometric::through(|alpha| {
            let [c, s, d] = self.second(alpha);
            c * c + s * s - d * d
        });
        let found = polynomial.zeros()?.into_iter().map(|alpha| {
            let [c, s, d] = self.second(alpha);
            let mut pose = [alpha, (s * d.signum()).atan2(c * d.signum())];
            let mut last = (1.0, 0.0);
            for _ in 0..5 {
                last = crate::newton::step(&|x| self.misses(*x), &mut pose);
            }
            (last.0 < 1e-12 && last.1.abs() > 1e-5).then_some(pose)
        });
        found.collect()
    }
}

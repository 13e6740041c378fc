//! Against systems whose solutions are known; random platforms, which are for optimised code, with
//! `LINKAGE_LONG`.

mod axle;
mod steep;

use super::super::error::Unsolved;
use super::family::Member;
use super::monodromy::{Fibre, Random};
use super::trace::{LINEAR, miss};
use super::*;
use linkage_random::Random as Draw;
use std::println;

/// A ternary link on three legs in the plane: place and direction of the link, at most six
/// assemblies.
struct Ternary {
    base: [[f64; 2]; 3],
    joints: [[f64; 2]; 3],
    /// Squares of the legs, times 25.
    squares: [f64; 3],
}

/// A place and a direction whose equations have whole numbers only.
const PLACE: [f64; 2] = [1.0, 2.0];
const FIVEFOLD: [f64; 2] = [3.0, 4.0];

impl Ternary {
    fn at_place() -> Self {
        let base = [[0.0, 0.0], [3.0, 0.0], [1.0, 3.0]];
        let joints = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
        let [c, s] = FIVEFOLD;
        let squares = core::array::from_fn(|leg| {
            let [[a, b], [u, v]] = [base[leg], joints[leg]];
            let across = 5.0 * (PLACE[0] - a) + u * c - v * s;
            let up = 5.0 * (PLACE[1] - b) + u * s + v * c;
            across * across + up * up
        });
        Self {
            base,
            joints,
            squares,
        }
    }
}

impl Equations<4> for Ternary {
    fn values<T: Number>(&self, &[x, y, c, s]: &[T; 4]) -> [T; 4] {
        core::array::from_fn(|i| match i {
            0..3 => {
                let ([a, b], [u, v]) = (self.base[i].map(T::from), self.joints[i].map(T::from));
                let (across, up) = (x + u * c - v * s - a, y + u * s + v * c - b);
                T::from(25.0) * (across * across + up * up) - T::from(self.squares[i])
            }
            _ => c * c + s * s - T::from(1.0),
        })
    }
}

#[test]
fn a_ternary_link_has_six_assemblies_and_its_pose_is_among_them() {
    let ternary = Ternary::at_place();
    let found = solutions_traced(&ternary, 0).expect("it has some");
    assert!(found.is_complete(), "{found:?}");
    assert_eq!((found.general, found.undecided), (6, 0));
    assert_eq!(found.real.len() + found.complex, 6);
    let pose = [PLACE[0], PLACE[1], 0.6, 0.8];
    let is_pose = |one: &Solution<4>| {
        let pairs = one.values.iter().zip(pose);
        // The rounding of 0.6 and 0.8 is not the solution's.
        pairs
            .into_iter()
            .all(|(x, known)| (x - known).abs() <= one.error + f64::EPSILON)
    };
    assert_eq!(found.real.iter().filter(|one| is_pose(one)).count(), 1);
    for one in &found.real {
        assert!(one.error < 1e-14, "{one:?}");
        for value in ternary.values(&one.values) {
            assert!(value.abs() < 1e-12, "{value:e} at {one:?}");
        }
    }
}

#[test]
fn without_one_of_its_points_the_sum_is_not_linear() {
    let ternary = Ternary::at_place();
    let mut random = Random::new();
    let tilted = Member {
        form: random.point(),
        ..Member::given(&ternary)
    };
    let mut section = Fibre::find(&tilted, &mut random).expect("it has points");
    let all = miss(&section, &mut random);
    assert!(all < LINEAR, "{all:e}");
    section.found.pop();
    let fewer = miss(&section, &mut random);
    assert!(fewer > 0.01, "{fewer:e}");
}

/// A double solution.
struct Touching;

impl Equations<1> for Touching {
    fn values<T: Number>(&self, &[x]: &[T; 1]) -> [T; 1] {
        [x * x - T::from(2.0) * x + T::from(1.0)]
    }
}

/// A solution with almost all constants, none with these.
struct Parallel;

impl Equations<2> for Parallel {
    fn values<T: Number>(&self, &[x, y]: &[T; 2]) -> [T; 2] {
        [x * y - T::from(1.0), y]
    }
}

/// The second equation contradicts the first one.
struct Repeated;

impl Equations<2> for Repeated {
    fn values<T: Number>(&self, &[x, y]: &[T; 2]) -> [T; 2] {
        let sum = x + y;
        [sum - T::from(1.0), sum * sum - T::from(2.0)]
    }
}

#[test]
fn double_solutions_and_those_at_infinity_are_undecided() {
    let found = solutions_traced(&Touching, 0).expect("its constants can be changed");
    assert_eq!((found.general, found.undecided), (2, 2));
    assert!(found.trace.is_some_and(|trace| trace.passed()));
    assert!(!found.is_complete());
    let found = solutions(&Parallel).expect("its constants can be changed");
    assert_eq!((found.general, found.undecided), (1, 1));
    assert!(!found.is_complete());
}

#[test]
fn equations_that_depend_on_each_other_are_refused() {
    assert_eq!(solutions(&Repeated), Err(Unsolved::Singular));
}

/// A platform on six legs in whole tenths of the unit, and an orientation of it in whole numbers
/// over `whole`.
struct Platform {
    base: [[f64; 3]; 6],
    platform: [[f64; 3]; 6],
    whole: f64,
    /// Squares of the legs, times that of `whole`.
    squares: [f64; 6],
}

fn dot<T: Number>([a, b, c]: [T; 3], [d, e, f]: [T; 3]) -> T {
    a * d + b * e + c * f
}

fn cross<T: Number>([a, b, c]: [T; 3], [d, e, f]: [T; 3]) -> [T; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

impl Equations<9> for Platform {
    fn values<T: Number>(&self, unknowns: &[T; 9]) -> [T; 9] {
        let [p, x, y] = [0, 3, 6].map(|first| [0, 1, 2].map(|k| unknowns[first + k]));
        let z = cross(x, y);
        let one = T::from(1.0);
        core::array::from_fn(|i| match i {
            6 => dot(x, x) - one,
            7 => dot(y, y) - one,
            8 => dot(x, y),
            leg => {
                let [u, v, w] = self.platform[leg].map(T::from);
                let link = [0, 1, 2].map(|k| {
                    let base = T::from(self.base[leg][k]);
                    T::from(10.0) * p[k] + u * x[k] + v * y[k] + w * z[k] - base
                });
                let square = T::from(self.whole * self.whole);
                let miss = square * dot(link, link) - T::from(self.squares[leg]);
                T::from(0.01 / (self.whole * self.whole)) * miss
            }
        })
    }
}

/// A platform in a random pose: its place in tenths, and its directions times `whole`.
fn posed(draw: &mut Draw) -> (Platform, [f64; 3], [[f64; 3]; 3]) {
    let mut whole_number = || (draw.below(25) as f64) - 12.0;
    let mut points = || core::array::from_fn(|_| core::array::from_fn(|_| whole_number()));
    let (base, platform): ([[f64; 3]; 6], [[f64; 3]; 6]) = (points(), points());
    let solution: [f64; 3] = core::array::from_fn(|_| whole_number());
    let [a, b, c, d]: [f64; 4] = core::array::from_fn(|_| whole_number());
    let whole = a * a + b * b + c * c + d * d;
    // The matrix of a quaternion by columns.
    let x = [
        a * a + b * b - c * c - d * d,
        2.0 * (b * c + a * d),
        2.0 * (b * d - a * c),
    ];
    let y = [
        2.0 * (b * c - a * d),
        a * a - b * b + c * c - d * d,
        2.0 * (c * d + a * b),
    ];
    let z = cross(x, y).map(|entry| entry / whole);
    let squares = core::array::from_fn(|leg| {
        let ([u, v, w], base) = (platform[leg], base[leg]);
        let link = core::array::from_fn(|k| {
            whole * (solution[k] - base[k]) + u * x[k] + v * y[k] + w * z[k]
        });
        dot(link, link)
    });
    let posed = Platform {
        base,
        platform,
        whole,
        squares,
    };
    (posed, solution, [x, y, z])
}

const PLATFORMS: usize = 18;
const SEED: u64 = 40;

#[test]
fn solutions_two_thousand_times_as_far_as_a_platform_is_wide_are_shown() {
    let mut draw = Draw::new(SEED);
    let platforms = [(); PLATFORMS].map(|()| posed(&mut draw).0);
    // The end of a path of the last one, to ten digits; the other one of its pair is the mirror
    // image.
    let solution = [
        [1558.537407, 1189.451554],
        [98.55984839, -2165.197926],
        [2070.899016, -791.0883071],
        [598.4645295, -708.0828578],
        [-1067.971436, -103.5113432],
        [-301.7186214, -1038.104029],
        [299.4751225, -1048.731020],
        [-1197.014615, 404.7648002],
        [-824.3604810, -968.7245453],
    ]
    .map(Complex::from);
    let given = Member::given(&platforms[PLATFORMS - 1]);
    assert!(
        given.shown_soon(&solution).is_none(),
        "77 digits are needed"
    );
    let [one, mirrored] = [solution, solution.map(Complex::conjugate)]
        .map(|solution| given.shown(&solution).expect("it is a solution"));
    for shown in [&one, &mirrored] {
        assert_eq!(shown.real, Some(false));
        for disc in shown.discs {
            assert!(disc.radius <= f64::EPSILON * disc.size(), "{disc:?}");
        }
    }
    assert!(one.is_apart_from(&mirrored));
    let way = one
        .discs
        .iter()
        .zip(solution)
        .map(|(disc, x)| (disc.middle - x).size());
    assert!(way.fold(0.0, f64::max) < 1e-4);
}

#[test]
fn random_platforms_have_forty_assemblies_and_their_pose_is_among_them() {
    if !linkage_random::is_long() {
        return;
    }
    let mut draw = Draw::new(SEED);
    for _ in 0..PLATFORMS {
        let (platform, solution, [x, y, _]) = posed(&mut draw);
        let found = solutions_traced(&platform, 5).expect("it has some");
        let trace = found.trace.expect("it was asked for");
        let real = found.real.len();
        println!("{real} real, {} undecided, {trace:?}", found.undecided);
        assert_eq!(
            (found.general, real + found.complex + found.undecided),
            (40, 40)
        );
        assert!(found.is_complete());
        let pose = [
            solution.map(|number| number / 10.0),
            x.map(|number| number / platform.whole),
            y.map(|number| number / platform.whole),
        ];
        let pose = pose.concat();
        let is_pose = |one: &&Solution<9>| {
            let mut pairs = one.values.iter().zip(&pose);
            // Both are rounded.
            pairs.all(|(x, known)| (x - known).abs() <= one.error + f64::EPSILON)
        };
        assert_eq!(found.real.iter().filter(is_pose).count(), 1);
    }
}

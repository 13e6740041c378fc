//! Against systems whose solutions are known. A hexapod's 40 assemblies are listed by the example `hexapod`.

use super::super::error::Unsolved;
use super::family::Member;
use super::monodromy::{Fibre, Random};
use super::trace::{LINEAR, miss};
use super::*;

/// A ternary link on three legs in the plane: place and direction of the link, at most six assemblies.
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
        form: random.place(),
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

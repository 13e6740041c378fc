//! The trace test: evidence that no solution is missing.
//!
//! With all constants but one held, the solutions of `f(x) = constants` are a curve in the space of
//! `x` and that constant `s`. A hyperplane `s + form . x = c` meets it in as many points as its
//! degree says, and the sum of all these points is a linear function of `c`; that of a part of them
//! is not (Sommese, Verschelde and Wampler, SIAM Journal on Numerical Analysis 40, 2002). When the
//! form is taken away, each solution of the equations is the end of one of these points, and the
//! others go to infinity.

use super::family::{Member, ParameterPath};
use super::monodromy::{Fibre, Random, end, middle};
use super::polynomial_equations::Equations;
use crate::error::Unsolved;
use linkage_core::numeric::complex::{Complex, ZERO};
use linkage_design::internals::in_parallel;
use std::vec::Vec;

/// The result of the trace test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trace {
    /// The equation along which the curve goes.
    pub row: usize,
    /// The degree of the curve: points of it on a hyperplane.
    pub degree: usize,
    /// The difference of the sum of the points from a linear function, as a part of that of one
    /// point.
    pub miss: f64,
    /// Points that go to infinity where solutions are looked for.
    pub outside: usize,
    /// Points that neither go to infinity nor become solutions.
    pub open: usize,
}

/// The limit of a linear sum: sums of all points bend by rounding only, other sums by about as much
/// as one of them.
pub(super) const LINEAR: f64 = 1e-6;
/// Points that bend by less than this part of their size bend by rounding: they move along a line,
/// which is the whole curve.
const STRAIGHT: f64 = 1e-6;
/// A point goes to infinity if it is so far away when so little of the form is left. All else is of
/// size 1.
const FAR: f64 = 1e3;
const LATE: f64 = 1e-4;
/// The largest error of a path that ends in a solution, as a part of its size: far more than the
/// tracker leaves.
const HERE: f64 = 1e-6;

impl Trace {
    /// Returns whether no solution is missing, as far as numbers can tell: the sum is linear, and
    /// each point has an end.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.miss <= LINEAR && self.open == 0
    }

    /// The test along equation `row` and, where it is not passed, along the next ones, as long as
    /// it is not; of several tests that are not passed the one that leaves fewest points open.
    pub(super) fn test_rows<E: Equations<N>, const N: usize>(
        general: &mut Fibre<'_, E, N>,
        row: usize,
        random: &mut Random,
    ) -> Result<Self, Unsolved> {
        let mut best = Self::test(general, row, random)?;
        for other in 1..N.min(ROWS) {
            if best.passed() {
                break;
            }
            let Ok(next) = Self::test(general, (row + other) % N, random) else {
                break;
            };
            let doubt = |test: &Self| (!test.passed(), test.miss > LINEAR, test.open);
            if doubt(&next) < doubt(&best) {
                best = next;
            }
        }
        Ok(best)
    }

    /// The test with the curve along equation `row`; solutions that it finds besides are added to
    /// `general`.
    pub(super) fn test<E: Equations<N>, const N: usize>(
        general: &mut Fibre<'_, E, N>,
        row: usize,
        random: &mut Random,
    ) -> Result<Self, Unsolved> {
        let tilted = Member {
            row,
            form: random.point(),
            ..general.member
        };
        let plain = Member {
            form: [ZERO; N],
            ..tilted
        };
        let mut section = Fibre::starting(tilted);
        section.follow(&plain, &general.places(), random.unit());
        let mut miss = miss(&section, random);
        while miss > LINEAR && !section.is_settled() {
            section.go_round(random)?;
            // A sum of points that may soon be joined by others is not worth the paths.
            if section.idle > 0 {
                miss = self::miss(&section, random);
            }
        }
        let mut ends = Ends::follow(&section, plain, random.unit());
        for _ in 1..WAYS {
            if ends.open(&section) == 0 {
                break;
            }
            let next = Ends::follow(&section, plain, random.unit());
            if next.open(&section) < ends.open(&section) {
                ends = next;
            }
        }
        let (outside, open) = (ends.outside, ends.open(&section));
        let reached = ends.solutions.found.len();
        ends.solutions
            .found
            .into_iter()
            .for_each(|end| general.add(end));
        Ok(Self {
            row,
            degree: section.found.len(),
            miss,
            outside,
            open: open.max(general.found.len() - reached),
        })
    }
}

/// Equations along which the test is made, until it is passed along one: each takes as long as the
/// first.
const ROWS: usize = 4;
/// Ways on which the form is taken away, until one leaves no point open.
const WAYS: usize = 3;

/// The ends of the points when the form is taken away.
struct Ends<'a, E, const N: usize> {
    solutions: Fibre<'a, E, N>,
    outside: usize,
}

impl<'a, E: Equations<N>, const N: usize> Ends<'a, E, N> {
    fn follow(section: &Fibre<'a, E, N>, plain: Member<'a, E, N>, arc: Complex) -> Self {
        let way = ParameterPath {
            from: &section.member,
            to: &plain,
            arc,
        };
        let mut ends = Self {
            solutions: Fibre::starting(plain),
            outside: 0,
        };
        let found = in_parallel(&section.places(), |start| match end(&way, start) {
            Err(stuck) => Err(stuck.t < LATE && size(&stuck.point) > FAR),
            // Newton's method may lead from far away to a solution that is not the end of this
            // path.
            Ok(point) => plain
                .shown(&point)
                .filter(|end| size(&difference(&middle(end), &point)) < HERE * size(&point))
                .ok_or(size(&point) > FAR),
        });
        for end in found {
            match end {
                Ok(end) => ends.solutions.add(end),
                Err(outside) => ends.outside += usize::from(outside),
            }
        }
        ends
    }

    /// Points that are nowhere. Two at one solution: a path has been left.
    fn open(&self, section: &Fibre<'a, E, N>) -> usize {
        section.found.len() - self.outside - self.solutions.found.len()
    }
}

fn difference<const N: usize>(a: &[Complex; N], b: &[Complex; N]) -> [Complex; N] {
    core::array::from_fn(|i| a[i] - b[i])
}

fn size<const N: usize>(point: &[Complex; N]) -> f64 {
    point.iter().map(|x| x.size()).fold(0.0, f64::max)
}

/// Returns the bend of the sum of the points between three places in line, as a part of that of a
/// single point: one missing point adds that much.
pub(super) fn miss<E: Equations<N>, const N: usize>(
    section: &Fibre<'_, E, N>,
    random: &mut Random,
) -> f64 {
    let here = section.member;
    // The shift is as large as the distance between constants of random points.
    let shift = here.through(&random.point()).constants[here.row] - here.constants[here.row];
    let moved = |by: f64| {
        let mut constants = here.constants;
        constants[here.row] += shift.scaled(by);
        here.with_constants(constants)
    };
    let first = section.places();
    let (from, to) = (moved(0.0), moved(1.0));
    let second = Fibre::carried(&from, &to, &first, random.unit());
    let (from, to) = (to, moved(2.0));
    let third = second.and_then(|second| {
        let third = Fibre::carried(&from, &to, &second, random.unit())?;
        Some((second, third))
    });
    // The sum of fewer points is none.
    let Some((second, third)) = third else {
        return f64::INFINITY;
    };
    let bends = first.iter().zip(&second).zip(&third);
    let bends = bends
        .map(|((a, b), c)| core::array::from_fn::<_, N, _>(|i| a[i] + c[i] - b[i].scaled(2.0)));
    let bends: Vec<[Complex; N]> = bends.collect();
    let sum = bends.iter().fold([ZERO; N], |sum, bend| {
        core::array::from_fn(|i| sum[i] + bend[i])
    });
    let one: f64 = bends.iter().map(size).sum();
    let whole: f64 = third.iter().map(size).sum();
    size(&sum) * bends.len() as f64 / (one + STRAIGHT * whole)
}

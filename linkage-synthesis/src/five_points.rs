//! Five points of a path, the joints of the frame given: at most 36 four-bars (Morgan and Wampler,
//! Journal of Mechanical Design 112, 1990), by the homotopy that finds the positions of coupled
//! groups.

use super::Pose;
use super::ball::{Ball, Bound};
use super::certificate::{self, Certificate, Evaluated, Point, System};
use super::dyad;
use super::error::{self, Unsolved};
use super::four_bar::FourBar;
use super::long::Long;
use super::task::{self, Shift};
use super::verify;
use linkage_core::numeric::complex::{Complex, ONE, Ring, ZERO};
use linkage_core::numeric::roots::{self, Term, Variable};
use std::vec::Vec;

/// The four-bars through five points.
#[derive(Clone, Debug, PartialEq)]
pub struct FivePoints {
    /// The real ones, with the pose of the coupler at each point. The coupler's frame has its
    /// origin at the point of the path, and angle 0 at the first point.
    pub four_bars: Vec<(FourBar, [Pose; 5])>,
    /// The number of complex ones.
    pub complex: usize,
    /// The number of those that are multiple, too close to others to decide whether they are real,
    /// or do not close with rounded joints.
    pub undecided: usize,
    /// Number of paths of the homotopy, each of which has been followed to its end without doubt.
    /// That they meet all solutions is certain with probability one: the start system is random.
    pub paths: usize,
    /// Bound of the errors of the joints, from Krawczyk's test (rounding included), which shows
    /// that each four-bar listed exists, is real, and differs from the others.
    pub error: f64,
}

/// `x`, `x^`, `y`, `y^`, then the turns at points 1 to 4.
const VARIABLES: [Variable; 8] = {
    let mut variables = [Variable::Unit; 8];
    variables[0] = Variable::Point;
    variables[1] = Variable::Conjugate;
    variables[2] = Variable::Point;
    variables[3] = Variable::Conjugate;
    variables
};
/// The same with both of each turn and its inverse.
const ALL: usize = 12;
/// More than this many terms of one equation there are not.
const TERMS: usize = 5;
const STEPS: usize = 5;

impl System<ALL> for Task {
    fn values(&self, point: &Point<ALL>) -> [Ball; ALL] {
        let (values, _) = self.system(point, [ZERO, ONE].map(Complex::wide), |shift| shift.wide());
        let bounds = |shift: &Shift| shift.wide().map(Bound::from_wide);
        let (sizes, _) = self.system(
            &point.map(Bound::from_wide),
            [Bound(0.0), Bound(1.0)],
            bounds,
        );
        core::array::from_fn(|i| sizes[i].around(values[i]))
    }

    fn matrix(&self, discs: &[Ball; ALL]) -> [[Ball; ALL]; ALL] {
        self.system(discs, [Ball::ZERO, Ball::exact(ONE)], |shift| shift.discs())
            .1
    }

    fn long(&self, discs: &[Ball<Long>; ALL]) -> Option<Evaluated<ALL>> {
        let exact = |shift: &Shift| shift.wide().map(Ball::from);
        Some(self.system(discs, [0.0.into(), 1.0.into()], exact))
    }
}

struct Task {
    first: [f64; 2],
    unit: f64,
    shifts: [Shift; 4],
    /// Joints of the frame, with all their digits.
    fixed: [Shift; 2],
}

/// All four-bars with these joints of the frame whose coupler has a point that passes the five
/// points.
///
/// # Errors
///
/// `NotFinite`, also for a joint (index 5 and 6); `Equal`; `Unlisted` if the homotopy has paths
/// without a certain end, as for points with a symmetry.
pub fn five_points(points: &[[f64; 2]; 5], fixed: [[f64; 2]; 2]) -> Result<FivePoints, Unsolved> {
    let [first, others @ ..] = *points;
    let all: Vec<[f64; 2]> = points.iter().chain(&fixed).copied().collect();
    error::check(&all)?;
    let shifts = others.map(|point| Shift::between(first, point));
    let unit = task::unit(shifts.iter().map(|shift| shift.narrow()));
    let task = Task {
        first,
        unit,
        shifts: shifts.map(|shift| shift.scaled(1.0 / unit)),
        fixed: fixed.map(|joint| Shift::between(first, joint).scaled(1.0 / unit)),
    };
    task.solve()
}

impl Task {
    fn solve(&self) -> Result<FivePoints, Unsolved> {
        let (exponents, coefficients) = self.terms();
        let terms: Vec<Term<'_>> = exponents
            .iter()
            .enumerate()
            .map(|(i, exponents)| Term {
                equation: i / TERMS,
                exponents,
            })
            .collect();
        let system = roots::System {
            variables: &VARIABLES,
            terms: &terms,
        };
        let listing = roots::solve(&system, &coefficients).map_err(Unsolved::Unlisted)?;
        let certificates: Vec<_> = listing
            .real
            .iter()
            .map(|root| self.certificate(root))
            .collect();
        let mut found = FivePoints {
            four_bars: Vec::new(),
            complex: listing.complex - listing.real.len(),
            undecided: listing.multiple,
            paths: listing.paths,
            error: 0.0,
        };
        for (i, certificate) in certificates.iter().enumerate() {
            let before = certificates[..i].iter().flatten();
            let certificate = certificate
                .as_ref()
                .filter(|certificate| certificate.real == Some(true));
            let certificate = certificate
                .filter(|certificate| before.clone().all(|other| certificate.is_apart_from(other)));
            let four_bar = certificate.map(|certificate| {
                (
                    certificate,
                    self.four_bar(&certificate.discs.map(|disc| disc.middle)),
                )
            });
            // Shown to exist; that it is the one that is returned its certificate joints show.
            match four_bar.filter(|(_, (four_bar, poses))| verify::closes(four_bar, poses)) {
                Some((certificate, four_bar)) => {
                    let joints = certificate.discs[..4].iter().map(|disc| disc.radius);
                    found.error =
                        joints.fold(found.error, |most, radius| most.max(radius * self.unit));
                    found.four_bars.push(four_bar);
                }
                None => found.undecided += 1,
            }
        }
        Ok(found)
    }

    /// Exponents and coefficients of both links at each point.
    fn terms(&self) -> (Vec<[i8; 8]>, Vec<[f64; 2]>) {
        let mut exponents = Vec::new();
        let mut coefficients = Vec::new();
        for (side, fixed) in self.fixed.iter().enumerate() {
            let a = fixed.narrow();
            for (j, shift) in self.shifts.iter().enumerate() {
                let d = shift.narrow();
                let far = d - a;
                let mut add = |coefficient: Complex, joint: Option<usize>, turn: i8| {
                    let mut monomial = [0; 8];
                    if let Some(hat) = joint {
                        monomial[2 * side + hat] = 1;
                    }
                    monomial[4 + j] = turn;
                    exponents.push(monomial);
                    coefficients.push(coefficient.into());
                };
                add(far.conjugate(), Some(0), 1);
                add(far, Some(1), -1);
                add(a.conjugate(), Some(0), 0);
                add(a, Some(1), 0);
                let rest = d.square() - 2.0 * (d * a.conjugate()).re;
                add(Complex::new(rest, 0.0), None, 0);
            }
        }
        (exponents, coefficients)
    }

    /// Values and Jacobian of both links at each point, and of the product of each turn and its
    /// inverse, in any numbers.
    fn system<T: Ring>(
        &self,
        all: &[T; ALL],
        [zero, one]: [T; 2],
        number: impl Fn(&Shift) -> dyad::Pair<T>,
    ) -> ([T; ALL], [[T; ALL]; ALL]) {
        let mut values = [zero; ALL];
        let mut matrix = [[zero; ALL]; ALL];
        for (j, shift) in self.shifts.iter().enumerate() {
            let turn = 4 + 2 * j;
            let [t, u] = [all[turn], all[turn + 1]];
            for (side, fixed) in self.fixed.iter().enumerate() {
                let (row, joint) = (3 * j + side, 2 * side);
                let [a, a_hat] = number(fixed);
                let dyad = [all[joint], all[joint + 1], a, a_hat];
                let link = dyad::link(&dyad, number(shift), [t, u]);
                values[row] = link.value;
                matrix[row][joint..joint + 2].copy_from_slice(&link.by_dyad[..2]);
                matrix[row][turn..turn + 2].copy_from_slice(&link.by_turn);
            }
            let row = 3 * j + 2;
            values[row] = t * u - one;
            matrix[row][turn..turn + 2].copy_from_slice(&[u, t]);
        }
        (values, matrix)
    }

    fn certificate(&self, root: &[[f64; 2]]) -> Option<Certificate<ALL>> {
        let number = |i: usize| Complex::from(root[i]);
        let start = core::array::from_fn(|i| match i {
            0..4 => number(i),
            _ if i % 2 == 0 => number(2 + i / 2),
            _ => number(2 + i / 2).inverse(),
        });
        let refined = self.refined(start);
        certificate::certify(&refined, self).or_else(|| certificate::certify_long(&start, self))
    }

    /// Newton's steps with residuals of twice the digits.
    fn refined(&self, start: [Complex; ALL]) -> Point<ALL> {
        let values = |all: &_| {
            let (values, _) =
                self.system(all, [ZERO, ONE].map(Complex::wide), |shift| shift.wide());
            values.map(Complex::narrow)
        };
        let plain = |shift: &Shift| shift.wide().map(Complex::narrow);
        let matrix = |all: &_| self.system(all, [ZERO, ONE], plain).1;
        certificate::refined(&start, STEPS, values, matrix).unwrap_or_else(|last| last)
    }

    fn four_bar(&self, all: &[Complex; ALL]) -> (FourBar, [Pose; 5]) {
        let position = |shift: Complex| (shift.scaled(self.unit) + self.first.into()).into();
        let four_bar = FourBar {
            fixed: self.fixed.map(|joint| position(joint.narrow())),
            moving: [all[0], all[2]].map(|joint| joint.scaled(self.unit).into()),
        };
        let poses = core::array::from_fn(|j| match j {
            0 => Pose::new(self.first, 0.0),
            _ => Pose::new(
                position(self.shifts[j - 1].narrow()),
                all[2 + 2 * j].angle(),
            ),
        });
        (four_bar, poses)
    }
}

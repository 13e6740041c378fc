//! Five poses: the equations of a dyad are linear in `k`, `X = k x`, `A = k a` and `S = k x a^`.
//! Their solutions are the points of a plane in these seven real unknowns. `k S = X A^` are two
//! conics of it (after Hayes, Luu and Chang, and Ge and Purwar, who take the conditions of all
//! dyads as one). Their four points are the dyads; `k = 0` are sliders.

use super::super::ball::Ball;
use super::super::certificate::{self, Certificate, System};
use super::super::dyad;
use super::super::error::{self, Unsolved};
use super::super::task::turn_discs;
use super::super::verify;
use super::conics::{Conic, Point, common};
use super::{Dyads, Link, Moves, Pose};
use crate::guides::{Dyad, Pivots};
use core::cmp::Ordering;
use core::f64::consts::FRAC_PI_2;
use linkage_core::numeric::complex::{Complex, ZERO};
use linkage_core::numeric::complex_matrix;
use nalgebra::{SMatrix, SVD};
use std::vec::Vec;

type Solution = dyad::Dyad<Complex>;

/// Below this, the singular values of four rows of rounded numbers say nothing.
const LEAST_RANK: f64 = 1e-12;
/// With `k` a smaller part of the others, joints are further away than the shifts by the inverse: a
/// slider within rounding.
const INFINITE: f64 = 1e-10;
const STEPS: usize = 6;

impl Dyads {
    /// All dyads that lead a body through five poses.
    ///
    /// # Errors
    ///
    /// `NotFinite`; `Equal` poses; `Dependent` poses, as those of a body that only turns about one
    /// point.
    pub fn of_poses(poses: &[Pose; 5]) -> Result<Self, Unsolved> {
        error::check(&poses.map(|pose| [pose.point[0], pose.point[1], pose.angle]))?;
        let [first, others @ ..] = poses;
        let moves = Moves::new(first, others.each_ref());
        let plane = plane(&moves)?;
        let points = common(&plane.conics());
        let mut links = Vec::new();
        let mut sliders = Vec::new();
        for point in &points {
            match plane.dyad(point) {
                LinkOrSlider::Link(dyad) => links.push(refined(&moves, dyad)),
                LinkOrSlider::Slider { x, a, s } => sliders.push(moves.slider(x, a, s)),
            }
        }
        Ok(moves.listing(links, sliders).verified(poses))
    }
}

/// A plane of vectors that meet the linear equations.
struct Plane {
    k: [f64; 3],
    x: [Complex; 3],
    a: [Complex; 3],
    s: [Complex; 3],
}

enum LinkOrSlider {
    Link(Solution),
    /// `X`, `A` and `S` with their hats, real except for a common factor. `X` or `A` is about 0.
    Slider {
        x: [Complex; 2],
        a: [Complex; 2],
        s: [Complex; 2],
    },
}

fn plane(moves: &Moves<4>) -> Result<Plane, Unsolved> {
    let mut rows = SMatrix::<f64, 7, 7>::zeros();
    for j in 0..4 {
        let (shift, turn) = (moves.shifts[j].narrow(), moves.turns[j]);
        let x = turn * shift.conjugate();
        let s = Complex::new(1.0, 0.0) - turn;
        let row = [
            shift.square(),
            2.0 * x.re,
            -2.0 * x.im,
            -2.0 * shift.re,
            -2.0 * shift.im,
            2.0 * s.re,
            -2.0 * s.im,
        ];
        for (column, value) in row.into_iter().enumerate() {
            rows[(j, column)] = value;
        }
    }
    let svd = SVD::new(rows, false, true);
    let rank = svd.singular_values[3] / svd.singular_values[0];
    let dependent = Unsolved::Dependent {
        rank,
        least: LEAST_RANK,
    };
    let vectors = svd.v_t.filter(|_| rank > LEAST_RANK).ok_or(dependent)?;
    let entry = |column: usize| [4, 5, 6].map(|row| vectors[(row, column)]);
    let complex = |column: usize| {
        let (re, im) = (entry(column), entry(column + 1));
        core::array::from_fn(|i| Complex::new(re[i], im[i]))
    };
    Ok(Plane {
        k: entry(0),
        x: complex(1),
        a: complex(3),
        s: complex(5),
    })
}

impl Dyads {
    /// Those that lead the body through all poses with the joints that are returned.
    fn verified(mut self, poses: &[Pose; 5]) -> Self {
        let count = self.real.len();
        self.real.retain(|dyad| verify::leads(dyad, poses));
        let left_out = count - self.real.len();
        self.undecided += left_out;
        self.certified &= left_out == 0;
        self
    }
}

impl Plane {
    /// Real and imaginary part of `k S - X A^`.
    fn conics(&self) -> [Conic; 2] {
        let form = |i: usize, j: usize| {
            let half = |i: usize, j: usize| {
                self.s[j].scaled(self.k[i]) - self.x[i] * self.a[j].conjugate()
            };
            (half(i, j) + half(j, i)).scaled(0.5)
        };
        let conic = |part: fn(Complex) -> f64| {
            core::array::from_fn(|i| core::array::from_fn(|j| part(form(i, j))))
        };
        [conic(|form| form.re), conic(|form| form.im)]
    }

    fn dyad(&self, w: &Point) -> LinkOrSlider {
        let product = |coefficients: [Complex; 3]| {
            let terms = coefficients.into_iter().zip(w);
            terms.fold(ZERO, |sum, (c, &w)| sum + c * w)
        };
        let k = product(self.k.map(|k| Complex::new(k, 0.0)));
        let both = |c: [Complex; 3]| [product(c), product(c.map(Complex::conjugate))];
        let ([x, x_hat], [a, a_hat]) = (both(self.x), both(self.a));
        let largest = [x, x_hat, a, a_hat]
            .map(Complex::size)
            .into_iter()
            .fold(0.0, f64::max);
        if k.size() > INFINITE * largest {
            let inverse = k.inverse();
            return LinkOrSlider::Link([x, x_hat, a, a_hat].map(|value| value * inverse));
        }
        LinkOrSlider::Slider {
            x: [x, x_hat],
            a: [a, a_hat],
            s: both(self.s),
        }
    }
}

/// Newton's steps with residuals of twice the digits.
fn refined(moves: &Moves<4>, start: Solution) -> Solution {
    let mut dyad = start;
    for _ in 0..STEPS {
        let wide = dyad.map(Complex::wide);
        let residual = |j: usize| {
            let turn = moves.turns[j];
            let turn = [turn, turn.conjugate()].map(Complex::wide);
            -dyad::value(&wide, moves.shifts[j].wide(), turn).narrow()
        };
        let mut right = [core::array::from_fn(residual)];
        let mut matrix = core::array::from_fn(|j| moves.link(&dyad, j).by_dyad);
        if complex_matrix::solve_scaled(&mut matrix, &mut right) == 0.0 {
            return start;
        }
        dyad = core::array::from_fn(|i| dyad[i] + right[0][i]);
    }
    dyad
}

impl System<4> for Moves<4> {
    fn values(&self, point: &certificate::Point<4>) -> [Ball; 4] {
        self.discs(&point.map(Ball::from_wide))
            .map(|link| link.value)
    }

    fn matrix(&self, discs: &[Ball; 4]) -> [[Ball; 4]; 4] {
        self.discs(discs).map(|link| link.by_dyad)
    }
}

impl Moves<4> {
    fn discs(&self, dyad: &dyad::Dyad<Ball>) -> [Link<Ball>; 4] {
        core::array::from_fn(|j| {
            let turn = turn_discs(self.turns[j]);
            dyad::link(dyad, self.shifts[j].discs(), turn)
        })
    }

    fn slider(&self, x: [Complex; 2], a: [Complex; 2], s: [Complex; 2]) -> Dyad {
        // The normal of the line, without the common factor.
        let normal = |[value, hat]: [Complex; 2]| (value * (value * hat).root().inverse()).angle();
        let nowhere = Complex::new(0.0, 0.0);
        if a[0].square() > x[0].square() {
            let moving = s[0] * a[1].inverse();
            Dyad::PointOnLine {
                moving: self.pivots(moving, nowhere).moving,
                angle: normal(a) + FRAC_PI_2,
            }
        } else {
            let fixed = s[1] * x[1].inverse();
            Dyad::LineThroughPoint {
                fixed: self.pivots(nowhere, fixed).fixed,
                angle: normal(x) + FRAC_PI_2 - self.first.angle,
            }
        }
    }

    fn listing(&self, links: Vec<Solution>, sliders: Vec<Dyad>) -> Dyads {
        let found = links.len() + sliders.len();
        let mut dyads = Dyads {
            real: sliders,
            complex: 0,
            undecided: 4_usize.saturating_sub(found),
            certified: true,
            error: 0.0,
        };
        let certificates: Vec<_> = links
            .iter()
            .map(|link| certificate::certify(&link.map(Complex::wide), self))
            .collect();
        for (i, certificate) in certificates.iter().enumerate() {
            let others = certificates.iter().enumerate().filter(|&(j, _)| j != i);
            let distinct = |certificate: &Certificate<4>| {
                others
                    .flat_map(|(_, other)| other)
                    .all(|other| certificate.is_apart_from(other))
            };
            let certificate = certificate
                .as_ref()
                .filter(|certificate| distinct(certificate));
            match certificate
                .and_then(|certificate| certificate.real.map(|real| (certificate, real)))
            {
                Some((certificate, true)) => {
                    let [x, _, a, _] = certificate.discs;
                    let pivots = self.pivots(x.middle, a.middle);
                    dyads.error = dyads.error.max(x.radius.max(a.radius) * self.unit);
                    dyads.real.push(Dyad::Link(pivots));
                }
                Some((_, false)) => dyads.complex += 1,
                None => dyads.undecided += 1,
            }
        }
        let shown = dyads.links().count() + dyads.complex;
        dyads.certified = shown == 4;
        dyads
            .real
            .sort_by(|a, b| order(a).partial_cmp(&order(b)).unwrap_or(Ordering::Equal));
        dyads
    }
}

/// Links in ascending order of the fixed joint, then sliders.
fn order(dyad: &Dyad) -> (bool, [f64; 2]) {
    match dyad {
        Dyad::Link(Pivots { fixed, .. }) => (false, *fixed),
        Dyad::PointOnLine { moving, .. } => (true, *moving),
        Dyad::LineThroughPoint { fixed, .. } => (true, *fixed),
    }
}

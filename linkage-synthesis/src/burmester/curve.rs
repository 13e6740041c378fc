//! Four poses: the joints of the frame are the points of a cubic curve, the centre-point curve.
//!
//! To a joint `a` of the frame belong three equations `c x + c^ x^ + e = 0` of the joint of the
//! body. They have a solution where the determinant of their coefficients is 0, which is of the
//! third degree in `a`. The pole of two poses is on the curve, so that each line through it meets
//! the curve in two points more, which are roots of a quadratic.

use super::super::Pose;
use super::super::error::{self, Unsolved};
use super::super::polynomial::{add_product, roots};
use super::super::verify;
use super::Moves;
use crate::guides::Pivots;
use core::f64::consts::PI;
use linkage_core::numeric::complex::{Complex, ZERO};
use std::vec::Vec;

/// The curve of all joints of the frame whose links lead a body through four poses.
pub struct CentreCurve {
    moves: Moves<3>,
    poses: [Pose; 4],
    /// The pole of the first pose and of another one.
    pole: Complex,
}

/// A point of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentrePoint {
    /// The joints.
    pub pivots: Pivots,
    /// Angle of the line from the pole, rad, from 0 to pi.
    pub angle: f64,
}

/// Turns below this have their pole further away than rounding knows.
const LEAST_TURN: f64 = 1e-9;
/// Coefficients of `x`, `x^` and 1 on a line, linear in the way along it.
type Row = [[Complex; 2]; 3];

impl CentreCurve {
    /// The curve for four poses.
    ///
    /// # Errors
    ///
    /// `NotFinite`, `Equal` poses; `AtInfinity` if all poses are parallel to the first one.
    pub fn of_poses(poses: &[Pose; 4]) -> Result<Self, Unsolved> {
        error::check(&poses.map(|pose| [pose.point[0], pose.point[1], pose.angle]))?;
        let [first, others @ ..] = poses;
        let moves = Moves::new(first, others.each_ref());
        let one_less = |j: &usize| (Complex::new(1.0, 0.0) - moves.turns[*j]).square();
        let most = (0..3).max_by(|a, b| one_less(a).total_cmp(&one_less(b)));
        let most = most
            .filter(|j| one_less(j) > LEAST_TURN * LEAST_TURN)
            .ok_or(Unsolved::AtInfinity)?;
        let back = (Complex::new(1.0, 0.0) - moves.turns[most]).inverse();
        let pole = moves.shifts[most].narrow() * back;
        let poses = *poses;
        Ok(Self { moves, poses, pole })
    }

    /// The pole through which the lines of [`CentreCurve::points_at`] go: where the body turns
    /// about from the first pose to another one.
    #[must_use]
    pub fn pole(&self) -> [f64; 2] {
        self.moves.pivots(ZERO, self.pole).fixed
    }

    /// The points on the line through the pole at this angle (rad) beside the pole: two or none;
    /// one, if the curve goes to infinity there.
    #[must_use]
    pub fn points_at(&self, angle: f64) -> Vec<CentrePoint> {
        let direction = Complex::polar(angle);
        // The pole itself is on the curve: the rest are the terms of the first degree and above.
        let [_, rest @ ..] = self.along(self.pole, direction);
        let [low, middle, high] = rest.map(|coefficient| coefficient.im);
        let discriminant = middle * middle - 4.0 * low * high;
        if discriminant < 0.0 {
            return Vec::new();
        }
        let larger = -0.5 * (middle + discriminant.sqrt().copysign(middle));
        let ways = [low / larger, larger / high];
        let ways = ways.into_iter().filter(|way| way.is_finite());
        ways.filter_map(|way| self.point(self.pole + direction.scaled(way), angle))
            .collect()
    }

    /// Points on lines of so many angles, which together show the curve.
    #[must_use]
    pub fn points(&self, angles: usize) -> Vec<CentrePoint> {
        let angle = |i: usize| PI * (i as f64 + 0.5) / angles as f64;
        (0..angles).flat_map(|i| self.points_at(angle(i))).collect()
    }

    /// The points on a straight line of the frame, through `point` at `angle` (rad): one or three,
    /// in their order along it.
    #[must_use]
    pub fn on_line(&self, point: [f64; 2], angle: f64) -> Vec<CentrePoint> {
        let direction = Complex::polar(angle);
        let unit = 1.0 / self.moves.unit;
        let start = (Complex::from(point) - self.moves.first.point.into()).scaled(unit);
        let cubic = self
            .along(start, direction)
            .map(|c| Complex::new(c.im, 0.0));
        // Complex roots come in pairs as exact as roots are: a root is real that is nearer to its
        // conjugate than that.
        const REAL: f64 = 1e-7;
        let found = roots(&cubic);
        let real = found
            .iter()
            .filter(|root| root.im.abs() < REAL * root.size().max(1.0));
        let mut ways: Vec<f64> = real.map(|root| root.re).collect();
        ways.sort_by(f64::total_cmp);
        let places = ways.into_iter().map(|way| start + direction.scaled(way));
        places
            .filter_map(|point| self.point(point, (point - self.pole).angle().rem_euclid(PI)))
            .collect()
    }

    /// The determinant along a line, as a polynomial in the way. It is imaginary.
    fn along(&self, start: Complex, direction: Complex) -> [Complex; 4] {
        let rows: [Row; 3] = core::array::from_fn(|j| {
            let (shift, turn) = (self.moves.shifts[j].narrow(), self.moves.turns[j]);
            let less = Complex::new(1.0, 0.0) - turn;
            let at_start = turn * shift.conjugate() + less * start.conjugate();
            let slope = less * direction.conjugate();
            let real = |value: f64| Complex::new(value, 0.0);
            let rest = shift.square() - 2.0 * (shift.conjugate() * start).re;
            let rest_slope = -2.0 * (shift.conjugate() * direction).re;
            [
                [at_start, slope],
                [at_start.conjugate(), slope.conjugate()],
                [real(rest), real(rest_slope)],
            ]
        });
        let mut determinant = [ZERO; 4];
        let cycles = [([0, 1, 2], 1.0), ([1, 2, 0], 1.0), ([2, 0, 1], 1.0)];
        let swapped = [([0, 2, 1], -1.0), ([1, 0, 2], -1.0), ([2, 1, 0], -1.0)];
        for ([a, b, c], sign) in cycles.into_iter().chain(swapped) {
            add_product(
                &mut determinant,
                [&rows[0][a], &rows[1][b], &rows[2][c]],
                sign,
            );
        }
        determinant
    }

    /// The joint of the body belongs to it; nothing if that is at infinity, or keeps its distance
    /// in three of the four poses only.
    fn point(&self, fixed: Complex, angle: f64) -> Option<CentrePoint> {
        // The two equations of three whose lines cross best.
        let pairs = [[0, 1], [1, 2], [2, 0]];
        let lines: [Complex; 3] = core::array::from_fn(|j| {
            let (shift, turn) = (self.moves.shifts[j].narrow(), self.moves.turns[j]);
            turn * (shift - fixed).conjugate() + fixed.conjugate()
        });
        let crossing = |[i, j]: &[usize; 2]| (lines[*i] * lines[*j].conjugate()).im.abs();
        let best = pairs
            .into_iter()
            .max_by(|a, b| crossing(a).total_cmp(&crossing(b)))?;
        let moving = self.moves.moving(fixed, best)?;
        let pivots = self.moves.pivots(moving, fixed);
        let keeps = verify::keeps_length(&pivots, &self.poses);
        keeps.then_some(CentrePoint { pivots, angle })
    }
}

//! The equations of nine points: for both links at each point but the first, and for the turn of
//! the coupler there.
//!
//! Unknown are the joints `x`, `a` of one link and `y`, `b` of the other one with their hats, and
//! at each point the turn `t` and its inverse `u`: 24 equations of the third degree. The two
//! unknowns of a turn are in three equations only, so that eight equations are left for the joints.

use super::super::dyad::{self, Link, Pair};
use super::super::path::Step;
use linkage_core::numeric::complex::{Complex, ONE, Ring, ZERO};
use linkage_core::numeric::complex_matrix;

/// Shifts of the points after the first one, with hats.
pub(super) type Shifts<T> = [Pair<T>; 8];
/// All unknowns: `x`, `x^`, `a`, `a^`, `y`, `y^`, `b`, `b^`, then `t`, `u` of each point.
pub(super) type Unknowns<T> = [T; ALL];

pub(super) const ALL: usize = 24;
const JOINTS: usize = 8;

#[inline(always)]
fn links<T: Ring>(unknowns: &Unknowns<T>, shifts: &Shifts<T>, j: usize) -> ([Link<T>; 2], Pair<T>) {
    let turn = [unknowns[JOINTS + 2 * j], unknowns[JOINTS + 2 * j + 1]];
    let [x, x_hat, a, a_hat, y, y_hat, b, b_hat, ..] = *unknowns;
    let first = dyad::link(&[x, x_hat, a, a_hat], shifts[j], turn);
    let second = dyad::link(&[y, y_hat, b, b_hat], shifts[j], turn);
    ([first, second], turn)
}

/// A step from `unknowns` where the shifts are these and move by `drift`.
#[inline(never)]
pub(super) fn newton(
    unknowns: &Unknowns<Complex>,
    shifts: &Shifts<Complex>,
    drift: &Shifts<Complex>,
) -> Step<ALL> {
    let mut matrix = [[ZERO; JOINTS]; JOINTS];
    let mut right = [[ZERO; JOINTS]; 2];
    let turned: [Turn; 8] = core::array::from_fn(|j| Turn::new(unknowns, shifts, drift, j));
    for (j, turn) in turned.iter().enumerate() {
        matrix[j] = turn.row();
        right[0][j] = turn.without(turn.values, turn.value);
        right[1][j] = turn.without(turn.drifts, ZERO);
    }
    let singular = complex_matrix::solve_scaled(&mut matrix, &mut right) == 0.0;
    let [step, tangent] = right;
    let mut result = Step {
        to: *unknowns,
        tangent: [ZERO; ALL],
        singular,
    };
    for i in 0..JOINTS {
        result.to[i] = unknowns[i] + step[i];
        result.tangent[i] = tangent[i];
    }
    for (j, turn) in turned.iter().enumerate() {
        let steps = turn.steps(&step, turn.values, turn.value);
        let tangents = turn.steps(&tangent, turn.drifts, ZERO);
        for k in 0..2 {
            let i = JOINTS + 2 * j + k;
            result.to[i] = unknowns[i] + steps[k];
            result.tangent[i] = tangents[k];
        }
    }
    result
}

/// The three equations of a point, and how the turn is eliminated.
struct Turn {
    by_joints: [[Complex; 4]; 2],
    by_turn: [Pair<Complex>; 2],
    turn: Pair<Complex>,
    values: Pair<Complex>,
    value: Complex,
    /// Derivatives by the parameter of the path.
    drifts: Pair<Complex>,
    /// Factors of the three equations with which the unknowns of the turn vanish from their sum.
    factors: [Complex; 3],
}

impl Turn {
    #[inline(always)]
    fn new(
        unknowns: &Unknowns<Complex>,
        shifts: &Shifts<Complex>,
        drift: &Shifts<Complex>,
        j: usize,
    ) -> Self {
        let (links, [t, u]) = links(unknowns, shifts, j);
        let [[a, b], [c, d]] = [links[0].by_turn, links[1].by_turn];
        let along =
            |link: &Link<Complex>| link.by_shift[0] * drift[j][0] + link.by_shift[1] * drift[j][1];
        Self {
            by_joints: [links[0].by_dyad, links[1].by_dyad],
            by_turn: [[a, b], [c, d]],
            turn: [t, u],
            values: [links[0].value, links[1].value],
            value: t * u - ONE,
            drifts: [along(&links[0]), along(&links[1])],
            factors: [c * t - u * d, u * b - a * t, a * d - c * b],
        }
    }

    #[inline(always)]
    fn row(&self) -> [Complex; JOINTS] {
        let [first, second] = self.by_joints;
        core::array::from_fn(|k| match k {
            0..4 => self.factors[0] * first[k],
            _ => self.factors[1] * second[k - 4],
        })
    }

    /// The right side that is left.
    #[inline(always)]
    fn without(&self, [first, second]: Pair<Complex>, third: Complex) -> Complex {
        let [p, q, r] = self.factors;
        -(p * first + q * second + r * third)
    }

    /// Steps of the turn and its inverse to steps of the joints.
    #[inline(always)]
    fn steps(
        &self,
        joints: &[Complex; JOINTS],
        values: Pair<Complex>,
        value: Complex,
    ) -> Pair<Complex> {
        // The link with the larger factor gives more digits.
        let [p, q, _] = self.factors;
        let side = usize::from(p.square() > q.square());
        let known = self.by_joints[side].iter().zip(&joints[4 * side..]);
        let right = known.fold(-values[side], |rest, (&by, &step)| rest - by * step);
        let ([a, b], [t, u]) = (self.by_turn[side], self.turn);
        let inverse = (a * t - b * u).inverse();
        [
            (right * t + b * value) * inverse,
            -(a * value + u * right) * inverse,
        ]
    }
}

/// Values and Jacobian of all equations, in any numbers.
pub(super) fn all<T: Ring>(
    unknowns: &Unknowns<T>,
    shifts: &Shifts<T>,
    [zero, one]: [T; 2],
) -> (Unknowns<T>, [[T; ALL]; ALL]) {
    let mut values = [zero; ALL];
    let mut matrix = [[zero; ALL]; ALL];
    for j in 0..8 {
        let (links, [t, u]) = links(unknowns, shifts, j);
        let column = JOINTS + 2 * j;
        for (side, link) in links.iter().enumerate() {
            let row = 3 * j + side;
            values[row] = link.value;
            matrix[row][4 * side..4 * side + 4].copy_from_slice(&link.by_dyad);
            matrix[row][column..column + 2].copy_from_slice(&link.by_turn);
        }
        let row = 3 * j + 2;
        values[row] = t * u - one;
        matrix[row][column..column + 2].copy_from_slice(&[u, t]);
    }
    (values, matrix)
}

/// The turns to given joints, from the equations of the links, which are linear in them.
pub(super) fn with_turns(
    joints: &[Complex; JOINTS],
    shifts: &Shifts<Complex>,
) -> Unknowns<Complex> {
    let mut unknowns = [ZERO; ALL];
    unknowns[..JOINTS].copy_from_slice(joints);
    for j in 0..8 {
        let (links, _) = links(&unknowns, shifts, j);
        let [[a, b], [c, d]] = [links[0].by_turn, links[1].by_turn];
        let [e, f] = [links[0].value, links[1].value];
        let inverse = (a * d - b * c).inverse();
        unknowns[JOINTS + 2 * j] = (b * f - d * e) * inverse;
        unknowns[JOINTS + 2 * j + 1] = (c * e - a * f) * inverse;
    }
    unknowns
}

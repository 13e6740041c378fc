//! Scalars that may be angles: linear in driving and unknown angles, so that directions need no arc tangent.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, V2, Vector};

use super::Algebra;

/// Powers of a unit vector up to this one are products; beyond, the angle itself is cheaper.
const MAX_POWER: f64 = 8.0;

/// An angle that a direction can be built from without knowing its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Atom {
    Input(usize),
    /// Index of an unknown angle of the algebra.
    Angle(usize),
}

/// `sum of coefficient * atom + rest`; atoms in order, coefficients never 0. Anything that is no angle has no atoms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scalar<'m> {
    pub(crate) terms: Vec<(Atom, f64)>,
    pub(crate) rest: Ex<'m>,
}

impl<'m> From<Ex<'m>> for Scalar<'m> {
    fn from(rest: Ex<'m>) -> Self {
        Self {
            terms: Vec::new(),
            rest,
        }
    }
}

impl Scalar<'_> {
    pub(crate) fn coefficient(&self, atom: Atom) -> f64 {
        self.terms
            .iter()
            .find(|(a, _)| *a == atom)
            .map_or(0.0, |(_, k)| *k)
    }

    /// `self + sign other`
    #[must_use]
    pub(crate) fn combined(&self, other: &Self, sign: f64) -> Self {
        let mut terms = self.terms.clone();
        for &(atom, k) in &other.terms {
            match terms.iter_mut().find(|(other, _)| *other == atom) {
                Some((_, old)) => *old += sign * k,
                None => terms.push((atom, sign * k)),
            }
        }
        terms.retain(|(_, k)| *k != 0.0);
        terms.sort_by_key(|(atom, _)| *atom);
        let rest = if sign > 0.0 {
            self.rest + other.rest
        } else {
            self.rest - other.rest
        };
        Self { terms, rest }
    }

    /// `factor self`
    #[must_use]
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let terms = self.terms.iter();
        let terms = terms.map(|&(atom, k)| (atom, factor * k));
        Self {
            terms: terms.filter(|(_, k)| *k != 0.0).collect(),
            rest: factor * self.rest,
        }
    }
}

pub(crate) fn atom<'m>(algebra: &Algebra<'m>, atom: Atom) -> Scalar<'m> {
    Scalar {
        terms: vec![(atom, 1.0)],
        rest: algebra.zero(),
    }
}

/// The value as one expression; unknown angles enter by their values.
pub(crate) fn value_of<'m>(algebra: &Algebra<'m>, scalar: &Scalar<'m>) -> Ex<'m> {
    let mut sum = scalar.rest;
    for &(atom, k) in &scalar.terms {
        let value = match atom {
            Atom::Input(index) => algebra.input(index),
            Atom::Angle(index) => algebra.names.angles[index].number,
        };
        sum += k * value;
    }
    sum
}

/// Cosine and sine.
pub(crate) fn direction<'m>(algebra: &mut Algebra<'m>, angle: &Scalar<'m>) -> V2<'m> {
    let mut rest = Scalar::from(angle.rest);
    let mut result = Vector([algebra.one(), algebra.zero()]);
    for &(atom, k) in &angle.terms {
        match atom {
            Atom::Input(index) => {
                algebra.names.add_rate(atom, k);
                let turned = cos_sin(k * algebra.input(index));
                result = result.turned(turned);
            }
            Atom::Angle(index) if k.fract() == 0.0 && k.abs() <= MAX_POWER => {
                let power = unit_power(algebra, index, k as i32);
                result = result.turned(power);
            }
            Atom::Angle(_) => rest.terms.push((atom, k)),
        }
    }
    let argument = value_of(algebra, &rest);
    let unit = cos_sin(argument).turned(result);
    unit.mark_unit();
    unit
}

/// The unit vector of an unknown angle to an integer power.
fn unit_power<'m>(algebra: &Algebra<'m>, angle: usize, power: i32) -> V2<'m> {
    let unit = algebra.names.angles[angle].unit;
    let unit = match power < 0 {
        true => unit.conjugate(),
        false => unit,
    };
    (1..power.unsigned_abs()).fold(unit, |product, _| product.turned(unit))
}

/// Cosine and sine of an expression. Quarter turns are exact, also as summands, and the argument of a vector is not taken
/// to be undone.
fn cos_sin(argument: Ex) -> V2 {
    if let Some(value) = argument.constant_value() {
        return numbers(argument, cos_sin_exact(value));
    }
    if let Some((rest, turn)) = without_quarter_turns(argument) {
        return cos_sin(rest).turned(numbers(argument, turn));
    }
    undone(argument).unwrap_or_else(|| {
        let [cos, sin] = [Unary::Cos, Unary::Sin].map(|op| argument.unary(op));
        Vector([cos, sin])
    })
}

fn numbers<'m>(beside: Ex<'m>, values: [f64; 2]) -> V2<'m> {
    Vector(values.map(|value| beside.number(value)))
}

/// Cosine and sine of the argument of a vector, or of an angle in a triangle, without any arc function; also as a summand.
fn undone(argument: Ex) -> Option<V2> {
    let ex = |id| argument.graph().ex(id);
    match argument.node() {
        Node::Binary(Binary::Atan2, y, x) => {
            let v = Vector([ex(x), ex(y)]);
            Some(v / v.length())
        }
        Node::Binary(Binary::Mul, a, b) => {
            let two = |x: Ex| x.constant_value() == Some(2.0);
            let half = match (two(ex(a)), two(ex(b))) {
                (true, _) => ex(b),
                (_, true) => ex(a),
                _ => return None,
            };
            let Node::Unary(Unary::Atan, tangent) = half.node() else {
                return None;
            };
            Some(turned_by_half_tangent(ex(tangent)))
        }
        Node::Unary(Unary::Neg, x) => Some(undone(ex(x))?.conjugate()),
        Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
            let [a, b] = [a, b].map(ex);
            let (first, second) = match (undone(a), undone(b)) {
                (None, None) => return None,
                (Some(first), Some(second)) => (first, second),
                (Some(first), None) => (first, cos_sin(b)),
                (None, Some(second)) => (cos_sin(a), second),
            };
            Some(first.turned(match op {
                Binary::Sub => second.conjugate(),
                _ => second,
            }))
        }
        _ => None,
    }
}

/// `(1 - t^2)/(1 + t^2)` and `2 t/(1 + t^2)`
fn turned_by_half_tangent(tangent: Ex) -> V2 {
    let square = tangent.square();
    let (above, below) = (1.0 - square, 1.0 + square);
    Vector([above, 2.0 * tangent]) / below
}

/// An angle without a summand of whole quarter turns, and the unit vector of that summand.
fn without_quarter_turns(angle: Ex) -> Option<(Ex, [f64; 2])> {
    let ex = |id| angle.graph().ex(id);
    let turns = |x: Ex| x.constant_value().and_then(quarter_turns);
    match angle.node() {
        Node::Unary(Unary::Neg, x) => {
            let (rest, [cos, sin]) = without_quarter_turns(ex(x))?;
            Some((-rest, [cos, -sin]))
        }
        Node::Binary(Binary::Add, x, y) => {
            let [x, y] = [x, y].map(ex);
            match (turns(x), turns(y)) {
                (Some(turn), _) => Some((y, turn)),
                (_, turn) => Some((x, turn?)),
            }
        }
        Node::Binary(Binary::Sub, x, y) => {
            let [x, y] = [x, y].map(ex);
            match (turns(x), turns(y)) {
                (Some(turn), _) => Some((-y, turn)),
                (_, turn) => turn.map(|[cos, sin]| (x, [cos, -sin])),
            }
        }
        _ => None,
    }
}

/// Cosine and sine of a constant; multiples of a quarter turn give 0 and 1 exactly.
fn cos_sin_exact(angle: f64) -> [f64; 2] {
    quarter_turns(angle).unwrap_or([angle.cos(), angle.sin()])
}

/// Cosine and sine of an angle that is a multiple of a quarter turn.
fn quarter_turns(angle: f64) -> Option<[f64; 2]> {
    use std::f64::consts::FRAC_PI_2;
    let quarters = (angle / FRAC_PI_2).round();
    let is_multiple = (angle - quarters * FRAC_PI_2).abs() <= f64::EPSILON * angle.abs();
    (quarters.abs() < 1e6 && is_multiple).then_some(match (quarters as i64).rem_euclid(4) {
        0 => [1.0, 0.0],
        1 => [0.0, 1.0],
        2 => [-1.0, 0.0],
        _ => [0.0, -1.0],
    })
}

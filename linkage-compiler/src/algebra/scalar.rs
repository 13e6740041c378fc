//! Scalars that may be angles: linear in driving and unknown angles, so that directions need no arc
//! tangent.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Graph, Node, V2, Vector, Vn};

use crate::algebra::names::Names;
use crate::algebra::value::{Atom, Scalar, Value};

/// Powers of a unit vector up to this one are products; beyond, the angle itself is cheaper.
const MAX_POWER: f64 = 8.0;

pub(crate) fn atom<'m>(graph: &'m Graph, atom: Atom) -> Scalar<'m> {
    Scalar {
        terms: vec![(atom, 1.0)],
        rest: graph.number(0.0),
    }
}

/// The value as one expression; unknown angles enter by their values.
pub(crate) fn value_of<'m>(names: &Names<'m>, scalar: &Scalar<'m>) -> Ex<'m> {
    let mut sum = scalar.rest;
    for &(atom, k) in &scalar.terms {
        let value = match atom {
            Atom::Input(index) => names.input(index),
            Atom::Angle(index) => names.angles[index].number,
        };
        sum += k * value;
    }
    sum
}

/// Cosine and sine.
pub(crate) fn direction<'m>(names: &mut Names<'m>, angle: &Scalar<'m>) -> V2<'m> {
    let mut rest = Scalar::from(angle.rest);
    let mut result = Vector([names.one(), names.zero()]);
    for &(atom, k) in &angle.terms {
        match atom {
            Atom::Input(index) => {
                names.add_rate(atom, k);
                result = result.turned(unit_of_input(names, index, k));
            }
            Atom::Angle(index) if k.fract() == 0.0 && k.abs() <= MAX_POWER => {
                let power = unit_power(names, index, k as i32);
                result = result.turned(power);
            }
            Atom::Angle(_) => rest.terms.push((atom, k)),
        }
    }
    let argument = value_of(names, &rest);
    let unit = cos_sin(argument).turned(result);
    unit.mark_unit();
    unit
}

/// The unit vector of a multiple of an input.
pub(crate) fn unit_of_input<'m>(names: &Names<'m>, index: usize, factor: f64) -> V2<'m> {
    cos_sin(factor * names.input(index))
}

/// The unit vector of an unknown angle to an integer power.
fn unit_power<'m>(names: &Names<'m>, angle: usize, power: i32) -> V2<'m> {
    let unit = names.angles[angle].unit;
    let unit = if power < 0 { unit.conjugate() } else { unit };
    (1..power.unsigned_abs()).fold(unit, |product, _| product.turned(unit))
}

/// Cosine and sine of an expression. Quarter turns are exact, also as summands, and the argument of
/// a vector is not taken to be undone.
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

/// Cosine and sine of the argument of a vector, or of an angle in a triangle, without any arc
/// function; also as a summand.
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
    quarter_turns(angle).unwrap_or([Unary::Cos, Unary::Sin].map(|function| function.apply([angle])))
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

/// A scalar value as one expression.
pub(crate) fn number<'m>(names: &Names<'m>, value: &Value<'m>) -> Ex<'m> {
    match value {
        Value::Scalar(scalar) => value_of(names, scalar),
        Value::Vector(vector) => vector.at(0),
        Value::Array(entries) => number(names, &entries[0]),
    }
}

pub(crate) fn scalar<'m>(names: &Names<'m>, value: &Value<'m>) -> Scalar<'m> {
    match value {
        Value::Scalar(scalar) => scalar.clone(),
        other => number(names, other).into(),
    }
}

/// A vector value; a scalar (the literal 0 where a vector is meant) has two equal components.
pub(crate) fn vector<'m>(names: &Names<'m>, value: &Value<'m>) -> Vn<'m> {
    match value {
        Value::Vector(vector) => *vector,
        other => {
            let number = number(names, other).id();
            names.graph.components(&[number, number])
        }
    }
}

//! The functions of the language.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Graph, V2, V3, Vector, Vn};

use crate::algebra::names::Names;
use crate::algebra::value::Value;
use crate::algebra::{frame, scalar, vanish};
use crate::model::Function;

pub(crate) fn call<'m>(
    names: &mut Names<'m>,
    function: Function,
    arguments: Vec<Value<'m>>,
) -> Value<'m> {
    use Function::*;
    let number = |k: usize| scalar::number(names, &arguments[k]);
    let vector = |k: usize| scalar::vector(names, &arguments[k]);
    match function {
        Polar => {
            let length = number(0);
            in_plane(length * direction_of(names, &arguments[1]))
        }
        Dir => in_plane(direction_of(names, &arguments[0])),
        Rotate => {
            let v = vector(0);
            let unit = direction_of(names, &arguments[1]);
            in_plane(plane(v).turned(unit))
        }
        Turn => {
            let (v, axis) = (spatial(vector(0)), spatial(vector(1)));
            turn(names, v, axis, &arguments[2])
        }
        Dot => {
            let (a, b) = (vector(0), vector(1));
            match (a.in_space(), b.in_space()) {
                (Some(a), Some(b)) => a.product(b).into(),
                _ => a.dot(b).into(),
            }
        }
        Cross => {
            let (a, b) = (vector(0), vector(1));
            match a.len().max(b.len()) {
                2 => plane(a).cross(plane(b)).into(),
                _ => in_space(spatial(a).cross(spatial(b))),
            }
        }
        Norm => vector(0).length().into(),
        Distance => (vector(0) - vector(1)).length().into(),
        Unit => {
            let v = vector(0);
            match v.in_space() {
                Some(v) => in_space(frame::unit_in_space(names, v)),
                None => in_plane(plane(v).length_and_unit().1),
            }
        }
        Angle => {
            let v = plane(vector(0));
            v[1].atan2(v[0]).into()
        }
        TriangleAngle => triangle_angle([0, 1, 2].map(number)).into(),
        Sin => direction_of(names, &arguments[0])[1].into(),
        Cos => direction_of(names, &arguments[0])[0].into(),
        Tan => {
            let unit = direction_of(names, &arguments[0]);
            (unit[1] / unit[0]).into()
        }
        Asin => number(0).unary(Unary::Asin).into(),
        Acos => number(0).unary(Unary::Acos).into(),
        Atan => number(0).unary(Unary::Atan).into(),
        Sqrt => square_root(names.graph, number(0)).into(),
        Abs => number(0).abs().into(),
        Atan2 => binary(Binary::Atan2, [0, 1].map(number)),
        Min => binary(Binary::Min, [0, 1].map(number)),
        Max => binary(Binary::Max, [0, 1].map(number)),
        Hypot => Vector([0, 1].map(number)).length().into(),
        Frame => frame::frame(names, &arguments),
        PointIn => frame::point_in(names, &arguments),
        CoordinatesIn => frame::coordinates_in(names, &arguments),
    }
}

fn direction_of<'m>(names: &mut Names<'m>, angle: &Value<'m>) -> V2<'m> {
    let angle = scalar::scalar(names, angle);
    scalar::direction(names, &angle)
}

/// The root of `v . v` is known as a length.
fn square_root<'m>(graph: &'m Graph, square: Ex<'m>) -> Ex<'m> {
    match graph.vector_of_square(square.id()) {
        Some(vector) if vector.len() == 3 => graph.components(&vector).length(),
        _ => square.sqrt(),
    }
}

/// Rodrigues: `v cos + (k x v) sin + k (k . v) (1 - cos)` about the unit axis `k`.
fn turn<'m>(names: &mut Names<'m>, v: V3<'m>, axis: V3<'m>, angle: &Value<'m>) -> Value<'m> {
    let axis = axis.unit();
    let Vector([cos, sin]) = direction_of(names, angle);
    let along = axis.dot(v);
    let sideways = axis.cross(v);
    let (turning, sideways, along) = if vanish::vanishes(along) {
        (v, sideways, names.zero())
    } else if v.is_fixed() && axis.is_fixed() {
        // Only the part of a prepared vector across the axis turns: the rest of a long part along
        // it by rounding would tilt the circle.
        let across = sideways.cross(axis);
        (across, axis.cross(across), along)
    } else {
        let versine = 1.0 - cos;
        (v, sideways, along * versine)
    };
    let turned = Vector([0, 1, 2].map(|k| {
        let terms = [turning[k] * cos, sideways[k] * sin, axis[k] * along];
        terms[0] + terms[1] + terms[2]
    }));
    if v.is_unit() {
        turned.mark_unit();
    }
    in_space(turned)
}

fn in_plane(v: V2) -> Value {
    Value::Vector(v.into())
}

fn in_space(v: V3) -> Value {
    Value::Vector(v.into())
}

/// The two components of a plane vector.
fn plane(v: Vn) -> V2 {
    Vector([v.at(0), v.at(1)])
}

/// The three components of a space vector.
fn spatial(v: Vn) -> V3 {
    Vector([v.at(0), v.at(1), v.at(2)])
}

fn binary<'m>(op: Binary, [a, b]: [Ex<'m>; 2]) -> Value<'m> {
    a.binary(op, b).into()
}

/// The angle between the first two sides, opposite to the last, by Kahan's formula, which needle
/// triangles do not hurt (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle").
fn triangle_angle([first, second, c]: [Ex; 3]) -> Ex {
    let a = first.max(second);
    let b = first.min(second);
    let a_minus_b = a - b;
    let a_minus_c = a - c;
    let b_minus_c = b - c;
    let short_c = c - a_minus_b;
    let short_b = b - a_minus_c;
    let smallest = b_minus_c.select(short_c, short_b);
    let numerator = (a_minus_b + c) * smallest;
    let perimeter = a + (b + c);
    let denominator = perimeter * (a_minus_c + b);
    let tangent = (numerator / denominator).sqrt();
    2.0 * tangent.unary(Unary::Atan)
}

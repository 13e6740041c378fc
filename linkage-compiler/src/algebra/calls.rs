//! The functions of the language.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::{Binary, Ternary, Unary};

use crate::model::Function;

use super::{Algebra, Scalar, Value};

impl Algebra<'_> {
    pub(crate) fn call(&mut self, function: Function, arguments: Vec<Value>) -> Value {
        use Function::*;
        match function {
            Polar => {
                let length = self.as_node(&arguments[0]);
                let unit = self.direction_of(&arguments[1]);
                Value::Vector(unit.map(|x| self.graph.mul(length, x)).to_vec())
            }
            Dir => Value::Vector(self.direction_of(&arguments[0]).to_vec()),
            Rotate => {
                let v = self.components(&arguments[0]);
                let unit = self.direction_of(&arguments[1]);
                Value::Vector(self.complex_product([v[0], v[1]], unit).to_vec())
            }
            Turn => self.turn(&arguments),
            Dot => {
                let (a, b) = (
                    self.components(&arguments[0]),
                    self.components(&arguments[1]),
                );
                Value::Scalar(self.dot(&a, &b).into())
            }
            Cross => self.cross_call(&arguments),
            Norm => {
                let v = self.components(&arguments[0]);
                Value::Scalar(self.length(&v).into())
            }
            Distance => {
                let (a, b) = (
                    self.components(&arguments[0]),
                    self.components(&arguments[1]),
                );
                let difference = self.difference(&a, &b);
                Value::Scalar(self.length(&difference).into())
            }
            Unit => {
                let v = self.components(&arguments[0]);
                let unit = match v[..] {
                    [x, y, z] => self.unit_vector([x, y, z]).to_vec(),
                    _ => self.length_and_unit([v[0], v[1]]).1.to_vec(),
                };
                Value::Vector(unit)
            }
            Angle => {
                let v = self.components(&arguments[0]);
                Value::Scalar(self.graph.binary(Binary::Atan2, v[1], v[0]).into())
            }
            TriangleAngle => self.triangle_angle(&arguments),
            Sin => self.trigonometric(&arguments[0], |_, [_, s]| s),
            Cos => self.trigonometric(&arguments[0], |_, [c, _]| c),
            Tan => self.trigonometric(&arguments[0], |a, [c, s]| a.graph.div(s, c)),
            Asin => self.unary_call(Unary::Asin, &arguments),
            Acos => self.unary_call(Unary::Acos, &arguments),
            Atan => self.unary_call(Unary::Atan, &arguments),
            Sqrt => self.square_root(&arguments[0]),
            Abs => self.unary_call(Unary::Abs, &arguments),
            Atan2 => self.binary_call(Binary::Atan2, &arguments),
            Min => self.binary_call(Binary::Min, &arguments),
            Max => self.binary_call(Binary::Max, &arguments),
            Hypot => {
                let v = [self.as_node(&arguments[0]), self.as_node(&arguments[1])];
                Value::Scalar(self.length(&v).into())
            }
            Frame => self.frame(&arguments),
            PointIn => self.point_in(&arguments),
            CoordinatesIn => self.coordinates_in(&arguments),
        }
    }

    fn direction_of(&mut self, angle: &Value) -> [NodeId; 2] {
        let angle = self.as_scalar(angle);
        self.direction(&angle)
    }

    fn trigonometric(
        &mut self,
        angle: &Value,
        pick: impl Fn(&mut Self, [NodeId; 2]) -> NodeId,
    ) -> Value {
        let unit = self.direction_of(angle);
        Value::Scalar(pick(self, unit).into())
    }

    /// The root of `v . v` is known as a length.
    fn square_root(&mut self, argument: &Value) -> Value {
        let square = self.as_node(argument);
        let root = match self.squares.get(&square).cloned() {
            Some(vector) if vector.len() == 3 => self.length(&vector),
            _ => self.graph.sqrt(square),
        };
        Value::Scalar(root.into())
    }

    fn unary_call(&mut self, op: Unary, arguments: &[Value]) -> Value {
        let a = self.as_node(&arguments[0]);
        Value::Scalar(self.graph.unary(op, a).into())
    }

    fn binary_call(&mut self, op: Binary, arguments: &[Value]) -> Value {
        let (a, b) = (self.as_node(&arguments[0]), self.as_node(&arguments[1]));
        Value::Scalar(self.graph.binary(op, a, b).into())
    }

    pub(crate) fn dot(&mut self, a: &[NodeId], b: &[NodeId]) -> NodeId {
        if a == b {
            return self.sum_of_squares(a);
        }
        let zero = self.graph.zero();
        a.iter().zip(b).fold(zero, |sum, (&x, &y)| {
            let product = self.graph.mul(x, y);
            self.graph.add(sum, product)
        })
    }

    /// `a x b` in the plane.
    pub(crate) fn cross(&mut self, a: [NodeId; 2], b: [NodeId; 2]) -> NodeId {
        let left = self.graph.mul(a[0], b[1]);
        let right = self.graph.mul(a[1], b[0]);
        self.graph.sub(left, right)
    }

    /// `a x b` in space.
    pub(crate) fn cross3(&mut self, a: [NodeId; 3], b: [NodeId; 3]) -> [NodeId; 3] {
        [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            self.cross([a[i], a[j]], [b[i], b[j]])
        })
    }

    fn cross_call(&mut self, arguments: &[Value]) -> Value {
        let (a, b) = (
            self.components(&arguments[0]),
            self.components(&arguments[1]),
        );
        match a.len().max(b.len()) {
            2 => Value::Scalar(self.cross([a[0], a[1]], [b[0], b[1]]).into()),
            _ => Value::Vector(self.cross3(spatial(&a), spatial(&b)).to_vec()),
        }
    }

    /// Rodrigues: `v cos + (k x v) sin + k (k . v) (1 - cos)` about the unit axis `k`.
    fn turn(&mut self, arguments: &[Value]) -> Value {
        let v = spatial(&self.components(&arguments[0]));
        let axis = spatial(&self.components(&arguments[1]));
        let axis = self.unit_vector(axis);
        let [cos, sin] = self.direction_of(&arguments[2]);
        let (one, zero) = (self.graph.one(), self.graph.zero());
        let along = self.dot(&axis, &v);
        let sideways = self.cross3(axis, v);
        let fixed = v.iter().chain(&axis).all(|&x| self.is_fixed(x));
        let (turning, sideways, along) = if self.vanishes(along) {
            (v, sideways, zero)
        } else if fixed {
            // Of a vector that is prepared only the part across the axis turns: what is left of a long part along it by
            // rounding would tilt the circle.
            let across = self.cross3(sideways, axis);
            (across, self.cross3(axis, across), along)
        } else {
            let versine = self.graph.sub(one, cos);
            (v, sideways, self.graph.mul(along, versine))
        };
        let turned = [0, 1, 2].map(|k| {
            let terms = [
                self.graph.mul(turning[k], cos),
                self.graph.mul(sideways[k], sin),
                self.graph.mul(axis[k], along),
            ];
            let sum = self.graph.add(terms[0], terms[1]);
            self.graph.add(sum, terms[2])
        });
        if self.is_unit(&v) {
            self.mark_unit(&turned);
        }
        Value::Vector(turned.to_vec())
    }

    /// The angle between sides `a` and `b`, opposite to `c`, by Kahan's formula, which needle triangles do not hurt
    /// (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle").
    fn triangle_angle(&mut self, arguments: &[Value]) -> Value {
        let sides: Vec<NodeId> = arguments.iter().map(|a| self.as_node(a)).collect();
        let g = &mut self.graph;
        let a = g.binary(Binary::Max, sides[0], sides[1]);
        let b = g.binary(Binary::Min, sides[0], sides[1]);
        let c = sides[2];
        let a_minus_b = g.sub(a, b);
        let a_minus_c = g.sub(a, c);
        let b_minus_c = g.sub(b, c);
        let short_c = g.sub(c, a_minus_b);
        let short_b = g.sub(b, a_minus_c);
        let smallest = g.ternary(Ternary::Select, b_minus_c, short_c, short_b);
        let opposite = g.add(a_minus_b, c);
        let numerator = g.mul(opposite, smallest);
        let b_plus_c = g.add(b, c);
        let perimeter = g.add(a, b_plus_c);
        let beside = g.add(a_minus_c, b);
        let denominator = g.mul(perimeter, beside);
        let square = g.div(numerator, denominator);
        let tangent = g.sqrt(square);
        let half = g.unary(Unary::Atan, tangent);
        let two = g.constant(2.0);
        Value::Scalar(Scalar::from(g.mul(two, half)))
    }
}

/// The three components of a space vector.
fn spatial(v: &[NodeId]) -> [NodeId; 3] {
    [v[0], v[1], v[2]]
}

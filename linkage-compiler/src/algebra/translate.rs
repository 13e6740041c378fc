//! Model expressions as graph nodes.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::Source;

use crate::model::{BinaryOp, Expr, ExprKind, Name, Type};

use super::{Algebra, Atom, Bound, Scalar};

/// The value of an expression.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Scalar(Scalar),
    Vector(Vec<NodeId>),
    /// A frame has four entries: its origin and its axes.
    Array(Vec<Value>),
}

/// Translation of expressions. What only quantities may contain (derivatives, margins) goes to [`Translate::quantity`].
pub(crate) trait Translate<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m>;

    fn quantity(&mut self, expr: &Expr) -> Value;

    fn translate(&mut self, expr: &Expr) -> Value {
        match &expr.kind {
            ExprKind::Number(value) => {
                let algebra = self.algebra();
                let scale = algebra.internal_per_unit(&expr.ty);
                let node = algebra.graph.constant(value * scale);
                Value::Scalar(node.into())
            }
            ExprKind::Name(name) => self.algebra().name(*name),
            ExprKind::Vector(components) => {
                Value::Vector(components.iter().map(|c| self.translate_node(c)).collect())
            }
            ExprKind::Component(vector, index) => {
                let node = self.translate_vector(vector)[*index];
                Value::Scalar(node.into())
            }
            ExprKind::Index(array, index) => match self.translate(array) {
                Value::Array(entries) => entries[*index].clone(),
                other => other,
            },
            ExprKind::Negate(inner) => {
                let value = self.translate(inner);
                self.algebra().negate(value)
            }
            ExprKind::Binary(op, a, b) => {
                let a = self.translate(a);
                let b = self.translate(b);
                self.algebra().arithmetic(*op, a, b)
            }
            ExprKind::Call(function, arguments) => {
                let arguments = arguments.iter().map(|a| self.translate(a)).collect();
                self.algebra().call(*function, arguments)
            }
            ExprKind::Derivative(..)
            | ExprKind::InputDerivative(..)
            | ExprKind::Sensitivity(..)
            | ExprKind::Mechanics(_)
            | ExprKind::Picture(_)
            | ExprKind::Margin => self.quantity(expr),
            ExprKind::Error => {
                let node = self.algebra().graph.constant(f64::NAN);
                Value::Scalar(node.into())
            }
        }
    }

    fn translate_node(&mut self, expr: &Expr) -> NodeId {
        let value = self.translate(expr);
        self.algebra().as_node(&value)
    }

    fn translate_vector(&mut self, expr: &Expr) -> Vec<NodeId> {
        match self.translate(expr) {
            Value::Vector(components) => components,
            other => vec![self.algebra().as_node(&other)],
        }
    }
}

impl<'m> Translate<'m> for Algebra<'m> {
    fn algebra(&mut self) -> &mut Algebra<'m> {
        self
    }

    fn quantity(&mut self, _: &Expr) -> Value {
        unreachable!("the model allows quantities in functions only")
    }
}

impl Algebra<'_> {
    /// A scalar value as one node.
    pub(crate) fn as_node(&mut self, value: &Value) -> NodeId {
        match value {
            Value::Scalar(scalar) => self.node(scalar),
            Value::Vector(components) => components[0],
            Value::Array(entries) => self.as_node(&entries[0]),
        }
    }

    pub(crate) fn as_scalar(&mut self, value: &Value) -> Scalar {
        match value {
            Value::Scalar(scalar) => scalar.clone(),
            other => self.as_node(other).into(),
        }
    }

    /// Translates the derived names in order: each then finds those before it done, and a long chain does not recurse.
    pub(crate) fn translate_lets(&mut self) {
        for index in 0..self.lets.len() {
            self.name(Name::Let(index));
        }
    }

    fn name(&mut self, name: Name) -> Value {
        match name {
            Name::Pi => Value::Scalar(self.graph.constant(std::f64::consts::PI).into()),
            Name::Const(index) => {
                if self.constants[index].is_none() {
                    let mechanism = self.mechanism;
                    let value = self.translate(&mechanism.constants[index].value);
                    self.constants[index] = Some(value);
                }
                self.constants[index].clone().expect("just translated")
            }
            Name::Let(index) => {
                if self.lets[index].is_none() {
                    let mechanism = self.mechanism;
                    let value = self.translate(&mechanism.lets[index].value);
                    self.lets[index] = Some(value);
                }
                self.lets[index].clone().expect("just translated")
            }
            Name::Parameter(index) => {
                let parameter = &self.mechanism.parameters[index];
                let first = parameter.first_scalar.0;
                let scale = self.internal_per_unit(&parameter.ty);
                match parameter.ty {
                    Type::Vector(count, _) | Type::Zero(count) if count > 1 => Value::Vector(
                        (first..first + count)
                            .map(|k| self.scaled(Source::Parameter(k), scale))
                            .collect(),
                    ),
                    _ => Value::Scalar(self.scaled(Source::Parameter(first), scale).into()),
                }
            }
            Name::Input(index) => {
                if self.mechanism.inputs[index].dimension.half_lengths == 0 {
                    Value::Scalar(self.atom(Atom::Input(index)))
                } else {
                    Value::Scalar(self.input(index).into())
                }
            }
            Name::Argument(index) => {
                let place = self.mechanism.inputs.len() + index;
                let ty = Type::Scalar(self.mechanism.arguments[index].dimension);
                let scale = self.internal_per_unit(&ty);
                Value::Scalar(self.scaled(Source::Input(place), scale).into())
            }
            Name::Unknown(index) => match self.bound[index].clone() {
                Bound::Angle(angle) => Value::Scalar(self.atom(Atom::Angle(angle))),
                Bound::Lengths(symbols) => match symbols[..] {
                    [(_, node)] => Value::Scalar(node.into()),
                    _ => Value::Vector(symbols.iter().map(|(_, node)| *node).collect()),
                },
            },
        }
    }

    /// What is given in a unit with kilograms, as the program computes with it.
    fn scaled(&mut self, source: Source, internal_per_unit: f64) -> NodeId {
        let given = self.graph.source(source);
        let scale = self.graph.constant(internal_per_unit);
        self.graph.mul(scale, given)
    }

    /// See [`Dimension::internal_per_unit`](crate::model::Dimension::internal_per_unit).
    pub(crate) fn internal_per_unit(&self, ty: &Type) -> f64 {
        let unit = self.mechanism.unit;
        ty.dimension()
            .map_or(1.0, |dimension| dimension.internal_per_unit(unit))
    }

    fn negate(&mut self, value: Value) -> Value {
        match value {
            Value::Scalar(scalar) => Value::Scalar(self.scale(&scalar, -1.0)),
            Value::Vector(v) => Value::Vector(v.into_iter().map(|x| self.graph.neg(x)).collect()),
            Value::Array(entries) => Value::Array(
                entries
                    .into_iter()
                    .map(|entry| self.negate(entry))
                    .collect(),
            ),
        }
    }

    fn arithmetic(&mut self, op: BinaryOp, a: Value, b: Value) -> Value {
        match (op, a, b) {
            (BinaryOp::Add, Value::Scalar(a), Value::Scalar(b)) => {
                Value::Scalar(self.combine(&a, &b, 1.0))
            }
            (BinaryOp::Sub, Value::Scalar(a), Value::Scalar(b)) => {
                Value::Scalar(self.combine(&a, &b, -1.0))
            }
            (BinaryOp::Add, a, b) => self.sum(&a, &b, false),
            (BinaryOp::Sub, a, b) => self.sum(&a, &b, true),
            (BinaryOp::Mul, Value::Scalar(a), Value::Scalar(b)) => self.product(&a, &b),
            (BinaryOp::Mul, Value::Scalar(a), v) | (BinaryOp::Mul, v, Value::Scalar(a)) => {
                let factor = self.node(&a);
                let scaled = self.components(&v).into_iter();
                Value::Vector(scaled.map(|x| self.graph.mul(factor, x)).collect())
            }
            (BinaryOp::Div, Value::Scalar(a), Value::Scalar(b)) => self.quotient(&a, &b),
            (BinaryOp::Div, v, b) => {
                let divisor = self.as_node(&b);
                let scaled = self.components(&v).into_iter();
                Value::Vector(scaled.map(|x| self.graph.div(x, divisor)).collect())
            }
            (BinaryOp::Mul, a, _) => a,
        }
    }

    /// The components of a vector; a scalar (the literal 0 where a vector is meant) has two equal ones.
    pub(crate) fn components(&mut self, value: &Value) -> Vec<NodeId> {
        match value {
            Value::Vector(components) => components.clone(),
            other => {
                let node = self.as_node(other);
                vec![node; 2]
            }
        }
    }

    fn sum(&mut self, a: &Value, b: &Value, minus: bool) -> Value {
        let (a, b) = (self.components(a), self.components(b));
        let (a, b) = self.equally_long(&a, &b);
        let sums = a.into_iter().zip(b).map(|(x, y)| match minus {
            true => self.graph.sub(x, y),
            false => self.graph.add(x, y),
        });
        Value::Vector(sums.collect())
    }

    /// `a - b`
    pub(crate) fn difference(&mut self, a: &[NodeId], b: &[NodeId]) -> Vec<NodeId> {
        let (a, b) = self.equally_long(a, b);
        let pairs = a.into_iter().zip(b);
        pairs.map(|(x, y)| self.graph.sub(x, y)).collect()
    }

    /// Two vectors, of which a 0 may have fewer components.
    fn equally_long(&mut self, a: &[NodeId], b: &[NodeId]) -> (Vec<NodeId>, Vec<NodeId>) {
        let (mut a, mut b) = (a.to_vec(), b.to_vec());
        let count = a.len().max(b.len());
        let zero = self.graph.zero();
        a.resize(count, zero);
        b.resize(count, zero);
        (a, b)
    }

    fn product(&mut self, a: &Scalar, b: &Scalar) -> Value {
        for (x, y) in [(a, b), (b, a)] {
            if let (true, Some(factor)) = (x.terms.is_empty(), self.graph.constant_value(x.rest)) {
                return Value::Scalar(self.scale(y, factor));
            }
        }
        let (x, y) = (self.node(a), self.node(b));
        Value::Scalar(self.graph.mul(x, y).into())
    }

    fn quotient(&mut self, a: &Scalar, b: &Scalar) -> Value {
        if let (true, Some(divisor)) = (b.terms.is_empty(), self.graph.constant_value(b.rest)) {
            let terms = a
                .terms
                .iter()
                .map(|&(atom, k)| (atom, k / divisor))
                .collect();
            return Value::Scalar(Scalar {
                terms,
                rest: self.graph.div(a.rest, b.rest),
            });
        }
        let (x, y) = (self.node(a), self.node(b));
        Value::Scalar(self.graph.div(x, y).into())
    }
}

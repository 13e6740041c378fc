//! Model expressions as graph nodes.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::names::{Bound, Names};
use crate::algebra::value::{Atom, Scalar, Value};
use crate::algebra::{calls, motion_law, scalar};
use crate::model::{BinaryOp, Expr, ExprKind, Mechanism, Name, Type};

/// Translation of expressions. Parts that only quantities may contain (derivatives, margins) go to
/// [`Translate::quantity`].
pub(crate) trait Translate<'m> {
    fn names(&mut self) -> &mut Names<'m>;

    fn quantity(&mut self, expr: &Expr) -> Value<'m>;

    fn translate(&mut self, expr: &Expr) -> Value<'m> {
        match &expr.kind {
            ExprKind::Number(value) => {
                let names = self.names();
                let scale = internal_per_unit(names.mechanism, &expr.ty);
                names.graph.number(value * scale).into()
            }
            ExprKind::Name(name) => value_of_name(self.names(), *name),
            ExprKind::Vector(components) => {
                let components = components
                    .iter()
                    .map(|component| self.translate_number(component).id());
                let components: Vec<NodeId> = components.collect();
                self.names().graph.components(&components).into()
            }
            ExprKind::Component(vector, index) => self.translate_vector(vector).at(*index).into(),
            ExprKind::Index(array, index) => match self.translate(array) {
                Value::Array(entries) => entries[*index].clone(),
                other => other,
            },
            ExprKind::Negate(inner) => self.translate(inner).negative(),
            ExprKind::Binary(op, a, b) => {
                let a = self.translate(a);
                let b = self.translate(b);
                arithmetic(self.names(), *op, a, b)
            }
            ExprKind::Call(function, arguments) => {
                let arguments = arguments.iter().map(|a| self.translate(a)).collect();
                calls::call(self.names(), *function, arguments)
            }
            ExprKind::MotionLaw(course) => {
                let argument = self.translate_number(&course.argument);
                let knots = course.knots.iter().map(|knot| {
                    let abscissa = self.translate_number(&knot.abscissa);
                    let value = self.translate_number(&knot.value);
                    (abscissa, value)
                });
                let knots: Vec<(Ex, Ex)> = knots.collect();
                let slopes = course.knots.iter().filter_map(|knot| knot.slope.as_ref());
                let slopes: Vec<Ex> = slopes.map(|slope| self.translate_number(slope)).collect();
                motion_law::value(argument, course, &knots, &slopes).into()
            }
            ExprKind::Derivative(..)
            | ExprKind::InputDerivative(..)
            | ExprKind::Sensitivity(..)
            | ExprKind::Mechanics(_)
            | ExprKind::Picture(_)
            | ExprKind::Margin => self.quantity(expr),
            ExprKind::Error => self.names().graph.number(f64::NAN).into(),
        }
    }

    /// An expression that is a number.
    fn translate_number(&mut self, expr: &Expr) -> Ex<'m> {
        let value = self.translate(expr);
        scalar::number(self.names(), &value)
    }

    /// An expression that is a vector; a number counts as a vector of one component.
    fn translate_vector(&mut self, expr: &Expr) -> Vn<'m> {
        match self.translate(expr) {
            Value::Vector(vector) => vector,
            other => {
                let number = scalar::number(self.names(), &other);
                number.graph().components(&[number.id()])
            }
        }
    }
}

impl<'m> Translate<'m> for Names<'m> {
    fn names(&mut self) -> &mut Names<'m> {
        self
    }

    fn quantity(&mut self, _: &Expr) -> Value<'m> {
        unreachable!("the model allows quantities in functions only")
    }
}

/// Translates the derived names in order: each then finds those before it done, and a long chain
/// does not recurse.
pub(crate) fn translate_lets(names: &mut Names<'_>) {
    translate_these_lets(names, |_| true);
}

/// The same for some of them.
pub(crate) fn translate_these_lets(names: &mut Names<'_>, which: impl Fn(usize) -> bool) {
    for index in (0..names.lets.len()).filter(|&index| which(index)) {
        value_of_name(names, Name::Let(index));
    }
}

/// Returns the value of a name.
pub(crate) fn value_of_name<'m>(names: &mut Names<'m>, name: Name) -> Value<'m> {
    match name {
        Name::Pi => names.graph.number(std::f64::consts::PI).into(),
        Name::Const(index) => {
            if names.constants[index].is_none() {
                let mechanism = names.mechanism;
                let value = names.translate(&mechanism.constants[index].value);
                names.constants[index] = Some(value);
            }
            names.constants[index].clone().expect("just translated")
        }
        Name::Let(index) => {
            if names.lets[index].is_none() {
                let mechanism = names.mechanism;
                let value = names.translate(&mechanism.lets[index].value);
                names.lets[index] = Some(value);
            }
            names.lets[index].clone().expect("just translated")
        }
        Name::Parameter(index) => {
            let parameter = &names.mechanism.parameters[index];
            let first = parameter.first_scalar.0;
            let scale = internal_per_unit(names.mechanism, &parameter.ty);
            match parameter.ty {
                Type::Vector(count, _) | Type::Zero(count) if count > 1 => {
                    let components = first..first + count;
                    let components: Vec<NodeId> = components
                        .map(|k| scaled(names, Source::Parameter(k), scale).id())
                        .collect();
                    names.graph.components(&components).into()
                }
                _ => scaled(names, Source::Parameter(first), scale).into(),
            }
        }
        Name::Input(index) => {
            if names.mechanism.inputs[index].dimension.half_lengths == 0 {
                Value::Scalar(scalar::atom(names.graph, Atom::Input(index)))
            } else {
                names.input(index).into()
            }
        }
        Name::Argument(index) => {
            let input = names.mechanism.inputs.len() + index;
            let ty = Type::Scalar(names.mechanism.arguments[index].dimension);
            let scale = internal_per_unit(names.mechanism, &ty);
            scaled(names, Source::Input(input), scale).into()
        }
        Name::Unknown(index) => match &names.bound[index] {
            Bound::Angle(angle) => Value::Scalar(scalar::atom(names.graph, Atom::Angle(*angle))),
            Bound::Lengths(symbols) => match symbols[..] {
                [(_, length)] => length.into(),
                _ => {
                    let components = symbols.iter().map(|(_, x)| x.id());
                    let components: Vec<NodeId> = components.collect();
                    names.graph.components(&components).into()
                }
            },
        },
    }
}

/// Returns a source with a unit of kilograms, in the unit in which the program computes.
fn scaled<'m>(names: &Names<'m>, source: Source, internal_per_unit: f64) -> Ex<'m> {
    internal_per_unit * names.source(source)
}

/// See [`Dimension::internal_per_unit`](crate::model::Dimension::internal_per_unit).
pub(crate) fn internal_per_unit(mechanism: &Mechanism, ty: &Type) -> f64 {
    let unit = mechanism.unit;
    ty.dimension()
        .map_or(1.0, |dimension| dimension.internal_per_unit(unit))
}

fn arithmetic<'m>(names: &Names<'m>, op: BinaryOp, a: Value<'m>, b: Value<'m>) -> Value<'m> {
    match (op, a, b) {
        (BinaryOp::Add, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a.combined(&b, 1.0)),
        (BinaryOp::Sub, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a.combined(&b, -1.0)),
        (BinaryOp::Add, a, b) => (scalar::vector(names, &a) + scalar::vector(names, &b)).into(),
        (BinaryOp::Sub, a, b) => (scalar::vector(names, &a) - scalar::vector(names, &b)).into(),
        (BinaryOp::Mul, Value::Scalar(a), Value::Scalar(b)) => product(names, &a, &b),
        (BinaryOp::Mul, Value::Scalar(a), v) | (BinaryOp::Mul, v, Value::Scalar(a)) => {
            let factor = scalar::value_of(names, &a);
            (factor * scalar::vector(names, &v)).into()
        }
        (BinaryOp::Div, Value::Scalar(a), Value::Scalar(b)) => quotient(names, &a, &b),
        (BinaryOp::Div, v, b) => {
            let divisor = scalar::number(names, &b);
            (scalar::vector(names, &v) / divisor).into()
        }
        (BinaryOp::Mul, a, _) => a,
    }
}

fn product<'m>(names: &Names<'m>, a: &Scalar<'m>, b: &Scalar<'m>) -> Value<'m> {
    for (x, y) in [(a, b), (b, a)] {
        if let (true, Some(factor)) = (x.terms.is_empty(), x.rest.constant_value()) {
            return Value::Scalar(y.scaled(factor));
        }
    }
    let (x, y) = (scalar::value_of(names, a), scalar::value_of(names, b));
    (x * y).into()
}

fn quotient<'m>(names: &Names<'m>, a: &Scalar<'m>, b: &Scalar<'m>) -> Value<'m> {
    if let (true, Some(divisor)) = (b.terms.is_empty(), b.rest.constant_value()) {
        let terms = a.terms.iter().map(|&(atom, k)| (atom, k / divisor));
        return Value::Scalar(Scalar {
            terms: terms.collect(),
            rest: a.rest / b.rest,
        });
    }
    let (x, y) = (scalar::value_of(names, a), scalar::value_of(names, b));
    (x / y).into()
}

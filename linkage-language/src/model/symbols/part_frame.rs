//! Frames of parts: expressions of a part in the frame of the mechanism around it.

use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Function, Placed, Type};

/// The location of a part.
#[derive(Clone, Default)]
pub(in crate::model) struct PartFrame {
    at: Option<Expr>,
    turned: Option<Expr>,
}

impl Placed {
    pub(in crate::model) fn frame(&self) -> PartFrame {
        PartFrame {
            at: self.at.clone(),
            turned: self.turned.clone(),
        }
    }
}

impl PartFrame {
    /// Returns an expression of a part in the frame of the mechanism around it. Vectors of lengths
    /// are points, other vectors directions; scalars do not change.
    pub(in crate::model) fn seen(&self, value: Expr) -> Expr {
        match &value.ty {
            Type::Vector(_, dimension) if dimension.fits(Dimension::LENGTH) => {
                self.seen_point(value)
            }
            Type::Vector(..) | Type::Frame | Type::PlaneFrame => self.seen_direction(value),
            Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => value,
        }
    }

    pub(in crate::model) fn seen_point(&self, value: Expr) -> Expr {
        let Some(at) = &self.at else {
            return self.rotated(value);
        };
        if at.ty == Type::Frame {
            return called(Function::PointIn, [at.clone(), value]);
        }
        let turned = self.rotated(value);
        Expr {
            ty: turned.ty.clone(),
            origin: turned.origin,
            kind: ExprKind::Binary(BinaryOp::Add, Box::new(at.clone()), Box::new(turned)),
        }
    }

    fn rotated(&self, value: Expr) -> Expr {
        match (&self.turned, &self.at) {
            (Some(angle), _) => called(Function::Rotate, [value, angle.clone()]),
            (None, Some(at)) if at.ty == Type::Frame => of_axes(at, value),
            (None, _) => value,
        }
    }

    /// The angle of a body in the plane; in space its frame, or the vector along it.
    pub(in crate::model) fn turning(&self, value: Expr) -> Expr {
        let Some(angle) = &self.turned else {
            return self.seen_direction(value);
        };
        Expr {
            ty: value.ty.clone(),
            origin: value.origin,
            kind: ExprKind::Binary(BinaryOp::Add, Box::new(value), Box::new(angle.clone())),
        }
    }

    fn seen_direction(&self, value: Expr) -> Expr {
        match (&value.ty, &self.at) {
            (Type::Vector(..), _) => self.rotated(value),
            (Type::PlaneFrame, _) => {
                let [origin, x] = [0, 1].map(|part| part_of(&value, part));
                let arguments = [self.seen_point(origin), self.rotated(x)];
                Expr {
                    ty: Type::PlaneFrame,
                    origin: value.origin,
                    kind: ExprKind::Call(Function::Frame, arguments.into()),
                }
            }
            (Type::Frame, Some(_)) => {
                let [origin, x, _, z] = [0, 1, 2, 3].map(|part| part_of(&value, part));
                let arguments = [self.seen_point(origin), self.rotated(x), self.rotated(z)];
                Expr {
                    ty: Type::Frame,
                    origin: value.origin,
                    kind: ExprKind::Call(Function::Frame, arguments.into()),
                }
            }
            _ => value,
        }
    }
}

/// A call whose value is of the type of the vector among its arguments.
fn called(function: Function, arguments: [Expr; 2]) -> Expr {
    let mut vectors = arguments.iter();
    let vector = vectors.find(|argument| argument.ty.components().is_some_and(|count| count > 1));
    let vector = vector.unwrap_or(&arguments[0]);
    Expr {
        ty: vector.ty.clone(),
        origin: vector.origin,
        kind: ExprKind::Call(function, arguments.into()),
    }
}

/// `.origin`, `.x`, `.y` or `.z` of a frame.
fn part_of(frame: &Expr, part: usize) -> Expr {
    let dimension = match part {
        0 => Dimension::LENGTH,
        _ => Dimension::NUMBER,
    };
    Expr {
        kind: ExprKind::Index(Box::new(frame.clone()), part),
        ty: Type::Vector(3, dimension),
        origin: frame.origin,
    }
}

/// A vector by its components along the axes of a frame.
fn of_axes(frame: &Expr, vector: Expr) -> Expr {
    let (ty, origin) = (vector.ty.clone(), vector.origin);
    let product = |axis: usize| {
        let component = vector.component(axis);
        let axis = part_of(frame, axis + 1);
        Expr {
            kind: ExprKind::Binary(BinaryOp::Mul, Box::new(axis), Box::new(component)),
            ty: ty.clone(),
            origin,
        }
    };
    let sum = |a, b| Expr {
        kind: ExprKind::Binary(BinaryOp::Add, Box::new(a), Box::new(b)),
        ty: ty.clone(),
        origin,
    };
    sum(sum(product(0), product(1)), product(2))
}

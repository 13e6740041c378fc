//! Frames of parts: what of a part is seen from the mechanism around it.

use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Function, Placed, Type};

/// Where a part stands.
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
    /// What of a part is seen from the mechanism around it: vectors of lengths are points, other vectors directions; scalars stay.
    pub(in crate::model) fn seen(&self, own: Expr) -> Expr {
        match &own.ty {
            Type::Vector(_, dimension) if dimension.fits(Dimension::LENGTH) => self.seen_point(own),
            Type::Vector(..) | Type::Frame | Type::PlaneFrame => self.seen_direction(own),
            Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => own,
        }
    }

    pub(in crate::model) fn seen_point(&self, own: Expr) -> Expr {
        let Some(at) = &self.at else {
            return self.rotated(own);
        };
        if at.ty == Type::Frame {
            return called(Function::PointIn, [at.clone(), own]);
        }
        let turned = self.rotated(own);
        Expr {
            ty: turned.ty.clone(),
            origin: turned.origin,
            kind: ExprKind::Binary(BinaryOp::Add, Box::new(at.clone()), Box::new(turned)),
        }
    }

    fn rotated(&self, own: Expr) -> Expr {
        match (&self.turned, &self.at) {
            (Some(angle), _) => called(Function::Rotate, [own, angle.clone()]),
            (None, Some(at)) if at.ty == Type::Frame => of_axes(at, own),
            (None, _) => own,
        }
    }

    /// The angle of a body in the plane; in space its frame, or the vector along it.
    pub(in crate::model) fn turning(&self, own: Expr) -> Expr {
        let Some(angle) = &self.turned else {
            return self.seen_direction(own);
        };
        Expr {
            ty: own.ty.clone(),
            origin: own.origin,
            kind: ExprKind::Binary(BinaryOp::Add, Box::new(own), Box::new(angle.clone())),
        }
    }

    fn seen_direction(&self, own: Expr) -> Expr {
        match (&own.ty, &self.at) {
            (Type::Vector(..), _) => self.rotated(own),
            (Type::PlaneFrame, _) => {
                let [origin, x] = [0, 1].map(|part| part_of(&own, part));
                let arguments = [self.seen_point(origin), self.rotated(x)];
                Expr {
                    ty: Type::PlaneFrame,
                    origin: own.origin,
                    kind: ExprKind::Call(Function::Frame, arguments.into()),
                }
            }
            (Type::Frame, Some(_)) => {
                let [origin, x, _, z] = [0, 1, 2, 3].map(|part| part_of(&own, part));
                let arguments = [self.seen_point(origin), self.rotated(x), self.rotated(z)];
                Expr {
                    ty: Type::Frame,
                    origin: own.origin,
                    kind: ExprKind::Call(Function::Frame, arguments.into()),
                }
            }
            _ => own,
        }
    }
}

/// A call whose value is of the type of the vector among its arguments.
fn called(function: Function, arguments: [Expr; 2]) -> Expr {
    let mut vectors = arguments.iter();
    let vector = vectors.find(|own| own.ty.components().is_some_and(|count| count > 1));
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
fn of_axes(frame: &Expr, own: Expr) -> Expr {
    let (ty, origin) = (own.ty.clone(), own.origin);
    let product = |axis: usize| {
        let component = own.component(axis);
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

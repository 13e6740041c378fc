//! `unknown body = frame(origin, x, z);`: the position and orientation of a body as an unknown.
//!
//! In space it becomes an unknown point and two unknown directions, with the loops that both have
//! length 1 and are perpendicular. The third axis is their product. No orientation is singular,
//! none is found twice (as with quaternions), and points and directions keep their closed forms. In
//! the plane it is an unknown point and an angle.

use crate::diagnostic::OriginId;
use crate::model::dispatch::resolve_expression;
use crate::model::symbols::frame_kind::FrameKind;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::types::{
    Expr, ExprKind, Function, Let, Loop, Mechanism, Name, Type, Unknown, type_of_part,
};
use crate::syntax::UnknownItem;

/// An unknown frame and the unknowns that it consists of.
pub(in crate::model) struct FoundFrame {
    name: String,
    estimate: Option<Expr>,
    /// Its number among the derived quantities.
    number: usize,
    /// Its origin; an angle or two axes follow.
    first_unknown: usize,
    kind: FrameKind,
    origin: OriginId,
}

/// Resolves unknown frames: derived quantities before all others, and unknowns after all others.
pub(in crate::model) fn resolve_unknown_frames(
    scope: &mut Scope,
    sink: &mut Sink,
    items: &[(usize, &UnknownItem)],
    mechanism: &mut Mechanism,
) -> Vec<FoundFrame> {
    let mut frames = Vec::new();
    for (position, item) in items {
        let context = Context {
            site: Site::Estimate,
            item: *position,
        };
        let estimate = item.estimate.as_ref();
        let found = FoundFrame {
            name: item.name.to_string(),
            estimate: estimate.map(|estimate| resolve_expression(scope, sink, estimate, context)),
            number: mechanism.lets.len(),
            first_unknown: mechanism.unknowns.len(),
            kind: FrameKind::of_item(item),
            origin: sink.add_origin((&item.name).into()),
        };
        scope
            .names
            .set_type(Name::Let(found.number), found.kind.ty(), false);
        scope.values.note_unknown_frame();
        mechanism.unknowns.extend(found.unknowns());
        mechanism.lets.push(Let {
            name: found.name.clone(),
            value: found.value(),
            is_unknown_frame: true,
        });
        frames.push(found);
    }
    frames
}

/// Adds the loops of the axes after those of the user. The derived axis is the one along which the
/// fewest points have a coordinate: loops without it have a lower degree.
pub(in crate::model) fn close_frames(mechanism: &mut Mechanism, frames: Vec<FoundFrame>) {
    for mut found in frames {
        if let FrameKind::Space { derived } = found.kind {
            let uses = uses_of_axes(mechanism, found.number);
            let others = (0..uses.len()).filter(|axis| uses[*axis] < uses[derived]);
            let derived = others.min_by_key(|axis| uses[*axis]).unwrap_or(derived);
            found.kind = FrameKind::Space { derived };
        }
        let first = found.first_unknown;
        let places = first..first + found.kind.unknowns();
        mechanism.unknowns.splice(places, found.unknowns());
        mechanism.lets[found.number].value = found.value();
        mechanism.loops.extend(found.loops());
    }
}

impl FoundFrame {
    fn unknowns(&self) -> Vec<Unknown> {
        let ty = self.kind.ty();
        let unknowns = self.kind.parts().into_iter().map(|part| {
            let part_of = |frame: &Expr| ExprKind::Index(Box::new(frame.clone()), part);
            let estimate = self.estimate.as_ref().map(part_of);
            Unknown {
                name: format!("{}.{}", self.name, self.kind.names()[part]),
                ty: type_of_part(&ty, part),
                estimate: estimate.map(|kind| self.expr(kind, type_of_part(&ty, part))),
                of_part: false,
                origin: self.origin,
            }
        });
        unknowns.collect()
    }

    /// One of its unknowns.
    fn unknown(&self, k: usize) -> Expr {
        let kind = ExprKind::Name(Name::Unknown(self.first_unknown + k));
        self.expr(kind, type_of_part(&self.kind.ty(), self.kind.parts()[k]))
    }

    /// Returns `frame(origin, x, y, z)` with perpendicular axes of length 1, in the plane
    /// `frame(origin, angle)`.
    fn value(&self) -> Expr {
        let parts = match self.kind {
            FrameKind::Plane => vec![self.unknown(0), self.unknown(1)],
            FrameKind::Space { derived } => {
                let [first, second] = [1, 2].map(|k| self.unknown(k));
                let ty = first.ty.clone();
                let product = vec![first.clone(), second.clone()];
                let mut axes = [first, second, self.call(Function::Cross, product, ty)];
                // The order is that of the axes after the product.
                axes.rotate_right((derived + 1) % 3);
                std::iter::once(self.unknown(0)).chain(axes).collect()
            }
        };
        self.call(Function::Frame, parts, self.kind.ty())
    }

    fn loops(&self) -> Vec<Loop> {
        if self.kind == FrameKind::Plane {
            return Vec::new();
        }
        let number = |value| self.expr(ExprKind::Number(value), Type::NUMBER);
        let length = |k| self.call(Function::Norm, vec![self.unknown(k)], Type::NUMBER);
        let axes = vec![self.unknown(1), self.unknown(2)];
        let product = self.call(Function::Dot, axes, Type::NUMBER);
        let loops = [(length(1), 1.0), (length(2), 1.0), (product, 0.0)];
        let loops = loops.map(|(left, right)| Loop {
            left,
            right: number(right),
            origin: self.origin,
            of: None,
        });
        loops.into()
    }

    fn call(&self, function: Function, arguments: Vec<Expr>, ty: Type) -> Expr {
        self.expr(ExprKind::Call(function, arguments), ty)
    }

    fn expr(&self, kind: ExprKind, ty: Type) -> Expr {
        Expr {
            kind,
            ty,
            origin: self.origin,
        }
    }
}

/// Returns for each axis of a frame the number of points of loops and derived quantities with a
/// coordinate along it, plus the number of uses of the axis.
fn uses_of_axes(mechanism: &Mechanism, number: usize) -> [usize; 3] {
    let is_frame = |value: &Expr| value.as_name() == Some(Name::Let(number));
    let loops = mechanism.loops.iter();
    let loops = loops.flat_map(|equation| [&equation.left, &equation.right]);
    let lets = mechanism.lets.iter().map(|item| &item.value);
    let mut uses = [0; 3];
    for part in loops.chain(lets).flat_map(Expr::parts) {
        match &part.kind {
            ExprKind::Call(Function::PointIn, arguments) if is_frame(&arguments[0]) => {
                for (axis, count) in uses.iter_mut().enumerate() {
                    *count += usize::from(!is_zero(mechanism, &arguments[1], axis));
                }
            }
            ExprKind::Index(frame, axis @ 1..) if is_frame(frame) => uses[axis - 1] += 1,
            // Nothing else uses an axis alone.
            _ => {}
        }
    }
    uses
}

/// Returns true if a component of a vector is written as 0.
fn is_zero(mechanism: &Mechanism, vector: &Expr, component: usize) -> bool {
    match &vector.kind {
        ExprKind::Vector(components) => matches!(components[component].kind, ExprKind::Number(0.0)),
        ExprKind::Name(name @ (Name::Const(_) | Name::Let(_))) => {
            let value = mechanism.value_of(*name);
            value.is_some_and(|value| is_zero(mechanism, value, component))
        }
        ExprKind::Negate(inner) => is_zero(mechanism, inner, component),
        // It may be anything.
        _ => false,
    }
}

//! Frames: their parts, the functions that make and use them, and where they cannot stand.

use proc_macro2::Ident;

use super::names::Resolver;
use super::operators::settle_alone;
use super::place::Context;
use super::types::{Dimension, Expr, ExprKind, Function, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, Word};

/// What a frame consists of, in this order.
pub(crate) const PARTS: [&str; 4] = ["origin", "x", "y", "z"];

pub(super) const PARTS_HELP: &str = "parts of a frame are `.origin`, `.x`, `.y` and `.z`";

/// What a frame of the plane consists of, in this order.
pub(crate) const PLANE_PARTS: [&str; 4] = ["origin", "x", "y", "angle"];

/// Which of them is its angle, behind so many vectors: as a quantity it is these.
pub(super) const ANGLE_PART: usize = 3;
pub(crate) const VECTORS_OF_PLANE: usize = ANGLE_PART;

pub(super) const PLANE_PARTS_HELP: &str =
    "parts of a frame of the plane are `.origin`, `.x`, `.y` and `.angle`";

/// The type of a part of a frame.
pub(super) fn type_of_part(frame: &Type, part: usize) -> Type {
    match (frame, part) {
        (Type::PlaneFrame, 0) => Type::Vector(2, Dimension::LENGTH),
        (Type::PlaneFrame, 3) => Type::Scalar(Dimension::ANGLE),
        (Type::PlaneFrame, _) => Type::Vector(2, Dimension::NUMBER),
        (_, 0) => Type::Vector(3, Dimension::LENGTH),
        _ => Type::Vector(3, Dimension::NUMBER),
    }
}

impl Function {
    /// Whether some argument may be of this type although it has no arithmetic. Other functions refuse it.
    pub(super) fn takes(self, ty: &Type) -> bool {
        matches!(self, Function::PointIn | Function::CoordinatesIn) && ty.is_frame()
    }

    /// Whether it can be called with so many arguments.
    pub(super) fn takes_count(self, count: usize) -> bool {
        // Without the z axis it is a frame of the plane.
        count == self.parameters().len() || (self == Function::Frame && count == 2)
    }
}

/// What stands behind the frame in `point_in` and `coordinates_in`.
#[derive(Clone, Copy)]
pub(super) struct SecondArgument {
    /// The beginning of the sentence that says what it must be.
    pub(super) rule: &'static str,
    /// What it is called.
    pub(super) word: &'static str,
}

impl Resolver<'_> {
    /// `.origin`, `.x`, `.y`, and `.z` or `.angle` of a frame.
    pub(super) fn part(&mut self, frame: Expr, field: &Ident, span: SourceSpan) -> Expr {
        let (parts, help) = match frame.ty {
            Type::PlaneFrame => (PLANE_PARTS, PLANE_PARTS_HELP),
            _ => (PARTS, PARTS_HELP),
        };
        match parts.iter().position(|part| field == part) {
            Some(index) => {
                let ty = type_of_part(&frame.ty, index);
                let kind = ExprKind::Index(Box::new(frame), index);
                self.make(kind, ty, span)
            }
            None => {
                let fact = format!("{} has no part `{field}`", frame.ty);
                self.diagnostics.error_with_help(field.into(), fact, help);
                self.failed(span)
            }
        }
    }

    /// `frame(origin, x, z)`, `frame(origin, x)` in the plane
    pub(super) fn frame(&mut self, arguments: &mut [Expr], span: SourceSpan) -> Option<Type> {
        let function = Function::Frame;
        match arguments {
            [origin, x, z] => {
                self.point(origin, 3, function, "the origin of a frame is")?;
                self.vector_of(x, function, Some(3))?;
                self.vector_of(z, function, Some(3))?;
                Some(Type::Frame)
            }
            [origin, x] => {
                if [&*origin, x]
                    .iter()
                    .any(|own| own.ty.components() == Some(3))
                {
                    self.wrong_count_of(function, arguments.len(), span);
                    return None;
                }
                self.point(origin, 2, function, "the origin of a frame is")?;
                self.vector_of(x, function, Some(2))?;
                Some(Type::PlaneFrame)
            }
            _ => None,
        }
    }

    /// `point_in(frame, vector)`, `coordinates_in(frame, point)`
    pub(super) fn in_frame(
        &mut self,
        function: Function,
        second: SecondArgument,
        arguments: &mut [Expr],
        span: SourceSpan,
    ) -> Option<Type> {
        let [frame, point] = arguments else {
            return None;
        };
        let name = function.word();
        if !frame.ty.is_frame() && point.ty.is_frame() {
            let (first, frame) = (&frame.ty, &point.ty);
            let fact = format!("the arguments of `{name}` are swapped: found {first} and {frame}");
            let help = format!("write `{name}(frame, {})`", second.word);
            self.diagnostics.error_with_help(span, fact, help);
            return None;
        }
        if !frame.ty.is_frame() {
            settle_alone(frame);
            let help = "`frame(origin, x, z)` makes a frame";
            return self.wrong_argument(function, "a frame here", frame, help);
        }
        let ty = type_of_part(&frame.ty, 0);
        self.point(point, ty.components().unwrap_or(3), function, second.rule)?;
        Some(ty)
    }

    /// A vector of lengths; zeros are lengths here.
    fn point(
        &mut self,
        argument: &mut Expr,
        components: usize,
        function: Function,
        role: &str,
    ) -> Option<()> {
        let wanted = Type::Vector(components, Dimension::LENGTH);
        argument.settle(&wanted);
        if self.refuse_compound(argument) {
            return None;
        }
        let (_, dimension) = self.vector_of(argument, function, Some(components))?;
        if dimension.fits(Dimension::LENGTH) {
            return Some(());
        }
        self.suspect(argument, &wanted);
        let fact = format!("{role} {wanted}, found {}", argument.ty);
        let help = match dimension.is_number_or_angle() {
            true => "give its components a unit, or multiply it by a length",
            false => "divide by a length",
        };
        let span = self.origins.span(argument.origin);
        self.diagnostics.error_with_help(span, fact, help);
        None
    }

    /// What to write for a frame where a vector is needed, its name filled in.
    pub(super) fn parts_help(&self, verb: &str, frame: &Expr) -> String {
        let symbol = |name| self.symbols.iter().find(move |symbol| symbol.name == name);
        let name = match &frame.kind {
            ExprKind::Name(name) => symbol(*name).map(|symbol| symbol.text.as_str()),
            _ => None,
        };
        let name = name.unwrap_or("body");
        format!("{verb} `{name}.origin`, an axis like `{name}.x`, or `point_in({name}, v)`")
    }

    /// A frame as the value of an item that is no `let`: reported, and then an error.
    pub(super) fn refuse_frame_item(&mut self, value: &mut Expr, rule: &str) {
        if value.ty.is_frame() {
            let span = self.origins.span(value.origin);
            let help = "declare what it consists of, and the frame with `let`";
            self.diagnostics
                .error_with_help(span, format!("{rule}, found a frame"), help);
            *value = self.failed(span);
        }
    }

    /// Frames as sides of a loop are one mistake.
    pub(super) fn refuse_frame_loop(
        &mut self,
        left: &mut Expr,
        right: &mut Expr,
        span: SourceSpan,
    ) {
        if left.ty.is_frame() || right.ty.is_frame() {
            let fact = "the sides of a loop are scalars or vectors, found a frame";
            let help = "write a loop for `.origin`, and loops for what the axes do, such as `dot(a.x, b.x) = 0`";
            self.diagnostics.error_with_help(span, fact, help);
            [*left, *right] = [self.failed(span), self.failed(span)];
        }
    }

    /// The frame of which the turning is asked for.
    pub(super) fn turning(
        &mut self,
        word: &str,
        quantity: &syntax::Expr,
        context: Context,
    ) -> Expr {
        let value = self.moving_frame(word, quantity, context);
        if value.ty == Type::PlaneFrame {
            // It turns by its angle.
            let span = self.origins.span(value.origin);
            let ty = type_of_part(&value.ty, ANGLE_PART);
            return self.make(ExprKind::Index(Box::new(value), ANGLE_PART), ty, span);
        }
        value
    }

    /// A frame of which it is asked how it moves.
    pub(super) fn moving_frame(
        &mut self,
        word: &str,
        quantity: &syntax::Expr,
        context: Context,
    ) -> Expr {
        let mut value = self.expression(quantity, context);
        settle_alone(&mut value);
        if value.ty.is_frame() || value.ty.is_error() {
            return value;
        }
        let fact = format!(
            "`{word}` is about the turning of a frame, found {}",
            value.ty
        );
        let help = "`frame(origin, x, z)` makes a frame, in the plane `frame(origin, x)`; of anything else ask for `velocity` and \
                    `acceleration`";
        let span = self.origins.span(value.origin);
        self.diagnostics.error_with_help(span, fact, help);
        self.failed(span)
    }

    /// Derivatives of a frame are asked for its parts.
    pub(super) fn refuse_frame_derivative(&mut self, value: Expr) -> Expr {
        if !value.ty.is_frame() {
            return value;
        }
        let span = self.origins.span(value.origin);
        let help = self.parts_help("differentiate", &value);
        let help = match value.ty {
            Type::PlaneFrame => {
                format!("{help}, or `.angle`; `omega` and `alpha` say how it turns")
            }
            _ => format!("{help}; `omega` and `alpha` say how it turns"),
        };
        self.diagnostics
            .error_with_help(span, "a frame has no derivative", help);
        self.failed(span)
    }
}

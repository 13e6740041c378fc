//! Frames: their parts, the functions that make and use them, and where they cannot stand.

use proc_macro2::Ident;

use super::names::Resolver;
use super::operators::settle_alone;
use super::types::{Dimension, Expr, ExprKind, Function, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax::Word;

/// What a frame consists of, in this order.
pub(crate) const PARTS: [&str; 4] = ["origin", "x", "y", "z"];

pub(super) const PARTS_HELP: &str = "parts of a frame are `.origin`, `.x`, `.y` and `.z`";

impl Function {
    /// Whether some argument may be of this type although it has no arithmetic. Other functions refuse it.
    pub(super) fn takes(self, ty: &Type) -> bool {
        matches!(self, Function::PointIn | Function::CoordinatesIn) && *ty == Type::Frame
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
    /// `.origin`, `.x`, `.y` or `.z` of a frame.
    pub(super) fn part(&mut self, frame: Expr, field: &Ident, span: SourceSpan) -> Expr {
        let dimension = match field == PARTS[0] {
            true => Dimension::LENGTH,
            false => Dimension::NUMBER,
        };
        match PARTS.iter().position(|part| field == part) {
            Some(index) => {
                let kind = ExprKind::Index(Box::new(frame), index);
                self.make(kind, Type::Vector(3, dimension), span)
            }
            None => {
                let fact = format!("a frame has no part `{field}`");
                self.diagnostics
                    .error_with_help(field.into(), fact, PARTS_HELP);
                self.failed(span)
            }
        }
    }

    /// `frame(origin, x, z)`
    pub(super) fn frame(&mut self, arguments: &mut [Expr]) -> Option<Type> {
        let [origin, x, z] = arguments else {
            return None;
        };
        let function = Function::Frame;
        self.point(origin, function, "the origin of a frame is")?;
        self.vector_of(x, function, Some(3))?;
        self.vector_of(z, function, Some(3))?;
        Some(Type::Frame)
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
        if frame.ty != Type::Frame && point.ty == Type::Frame {
            let (first, frame) = (&frame.ty, &point.ty);
            let fact = format!("the arguments of `{name}` are swapped: found {first} and {frame}");
            let help = format!("write `{name}(frame, {})`", second.word);
            self.diagnostics.error_with_help(span, fact, help);
            return None;
        }
        if frame.ty != Type::Frame {
            settle_alone(frame);
            let help = "`frame(origin, x, z)` makes a frame";
            return self.wrong_argument(function, "a frame here", frame, help);
        }
        self.point(point, function, second.rule)?;
        Some(Type::Vector(3, Dimension::LENGTH))
    }

    /// A space vector of lengths; zeros are lengths here.
    fn point(&mut self, argument: &mut Expr, function: Function, role: &str) -> Option<()> {
        let wanted = Type::Vector(3, Dimension::LENGTH);
        argument.settle(&wanted);
        if self.refuse_compound(argument) {
            return None;
        }
        let (_, dimension) = self.vector_of(argument, function, Some(3))?;
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
        if value.ty == Type::Frame {
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
        if [&left.ty, &right.ty].contains(&&Type::Frame) {
            let fact = "the sides of a loop are scalars or vectors, found a frame";
            let help = "write a loop for `.origin`, and loops for what the axes do, such as `dot(a.x, b.x) = 0`";
            self.diagnostics.error_with_help(span, fact, help);
            [*left, *right] = [self.failed(span), self.failed(span)];
        }
    }

    /// Derivatives of a frame are asked for its parts.
    pub(super) fn refuse_frame_derivative(&mut self, value: Expr) -> Expr {
        if value.ty != Type::Frame {
            return value;
        }
        let span = self.origins.span(value.origin);
        let help = self.parts_help("differentiate", &value);
        self.diagnostics
            .error_with_help(span, "a frame has no derivative", help);
        self.failed(span)
    }
}

//! Calls: argument counts and dimensions.

use proc_macro2::Ident;

use super::frame::SecondArgument;
use super::functions::{CourseWord, QuantityWord};
use super::names::Resolver;
use super::operators::settle_alone;
use super::place::Context;
use super::types::{Dimension, Expr, ExprKind, Function, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, Word};

impl Resolver<'_> {
    pub(super) fn call(
        &mut self,
        ident: &Ident,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let name = ident.to_string();
        if let Some(quantity) = QuantityWord::from_word(&name) {
            return self.quantity_call(quantity, ident, arguments, context, span);
        }
        if let Some(course) = CourseWord::from_word(&name) {
            return self.course_call(course, arguments, context, span);
        }
        let Some(function) = Function::from_word(&name) else {
            self.unknown_function(ident);
            self.expressions(arguments, context);
            return self.failed(span);
        };
        let mut arguments = self.expressions(arguments, context);
        if !function.takes_count(arguments.len()) {
            self.wrong_count_of(function, arguments.len(), span);
            return self.failed(span);
        }
        let refused = arguments
            .iter()
            .filter(|argument| !function.takes(&argument.ty) && self.refuse_compound(argument))
            .count();
        if refused > 0 || arguments.iter().any(|argument| argument.ty.is_error()) {
            return self.failed(span);
        }
        match self.result(function, &mut arguments, span) {
            Some(ty) => self.make(ExprKind::Call(function, arguments), ty, span),
            None => self.failed(span),
        }
    }

    /// The type of a call with the right number of sound arguments.
    fn result(
        &mut self,
        function: Function,
        arguments: &mut [Expr],
        span: SourceSpan,
    ) -> Option<Type> {
        match function {
            Function::Polar => {
                let swapped = is_angle(&arguments[0]) && is_length(&arguments[1]);
                let swapped = swapped.then_some("polar(length, angle)");
                self.refuse_swapped(function, arguments, swapped, span)?;
                let length = self.scalar(&mut arguments[0], function)?;
                self.angle(&mut arguments[1], function)?;
                Some(Type::Vector(2, length))
            }
            Function::Dir => {
                self.angle(&mut arguments[0], function)?;
                Some(Type::Vector(2, Dimension::NUMBER))
            }
            Function::Rotate => {
                let swapped = is_angle(&arguments[0]).then(|| match &arguments[1].ty {
                    Type::Vector(3, _) | Type::Zero(3) => Some("turn(vector, axis, angle)"),
                    Type::Vector(..) => Some("rotate(vector, angle)"),
                    _ => None,
                });
                self.refuse_swapped(function, arguments, swapped.flatten(), span)?;
                let (_, dimension) = self.vector_of(&mut arguments[0], function, Some(2))?;
                self.angle(&mut arguments[1], function)?;
                Some(Type::Vector(2, dimension))
            }
            Function::Turn => {
                let swapped = matches!(arguments[2].ty, Type::Vector(..))
                    && arguments[..2].iter().any(is_angle);
                let swapped = swapped.then_some("turn(vector, axis, angle)");
                self.refuse_swapped(function, arguments, swapped, span)?;
                let (_, dimension) = self.vector_of(&mut arguments[0], function, Some(3))?;
                self.vector_of(&mut arguments[1], function, Some(3))?;
                self.angle(&mut arguments[2], function)?;
                Some(Type::Vector(3, dimension))
            }
            Function::Dot | Function::Cross => {
                self.in_one_space(function, &arguments[0], &arguments[1])?;
                let (count, left) = self.vector_of(&mut arguments[0], function, None)?;
                let (_, right) = self.vector_of(&mut arguments[1], function, Some(count))?;
                let spatial = function == Function::Cross && count == 3;
                let dimension = left.times(right).map(Dimension::of_arithmetic);
                let ty = dimension.map(|dimension| match spatial {
                    true => Type::Vector(3, dimension),
                    false => Type::Scalar(dimension),
                });
                self.in_range(ty, span)
            }
            Function::Norm => {
                let (_, dimension) = self.vector_of(&mut arguments[0], function, None)?;
                Some(Type::Scalar(dimension))
            }
            Function::Unit => {
                let (count, _) = self.vector_of(&mut arguments[0], function, None)?;
                Some(Type::Vector(count, Dimension::NUMBER))
            }
            Function::Angle => {
                self.vector_of(&mut arguments[0], function, Some(2))?;
                Some(Type::Scalar(Dimension::ANGLE))
            }
            Function::Distance => {
                self.in_one_space(function, &arguments[0], &arguments[1])?;
                let ty = self.alike(arguments, function)?;
                for argument in &mut *arguments {
                    self.vector_of(argument, function, None)?;
                }
                Some(Type::Scalar(ty.dimension()?))
            }
            Function::TriangleAngle | Function::Atan2 => {
                self.scalars_alike(arguments, function)?;
                Some(Type::Scalar(Dimension::ANGLE))
            }
            Function::Hypot | Function::Min | Function::Max => {
                self.scalars_alike(arguments, function)
            }
            Function::Abs => self.scalar(&mut arguments[0], function).map(Type::Scalar),
            Function::Sin | Function::Cos | Function::Tan => {
                self.angle(&mut arguments[0], function)?;
                Some(Type::NUMBER)
            }
            Function::Asin | Function::Acos | Function::Atan => {
                self.angle(&mut arguments[0], function)?;
                Some(Type::Scalar(Dimension::ANGLE))
            }
            Function::Sqrt => {
                let root = self.scalar(&mut arguments[0], function)?;
                let root = root.of_arithmetic().root();
                self.in_range(root.map(Type::Scalar), span)
            }
            Function::Frame => self.frame(arguments, span),
            Function::PointIn => {
                let second = SecondArgument {
                    rule: "coordinates in a frame are",
                    word: "vector",
                };
                self.in_frame(function, second, arguments, span)
            }
            Function::CoordinatesIn => {
                let second = SecondArgument {
                    rule: "a point is",
                    word: "point",
                };
                self.in_frame(function, second, arguments, span)
            }
        }
    }

    fn scalar(&mut self, argument: &mut Expr, function: Function) -> Option<Dimension> {
        settle_alone(argument);
        match argument.ty {
            Type::Scalar(dimension) => Some(dimension),
            _ => {
                let help = "take a component `.x` or the length `norm(v)`";
                self.wrong_argument(function, "a scalar here", argument, help)
            }
        }
    }

    /// An angle or a number.
    fn angle(&mut self, argument: &mut Expr, function: Function) -> Option<()> {
        settle_alone(argument);
        match argument.ty {
            Type::Scalar(dimension) if dimension.is_number_or_angle() => {
                if function.angle_argument().is_some() {
                    self.refuse_bare_argument(function, argument);
                }
                Some(())
            }
            Type::Scalar(_) => {
                let help = "give angles in `deg` or `rad`, or divide by a length for a number";
                self.wrong_argument(function, "an angle or a number here", argument, help)
            }
            _ => {
                let help = "`angle(v)` is the angle of a plane vector";
                self.wrong_argument(function, "an angle or a number here", argument, help)
            }
        }
    }

    pub(super) fn vector_of(
        &mut self,
        argument: &mut Expr,
        function: Function,
        wanted: Option<usize>,
    ) -> Option<(usize, Dimension)> {
        settle_alone(argument);
        let words = match wanted {
            Some(2) => "a plane vector",
            Some(_) => "a space vector",
            None => "a vector",
        };
        match argument.ty {
            Type::Vector(count, dimension) if wanted.is_none_or(|wanted| wanted == count) => {
                Some((count, dimension))
            }
            _ => {
                let help = self.vector_help(function, argument, wanted);
                self.wrong_argument(function, &format!("{words} here"), argument, &help)
            }
        }
    }

    fn alike(&mut self, arguments: &mut [Expr], function: Function) -> Option<Type> {
        let mut all: Vec<&mut Expr> = arguments.iter_mut().collect();
        let ty = self
            .common_type(&mut all, &format!("the arguments of `{}`", function.word()))
            .settled();
        all.into_iter().for_each(|argument| argument.settle(&ty));
        (!ty.is_error()).then_some(ty)
    }

    fn scalars_alike(&mut self, arguments: &mut [Expr], function: Function) -> Option<Type> {
        let ty = self.alike(arguments, function)?;
        for argument in arguments {
            self.scalar(argument, function)?;
        }
        Some(ty)
    }
}

fn is_angle(argument: &Expr) -> bool {
    matches!(argument.ty, Type::Scalar(dimension) if dimension.is_number_or_angle())
}

fn is_length(argument: &Expr) -> bool {
    matches!(argument.ty, Type::Scalar(_)) && !is_angle(argument)
}

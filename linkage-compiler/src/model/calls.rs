//! Calls: argument counts and dimensions.

use proc_macro2::Ident;

use super::derivative::QUANTITIES;
use super::functions::{FUNCTIONS, is_quantity};
use super::mechanics::MECHANICS;
use super::names::{Context, Resolver, kind};
use super::operators::settle_alone;
use super::types::{Dimension, Expr, ExprKind, Function, Type};
use crate::diagnostic::text::{count, nearest};
use crate::syntax::{self, SourceSpan};

impl Resolver<'_> {
    pub(super) fn call(
        &mut self,
        ident: &Ident,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let name = ident.to_string();
        if is_quantity(&name) {
            return self.quantity_call(&name, ident, arguments, context, span);
        }
        let Some((_, function, parameters)) = FUNCTIONS.iter().find(|(known, ..)| *known == name)
        else {
            self.unknown_function(ident);
            self.expressions(arguments, context);
            return self.failed(span);
        };
        let mut arguments = self.expressions(arguments, context);
        if arguments.len() != parameters.len() {
            self.wrong_count(&name, parameters, arguments.len(), span);
            return self.failed(span);
        }
        let refused = arguments
            .iter()
            .filter(|argument| !function.takes(&argument.ty) && self.refuse_compound(argument))
            .count();
        if refused > 0 || arguments.iter().any(|argument| argument.ty.is_error()) {
            return self.failed(span);
        }
        match self.result(*function, &mut arguments, span) {
            Some(ty) => self.make(ExprKind::Call(*function, arguments), ty, span),
            None => self.failed(span),
        }
    }

    fn unknown_function(&mut self, ident: &Ident) {
        let name = ident.to_string();
        let known = FUNCTIONS
            .iter()
            .map(|(known, ..)| *known)
            .chain(QUANTITIES)
            .chain(MECHANICS);
        let fact = match self.find(&name) {
            Some(symbol) => format!("`{name}` is {}, not a function", kind(symbol.name)),
            None => format!("unknown function `{name}`"),
        };
        let help = match (self.find(&name), nearest(&name, known)) {
            (Some(_), _) => format!("write `{name} * (...)` for a product"),
            (None, Some(function)) => format!("did you mean `{function}`?"),
            (None, None) if ["pow", "powi", "powf", "sq"].contains(&name.as_str()) => {
                "write `a * a` for a square".to_owned()
            }
            (None, None) => {
                let names: Vec<&str> = FUNCTIONS.iter().map(|(known, ..)| *known).collect();
                format!("functions are {}", names.join(" "))
            }
        };
        self.diagnostics.error_with_help(ident.into(), fact, help);
    }

    pub(super) fn wrong_count(
        &mut self,
        name: &str,
        parameters: &[&str],
        found: usize,
        span: SourceSpan,
    ) {
        let wanted = count(parameters.len(), "argument");
        let fact = format!("`{name}` takes {wanted}, found {found}");
        let help = match (name, found) {
            ("rotate", 3) => "write `turn(vector, axis, angle)` for a space vector".to_owned(),
            _ => format!("write `{name}({})`", parameters.join(", ")),
        };
        self.diagnostics.error_with_help(span, fact, help);
    }

    /// The type of a call with the right number of sound arguments.
    fn result(
        &mut self,
        function: Function,
        arguments: &mut [Expr],
        span: SourceSpan,
    ) -> Option<Type> {
        let name = function.name();
        match function {
            Function::Polar => {
                self.check_order(function, arguments, span)?;
                let length = self.scalar(&mut arguments[0], name)?;
                self.angle(&mut arguments[1], name)?;
                Some(Type::Vector(2, length))
            }
            Function::Dir => {
                self.angle(&mut arguments[0], name)?;
                Some(Type::Vector(2, Dimension::NUMBER))
            }
            Function::Rotate => {
                self.check_order(function, arguments, span)?;
                let (_, dimension) = self.vector_of(&mut arguments[0], name, Some(2))?;
                self.angle(&mut arguments[1], name)?;
                Some(Type::Vector(2, dimension))
            }
            Function::Turn => {
                self.check_order(function, arguments, span)?;
                let (_, dimension) = self.vector_of(&mut arguments[0], name, Some(3))?;
                self.vector_of(&mut arguments[1], name, Some(3))?;
                self.angle(&mut arguments[2], name)?;
                Some(Type::Vector(3, dimension))
            }
            Function::Dot | Function::Cross => {
                self.in_one_space(name, &arguments[0], &arguments[1])?;
                let (count, left) = self.vector_of(&mut arguments[0], name, None)?;
                let (_, right) = self.vector_of(&mut arguments[1], name, Some(count))?;
                let spatial = function == Function::Cross && count == 3;
                let dimension = left.times(right).map(Dimension::of_arithmetic);
                let ty = dimension.map(|dimension| match spatial {
                    true => Type::Vector(3, dimension),
                    false => Type::Scalar(dimension),
                });
                self.in_range(ty, span)
            }
            Function::Norm => {
                let (_, dimension) = self.vector_of(&mut arguments[0], name, None)?;
                Some(Type::Scalar(dimension))
            }
            Function::Unit => {
                let (count, _) = self.vector_of(&mut arguments[0], name, None)?;
                Some(Type::Vector(count, Dimension::NUMBER))
            }
            Function::Angle => {
                self.vector_of(&mut arguments[0], name, Some(2))?;
                Some(Type::Scalar(Dimension::ANGLE))
            }
            Function::Distance => {
                self.in_one_space(name, &arguments[0], &arguments[1])?;
                let ty = self.alike(arguments, name)?;
                for argument in &mut *arguments {
                    self.vector_of(argument, name, None)?;
                }
                Some(Type::Scalar(ty.dimension()?))
            }
            Function::TriangleAngle | Function::Atan2 => {
                self.scalars_alike(arguments, name)?;
                Some(Type::Scalar(Dimension::ANGLE))
            }
            Function::Hypot | Function::Min | Function::Max => self.scalars_alike(arguments, name),
            Function::Abs => self.scalar(&mut arguments[0], name).map(Type::Scalar),
            Function::Sin | Function::Cos | Function::Tan => {
                self.angle(&mut arguments[0], name)?;
                Some(Type::NUMBER)
            }
            Function::Asin | Function::Acos | Function::Atan => {
                self.angle(&mut arguments[0], name)?;
                Some(Type::Scalar(Dimension::ANGLE))
            }
            Function::Sqrt => {
                let root = self.scalar(&mut arguments[0], name)?;
                let root = root.of_arithmetic().root();
                self.in_range(root.map(Type::Scalar), span)
            }
            Function::Frame => self.frame(arguments),
            Function::PointIn | Function::CoordinatesIn => self.in_frame(function, arguments, span),
        }
    }

    /// Reports `polar(angle, length)`, `rotate(angle, vector)` and `turn(vector, angle, axis)`.
    fn check_order(
        &mut self,
        function: Function,
        arguments: &[Expr],
        span: SourceSpan,
    ) -> Option<()> {
        let angle = |k: usize| matches!(arguments[k].ty, Type::Scalar(d) if d.is_number_or_angle());
        let vector = |k: usize| matches!(arguments[k].ty, Type::Vector(..));
        let length = |k: usize| matches!(arguments[k].ty, Type::Scalar(_)) && !angle(k);
        let (swapped, order) = match function {
            Function::Polar => (angle(0) && length(1), "polar(length, angle)"),
            Function::Turn => (
                vector(2) && (angle(0) || angle(1)),
                "turn(vector, axis, angle)",
            ),
            _ if arguments[1].ty.components() == Some(3) => (angle(0), "turn(vector, axis, angle)"),
            _ => (angle(0) && vector(1), "rotate(vector, angle)"),
        };
        if !swapped {
            return Some(());
        }
        let found: Vec<String> = arguments.iter().map(|a| a.ty.to_string()).collect();
        let (last, before) = found.split_last()?;
        let fact = format!(
            "the arguments of `{}` are swapped: found {} and {last}",
            function.name(),
            before.join(", ")
        );
        self.diagnostics
            .error_with_help(span, fact, format!("write `{order}`"));
        None
    }

    pub(super) fn wrong_argument<T>(
        &mut self,
        name: &str,
        wanted: &str,
        found: &Expr,
        help: &str,
    ) -> Option<T> {
        let fact = format!("`{name}` takes {wanted}, found {}", found.ty);
        let span = self.origins.span(found.origin);
        match help {
            "" => self.diagnostics.error(span, fact),
            _ => self.diagnostics.error_with_help(span, fact, help),
        }
        None
    }

    fn scalar(&mut self, argument: &mut Expr, name: &str) -> Option<Dimension> {
        settle_alone(argument);
        match argument.ty {
            Type::Scalar(dimension) => Some(dimension),
            _ => {
                let help = "take a component `.x` or the length `norm(v)`";
                self.wrong_argument(name, "a scalar here", argument, help)
            }
        }
    }

    /// An angle or a number.
    fn angle(&mut self, argument: &mut Expr, name: &str) -> Option<()> {
        settle_alone(argument);
        match argument.ty {
            Type::Scalar(dimension) if dimension.is_number_or_angle() => Some(()),
            Type::Scalar(_) => {
                let help = "give angles in `deg` or `rad`, or divide by a length for a number";
                self.wrong_argument(name, "an angle or a number here", argument, help)
            }
            _ => {
                let help = "`angle(v)` is the angle of a plane vector";
                self.wrong_argument(name, "an angle or a number here", argument, help)
            }
        }
    }

    pub(super) fn vector_of(
        &mut self,
        argument: &mut Expr,
        name: &str,
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
                let help = self.vector_help(name, argument, wanted);
                self.wrong_argument(name, &format!("{words} here"), argument, &help)
            }
        }
    }

    fn alike(&mut self, arguments: &mut [Expr], name: &str) -> Option<Type> {
        let mut all: Vec<&mut Expr> = arguments.iter_mut().collect();
        let ty = self
            .common_type(&mut all, &format!("the arguments of `{name}`"))
            .settled();
        all.into_iter().for_each(|argument| argument.settle(&ty));
        (!ty.is_error()).then_some(ty)
    }

    fn scalars_alike(&mut self, arguments: &mut [Expr], name: &str) -> Option<Type> {
        let ty = self.alike(arguments, name)?;
        for argument in arguments {
            self.scalar(argument, name)?;
        }
        Some(ty)
    }
}

//! What functions ask about forces.

use proc_macro2::Ident;

use super::super::names::{Context, Place, Resolver};
use super::super::types::{Dimension, Expr, ExprKind, Mechanics, Name, Type};
use crate::diagnostic::text::list;
use crate::syntax::{self, JointKind, SourceSpan};

pub(in crate::model) const MECHANICS: [&str; 9] = [
    "reaction",
    "moment",
    "torque",
    "force",
    "power",
    "kinetic_energy",
    "potential_energy",
    "shaking_force",
    "shaking_moment",
];

impl Resolver<'_> {
    /// A quantity of the mechanics, in a function of these inputs and arguments.
    pub(in crate::model) fn mechanics_call(
        &mut self,
        name: &str,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        if self.mechanics.bodies == 0 {
            let fact = format!("`{name}` in a mechanism without bodies");
            let help = "declare what moves: `body crank = pin b1 on frame at pivot, turns phi, mass 100g at c;`";
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        let Some(components) = self.mechanics.components else {
            return self.failed(span);
        };
        let vector = |dimension| Type::Vector(components, dimension);
        let moment = match components {
            2 => Type::Scalar(Dimension::MOMENT),
            _ => vector(Dimension::MOMENT),
        };
        let asked = match name {
            "reaction" => self
                .joint_asked(name, arguments, span)
                .map(|joint| (Mechanics::Reaction(joint), vector(Dimension::FORCE))),
            "moment" => self
                .moment_asked(arguments, span)
                .map(|joint| (Mechanics::Moment(joint), moment)),
            "torque" | "force" => self.drive_asked(name, arguments, span),
            "shaking_moment" => self
                .moment_about(arguments, context, span)
                .map(|point| (Mechanics::ShakingMoment(point), moment)),
            _ => self.none_asked(name, arguments, span).map(|()| match name {
                "power" => (Mechanics::Power, Type::Scalar(Dimension::POWER)),
                "kinetic_energy" => (Mechanics::KineticEnergy, Type::Scalar(Dimension::MOMENT)),
                "potential_energy" => (Mechanics::PotentialEnergy, Type::Scalar(Dimension::MOMENT)),
                _ => (Mechanics::ShakingForce, vector(Dimension::FORCE)),
            }),
        };
        let moving = self.check_moving(name, context.place, span);
        match asked {
            Some((quantity, ty)) if moving => self.make(ExprKind::Mechanics(quantity), ty, span),
            _ => self.failed(span),
        }
    }

    fn none_asked(
        &mut self,
        name: &str,
        arguments: &[syntax::Expr],
        span: SourceSpan,
    ) -> Option<()> {
        if !arguments.is_empty() {
            self.wrong_count(name, &[], arguments.len(), span);
        }
        arguments.is_empty().then_some(())
    }

    /// The one argument of a call, a name.
    fn name_asked<'e>(
        &mut self,
        name: &str,
        what: &str,
        arguments: &'e [syntax::Expr],
        span: SourceSpan,
    ) -> Option<&'e Ident> {
        let [argument] = arguments else {
            self.wrong_count(name, &[what], arguments.len(), span);
            return None;
        };
        match &argument.kind {
            syntax::ExprKind::Name(ident) => Some(ident),
            syntax::ExprKind::Error => None,
            _ => {
                let fact = format!("`{name}` takes the name of a {what}, found an expression");
                let help = format!("write `{name}({what})`");
                self.diagnostics.error_with_help(argument.span, fact, help);
                None
            }
        }
    }

    fn joint_asked(
        &mut self,
        name: &str,
        arguments: &[syntax::Expr],
        span: SourceSpan,
    ) -> Option<usize> {
        let ident = self.name_asked(name, "joint", arguments, span)?;
        self.joint_named(ident)
    }

    /// A joint that takes a moment.
    fn moment_asked(&mut self, arguments: &[syntax::Expr], span: SourceSpan) -> Option<usize> {
        let joint = self.joint_asked("moment", arguments, span)?;
        let kind = self.mechanics.joints[joint];
        let free = match self.mechanics.components {
            Some(2) => kind == JointKind::Pin,
            _ => kind == JointKind::Ball,
        };
        if free {
            let fact = format!("a `{}` takes no moment", kind.word());
            let help = "ask for its `reaction`";
            self.diagnostics.error_with_help(span, fact, help);
        }
        (!free).then_some(joint)
    }

    /// `torque(input)` of an angle, `force(input)` of a length.
    fn drive_asked(
        &mut self,
        name: &str,
        arguments: &[syntax::Expr],
        span: SourceSpan,
    ) -> Option<(Mechanics, Type)> {
        let ident = self.name_asked(name, "input", arguments, span)?;
        let text = ident.to_string();
        let input = self.find(&text).and_then(|symbol| match symbol.name {
            Name::Input(input) => Some((input, symbol.ty.dimension()?)),
            _ => None,
        });
        let Some((input, dimension)) = input else {
            if self.find(&text).is_some_and(|symbol| symbol.ty.is_error()) {
                return None;
            }
            let inputs = self.names_of(|name| matches!(name, Name::Input(_)));
            let fact = format!("`{name}` takes an input, `{text}` is none");
            let help = match inputs.is_empty() {
                true => "declare an `input`".to_owned(),
                false => format!("inputs are {}", list(&inputs)),
            };
            self.diagnostics.error_with_help(ident.into(), fact, help);
            return None;
        };
        let (right, ty) = match dimension.is_number_or_angle() {
            true => ("torque", Dimension::MOMENT),
            false => ("force", Dimension::FORCE),
        };
        if right != name {
            let fact = format!("the input `{text}` is {dimension}, it is driven by a {right}");
            let help = format!("write `{right}({text})`");
            self.diagnostics.error_with_help(span, fact, help);
            return None;
        }
        Some((Mechanics::Drive(input), Type::Scalar(ty)))
    }

    /// `shaking_moment()`, `shaking_moment(point)`
    fn moment_about(
        &mut self,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Option<Option<Box<Expr>>> {
        let point = match arguments {
            [] => return Some(None),
            [point] => point,
            _ => {
                self.wrong_count("shaking_moment", &["point"], arguments.len(), span);
                return None;
            }
        };
        let value = self.expression(point, context);
        let length = Some(Dimension::LENGTH);
        let value = self.vector_value(value, length, "shaking_moment", "(0, 0)");
        (!value.ty.is_error()).then(|| Some(Box::new(value)))
    }

    /// Reports quantities that are zero at rest in a function without a speed.
    fn check_moving(&mut self, name: &str, place: Place, span: SourceSpan) -> bool {
        let Place::Function(listed) = place else {
            return true;
        };
        let orders = match name {
            "power" | "kinetic_energy" => 1,
            "shaking_force" | "shaking_moment" => 2,
            _ => return true,
        };
        // A mistake in the list of inputs has been reported.
        let Some(listed) = listed else {
            return false;
        };
        let rates = self.rates.iter().flat_map(|rates| &rates[..orders]);
        let rates: Vec<usize> = rates.copied().flatten().collect();
        if rates
            .iter()
            .any(|rate| listed.contains(&(self.input_count + rate)))
        {
            return true;
        }
        let names: Vec<&str> = self
            .symbols
            .iter()
            .filter(|symbol| matches!(symbol.name, Name::Argument(rate) if rates.contains(&rate)))
            .map(|symbol| symbol.text.as_str())
            .collect();
        let fact = format!("`{name}` at rest is zero: the function lists no speed");
        let help = match (
            names.as_slice(),
            self.names_of(|name| matches!(name, Name::Input(_)))[..].first(),
        ) {
            ([], Some(input)) => {
                format!("declare one, `input {input} = ... at omega`, and list it as an argument")
            }
            ([], None) => {
                "declare an `input` and its speed: `input phi = 30deg at omega`".to_owned()
            }
            _ => format!("list the speed as an argument: {}", list(&names)),
        };
        self.diagnostics.error_with_help(span, fact, help);
        false
    }
}

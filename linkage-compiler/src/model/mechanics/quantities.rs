//! What functions ask about forces.

use proc_macro2::Ident;

use super::super::functions::MechanicsWord;
use super::super::names::Resolver;
use super::super::place::{Context, Place};
use super::super::types::{Dimension, Expr, ExprKind, Mechanics, Name, Type};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::list;
use crate::syntax::{self, JointKind, Member, Word};

impl Resolver<'_> {
    /// A quantity of the mechanics, in a function of these inputs and arguments.
    pub(in crate::model) fn mechanics_call(
        &mut self,
        word: MechanicsWord,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let name = word.word();
        // What a part with a mistake consists of is not known.
        if self.parts.iter().any(|part| part.body.is_none()) {
            return self.failed(span);
        }
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
        let scalar = |quantity, dimension| (quantity, Type::Scalar(dimension));
        let asked = match word {
            MechanicsWord::Reaction => self
                .joint_asked(word, arguments, span)
                .map(|joint| (Mechanics::Reaction(joint), vector(Dimension::FORCE))),
            MechanicsWord::Moment => self
                .moment_asked(arguments, span)
                .map(|joint| (Mechanics::Moment(joint), moment)),
            MechanicsWord::Torque | MechanicsWord::Force => self.drive_asked(word, arguments, span),
            MechanicsWord::ShakingMoment => self
                .moment_about(arguments, context, span)
                .map(|point| (Mechanics::ShakingMoment(point), moment)),
            MechanicsWord::Power => self
                .none_asked(word, arguments, span)
                .map(|()| scalar(Mechanics::Power, Dimension::POWER)),
            MechanicsWord::KineticEnergy => self
                .none_asked(word, arguments, span)
                .map(|()| scalar(Mechanics::KineticEnergy, Dimension::MOMENT)),
            MechanicsWord::PotentialEnergy => self
                .none_asked(word, arguments, span)
                .map(|()| scalar(Mechanics::PotentialEnergy, Dimension::MOMENT)),
            MechanicsWord::ShakingForce => self
                .none_asked(word, arguments, span)
                .map(|()| (Mechanics::ShakingForce, vector(Dimension::FORCE))),
        };
        let moving = self.check_moving(word, context.place, span);
        match asked {
            Some((quantity, ty)) if moving => self.make(ExprKind::Mechanics(quantity), ty, span),
            _ => self.failed(span),
        }
    }

    fn none_asked(
        &mut self,
        word: MechanicsWord,
        arguments: &[syntax::Expr],
        span: SourceSpan,
    ) -> Option<()> {
        if !arguments.is_empty() {
            self.wrong_count(word.word(), &[], arguments.len(), span);
        }
        arguments.is_empty().then_some(())
    }

    /// The one argument of a call, a name.
    fn name_asked<'e>(
        &mut self,
        word: MechanicsWord,
        what: &str,
        arguments: &'e [syntax::Expr],
        span: SourceSpan,
    ) -> Option<&'e Ident> {
        let name = word.word();
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
        word: MechanicsWord,
        arguments: &[syntax::Expr],
        span: SourceSpan,
    ) -> Option<usize> {
        if let [argument] = arguments
            && let Some(text) = self.dotted(argument)
        {
            let span = argument.span;
            return self.joint_named(&Member { text, span });
        }
        let ident = self.name_asked(word, "joint", arguments, span)?;
        self.joint_named(&ident.into())
    }

    /// A joint that takes a moment.
    fn moment_asked(&mut self, arguments: &[syntax::Expr], span: SourceSpan) -> Option<usize> {
        let joint = self.joint_asked(MechanicsWord::Moment, arguments, span)?;
        let kind = self.mechanics.joints[joint];
        let free = match kind {
            JointKind::Pin => self.mechanics.components == Some(2),
            // In the plane there is none.
            JointKind::Ball => self.mechanics.components != Some(2),
            JointKind::Slide | JointKind::Cylinder | JointKind::Fixed => false,
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
        word: MechanicsWord,
        arguments: &[syntax::Expr],
        span: SourceSpan,
    ) -> Option<(Mechanics, Type)> {
        let name = word.word();
        let ident = self.name_asked(word, "input", arguments, span)?;
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
            true => (MechanicsWord::Torque, Dimension::MOMENT),
            false => (MechanicsWord::Force, Dimension::FORCE),
        };
        if right != word {
            let right = right.word();
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
        let name = MechanicsWord::ShakingMoment.word();
        let point = match arguments {
            [] => return Some(None),
            [point] => point,
            _ => {
                self.wrong_count(name, &["point"], arguments.len(), span);
                return None;
            }
        };
        let value = self.expression(point, context);
        let length = Some(Dimension::LENGTH);
        let value = self.vector_value(value, length, name, "(0, 0)");
        (!value.ty.is_error()).then(|| Some(Box::new(value)))
    }

    /// Reports quantities that are zero at rest in a function without a speed.
    fn check_moving(&mut self, word: MechanicsWord, place: Place, span: SourceSpan) -> bool {
        let Place::Function(listed) = place else {
            return true;
        };
        let name = word.word();
        let orders = match word {
            MechanicsWord::Power | MechanicsWord::KineticEnergy => 1,
            MechanicsWord::ShakingForce | MechanicsWord::ShakingMoment => 2,
            MechanicsWord::Reaction
            | MechanicsWord::Moment
            | MechanicsWord::Torque
            | MechanicsWord::Force
            | MechanicsWord::PotentialEnergy => return true,
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

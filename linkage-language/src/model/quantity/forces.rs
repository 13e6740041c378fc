//! Quantities about forces: reactions, drives, energies, shaking forces.

use super::dynamics::{check_members, expect_input_of, resolve_inertia};
use super::force_arguments::{
    expect_driven_input, expect_joint, expect_joint_with_moment, expect_no_argument,
};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::list;
use crate::model::expression::call_messages::refuse_wrong_count;
use crate::model::expression::clause_values::check_vector;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Site;
use crate::model::symbols::values::Values;
use crate::model::types::{
    Dimension, Expr, ExprKind, MechanicalQuantity, MechanicsWord, Name, Type,
};
use crate::syntax::{self, Word};

/// A quantity of the mechanics, in a function of these inputs and arguments.
pub(in crate::model) fn resolve_mechanics_quantity(
    operands: Operands,
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let name = word.word();
    // The content of a part with a mistake is unknown, as are the bodies that links with one are.
    let mut parts = operands.scope.parts.scopes.iter();
    if operands.scope.members.links.lost || parts.any(|part| part.body.is_none()) {
        return error_expr(sink, span);
    }
    if operands.scope.members.bodies == 0 {
        let fact = format!("`{name}` in a mechanism without bodies");
        let help = "declare what moves: `body crank = pin b1 on frame at pivot, turns phi, mass 100g at c;`";
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    }
    if !check_members(&operands.scope.members, sink, word, span) {
        return error_expr(sink, span);
    }
    let Some(components) = sink.components else {
        return error_expr(sink, span);
    };
    let vector = |dimension| Type::Vector(components, dimension);
    let moment = match components {
        2 => Type::Scalar(Dimension::MOMENT),
        _ => vector(Dimension::MOMENT),
    };
    let scalar = |quantity, dimension| (quantity, Type::Scalar(dimension));
    let of_input = |sink: &mut Sink, quantity| {
        expect_input_of(&operands.scope.names, sink, word, quantity, arguments, span)
    };
    let asked = match word {
        MechanicsWord::Reaction => expect_joint(
            &operands.scope.parts,
            &operands.scope.members,
            sink,
            word,
            arguments,
            span,
        )
        .map(|joint| {
            (
                MechanicalQuantity::Reaction(joint),
                vector(Dimension::FORCE),
            )
        }),
        MechanicsWord::Moment => expect_joint_with_moment(
            &operands.scope.parts,
            &operands.scope.members,
            sink,
            arguments,
            span,
        )
        .map(|joint| (MechanicalQuantity::Moment(joint), moment)),
        MechanicsWord::Torque | MechanicsWord::Force => {
            expect_driven_input(&operands.scope.names, sink, word, arguments, span)
        }
        MechanicsWord::ShakingMoment => resolve_moment_point(operands, sink, arguments, span)
            .map(|point| (MechanicalQuantity::ShakingMoment(point), moment)),
        MechanicsWord::Power => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::Power, Dimension::POWER)),
        MechanicsWord::FrictionPower => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::FrictionPower, Dimension::POWER)),
        MechanicsWord::Efficiency => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::Efficiency, Dimension::NUMBER)),
        MechanicsWord::KineticEnergy => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::KineticEnergy, Dimension::MOMENT)),
        MechanicsWord::PotentialEnergy => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::PotentialEnergy, Dimension::MOMENT)),
        MechanicsWord::ShakingForce => expect_no_argument(sink, word, arguments, span)
            .map(|()| (MechanicalQuantity::ShakingForce, vector(Dimension::FORCE))),
        MechanicsWord::Inertia => resolve_inertia(&operands, sink, arguments, span),
        MechanicsWord::Bias => of_input(sink, MechanicalQuantity::Bias),
        MechanicsWord::GeneralisedForce => of_input(sink, MechanicalQuantity::GeneralisedForce),
        MechanicsWord::DrivenAcceleration => of_input(sink, MechanicalQuantity::DrivenAcceleration),
    };
    let moving = check_moving(
        &operands.scope.names,
        &operands.scope.values,
        sink,
        word,
        operands.context.site,
        span,
    );
    match asked {
        Some((quantity, ty)) if moving => make_expr(sink, ExprKind::Mechanics(quantity), ty, span),
        _ => error_expr(sink, span),
    }
}

/// `shaking_moment()`, `shaking_moment(point)`
fn resolve_moment_point(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<Option<Box<Expr>>> {
    let name = MechanicsWord::ShakingMoment.word();
    let point = match arguments {
        [] => return Some(None),
        [point] => point,
        _ => {
            refuse_wrong_count(sink, name, &["point"], arguments.len(), span);
            return None;
        }
    };
    let value = operands.resolve(sink, point);
    let length = Some(Dimension::LENGTH);
    let value = check_vector(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        value,
        length,
        name,
        "(0, 0)",
    );
    (!value.ty.is_error()).then(|| Some(Box::new(value)))
}

/// Reports quantities that are zero at rest in a function without a speed.
fn check_moving(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    word: MechanicsWord,
    site: Site,
    span: SourceSpan,
) -> bool {
    let Site::Function(listed) = site else {
        return true;
    };
    let name = word.word();
    let orders = match word {
        MechanicsWord::Power
        | MechanicsWord::KineticEnergy
        | MechanicsWord::FrictionPower
        | MechanicsWord::Efficiency => 1,
        MechanicsWord::ShakingForce | MechanicsWord::ShakingMoment => 2,
        MechanicsWord::Reaction
        | MechanicsWord::Moment
        | MechanicsWord::Torque
        | MechanicsWord::Force
        | MechanicsWord::PotentialEnergy
        | MechanicsWord::Inertia
        | MechanicsWord::Bias
        | MechanicsWord::GeneralisedForce
        | MechanicsWord::DrivenAcceleration => return true,
    };
    // A mistake in the list of inputs has been reported.
    let Some(listed) = listed else {
        return false;
    };
    let rates = values.rates.iter().flat_map(|rates| &rates[..orders]);
    let rates: Vec<usize> = rates.copied().flatten().collect();
    if rates
        .iter()
        .any(|rate| listed.contains(&(values.input_count + rate)))
    {
        return true;
    }
    let speeds: Vec<&str> = names
        .symbols
        .iter()
        .filter(|symbol| matches!(symbol.name, Name::Argument(rate) if rates.contains(&rate)))
        .map(|symbol| symbol.text.as_str())
        .collect();
    let fact = match word {
        MechanicsWord::Efficiency => {
            format!("`{name}` is that of a motion: the function lists no speed")
        }
        _ => format!("`{name}` at rest is zero: the function lists no speed"),
    };
    let help = match (
        speeds.as_slice(),
        names.names_of(|name| matches!(name, Name::Input(_)))[..].first(),
    ) {
        ([], Some(input)) => {
            format!("declare one, `input {input} = ... at omega`, and list it as an argument")
        }
        ([], None) => "declare an `input` and its speed: `input phi = 30deg at omega`".to_owned(),
        _ => format!("list the speed as an argument: {}", list(&speeds)),
    };
    sink.error_with_help(span, fact, help);
    false
}

//! What functions ask about forces.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::list;
use crate::model::expression::call_messages::refuse_wrong_count;
use crate::model::expression::clause_values::check_vector;
use crate::model::expression::members::find_joint;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Site;
use crate::model::symbols::values::Values;
use crate::model::types::{
    Dimension, Expr, ExprKind, MechanicalQuantity, MechanicsWord, Name, Type,
};
use crate::syntax::{self, JointKind, Member, Word};

/// A quantity of the mechanics, in a function of these inputs and arguments.
pub(in crate::model) fn resolve_mechanics_quantity(
    operands: Operands,
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let name = word.word();
    // What a part with a mistake consists of is not known.
    if operands
        .scope
        .parts
        .scopes
        .iter()
        .any(|part| part.body.is_none())
    {
        return error_expr(sink, span);
    }
    if operands.scope.members.bodies == 0 {
        let fact = format!("`{name}` in a mechanism without bodies");
        let help = "declare what moves: `body crank = pin b1 on frame at pivot, turns phi, mass 100g at c;`";
        sink.error_with_help(span, fact, help);
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
        MechanicsWord::KineticEnergy => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::KineticEnergy, Dimension::MOMENT)),
        MechanicsWord::PotentialEnergy => expect_no_argument(sink, word, arguments, span)
            .map(|()| scalar(MechanicalQuantity::PotentialEnergy, Dimension::MOMENT)),
        MechanicsWord::ShakingForce => expect_no_argument(sink, word, arguments, span)
            .map(|()| (MechanicalQuantity::ShakingForce, vector(Dimension::FORCE))),
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

fn expect_no_argument(
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<()> {
    if !arguments.is_empty() {
        refuse_wrong_count(sink, word.word(), &[], arguments.len(), span);
    }
    arguments.is_empty().then_some(())
}

/// The one argument of a call, a name.
fn expect_name<'e>(
    sink: &mut Sink,
    word: MechanicsWord,
    what: &str,
    arguments: &'e [syntax::Expr],
    span: SourceSpan,
) -> Option<&'e Ident> {
    let name = word.word();
    let [argument] = arguments else {
        refuse_wrong_count(sink, name, &[what], arguments.len(), span);
        return None;
    };
    match &argument.kind {
        syntax::ExprKind::Name(ident) => Some(ident),
        syntax::ExprKind::Error => None,
        _ => {
            let fact = format!("`{name}` takes the name of a {what}, found an expression");
            let help = format!("write `{name}({what})`");
            sink.error_with_help(argument.span, fact, help);
            None
        }
    }
}

fn expect_joint(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<usize> {
    if let [argument] = arguments
        && let Some(text) = parts.dotted(argument)
    {
        let span = argument.span;
        return find_joint(parts, members, sink, &Member { text, span });
    }
    let ident = expect_name(sink, word, "joint", arguments, span)?;
    find_joint(parts, members, sink, &ident.into())
}

/// A joint that takes a moment.
fn expect_joint_with_moment(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<usize> {
    let joint = expect_joint(parts, members, sink, MechanicsWord::Moment, arguments, span)?;
    let kind = members.joints[joint];
    let free = match kind {
        JointKind::Pin => sink.components == Some(2),
        // In the plane there is none.
        JointKind::Ball => sink.components != Some(2),
        JointKind::Slide | JointKind::Cylinder | JointKind::Fixed => false,
    };
    if free {
        let fact = format!("a `{}` takes no moment", kind.word());
        let help = "ask for its `reaction`";
        sink.error_with_help(span, fact, help);
    }
    (!free).then_some(joint)
}

/// `torque(input)` of an angle, `force(input)` of a length.
fn expect_driven_input(
    names: &Names,
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MechanicalQuantity, Type)> {
    let name = word.word();
    let ident = expect_name(sink, word, "input", arguments, span)?;
    let text = ident.to_string();
    let input = names.find(&text).and_then(|symbol| match symbol.name {
        Name::Input(input) => Some((input, symbol.ty.dimension()?)),
        _ => None,
    });
    let Some((input, dimension)) = input else {
        if names.find(&text).is_some_and(|symbol| symbol.ty.is_error()) {
            return None;
        }
        let inputs = names.names_of(|name| matches!(name, Name::Input(_)));
        let fact = format!("`{name}` takes an input, `{text}` is none");
        let help = match inputs.is_empty() {
            true => "declare an `input`".to_owned(),
            false => format!("inputs are {}", list(&inputs)),
        };
        sink.error_with_help(ident.into(), fact, help);
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
        sink.error_with_help(span, fact, help);
        return None;
    }
    Some((MechanicalQuantity::Drive(input), Type::Scalar(ty)))
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
    let fact = format!("`{name}` at rest is zero: the function lists no speed");
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

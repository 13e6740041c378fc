//! Arguments of quantities about forces: joints and inputs.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::list;
use crate::model::expression::call_messages::refuse_wrong_count;
use crate::model::expression::members::find_joint;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, MechanicalQuantity, MechanicsWord, Name, Type};
use crate::syntax::{self, Member, Word};

pub(in crate::model) fn expect_no_argument(
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
pub(in crate::model) fn expect_name<'e>(
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

pub(in crate::model) fn expect_joint(
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
pub(in crate::model) fn expect_joint_with_moment(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<usize> {
    let joint = expect_joint(parts, members, sink, MechanicsWord::Moment, arguments, span)?;
    let kind = members.joints[joint];
    let free = kind.turns_in_every_way(sink.components == Some(2));
    if free {
        let fact = format!("a `{}` takes no moment", kind.word());
        let help = "ask for its `reaction`";
        sink.error_with_help(span, fact, help);
    }
    (!free).then_some(joint)
}

/// `torque(input)` of an angle, `force(input)` of a length.
pub(in crate::model) fn expect_driven_input(
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
        let help = if inputs.is_empty() {
            "declare an `input`".to_owned()
        } else {
            format!("inputs are {}", list(&inputs))
        };
        sink.error_with_help(ident.into(), fact, help);
        return None;
    };
    let (right, ty) = if dimension.is_number_or_angle() {
        (MechanicsWord::Torque, Dimension::MOMENT)
    } else {
        (MechanicsWord::Force, Dimension::FORCE)
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

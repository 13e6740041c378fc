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
    let [argument] = arguments else {
        refuse_wrong_count(sink, word.word(), &[what], arguments.len(), span);
        return None;
    };
    argument_name(sink, word, what, argument)
}

/// An argument of a call, a name.
fn argument_name<'e>(
    sink: &mut Sink,
    word: MechanicsWord,
    what: &str,
    argument: &'e syntax::Expr,
) -> Option<&'e Ident> {
    match &argument.kind {
        syntax::ExprKind::Name(ident) => Some(ident),
        syntax::ExprKind::Error => None,
        _ => {
            let name = word.word();
            let article = if what == "input" { "an" } else { "a" };
            let fact = format!("`{name}` takes the name of {article} {what}, found an expression");
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

/// An input that a quantity takes.
pub(in crate::model) struct TakenInput<'e> {
    pub(in crate::model) index: usize,
    pub(in crate::model) dimension: Dimension,
    pub(in crate::model) ident: &'e Ident,
}

impl TakenInput<'_> {
    /// Returns true for an angle, which is driven by a torque; a length is driven by a force.
    pub(in crate::model) fn turns(&self) -> bool {
        self.dimension.is_number_or_angle()
    }

    /// Returns the type of its drive.
    pub(in crate::model) fn drive_type(&self) -> Type {
        Type::Scalar(if self.turns() {
            Dimension::MOMENT
        } else {
            Dimension::FORCE
        })
    }
}

/// The one argument of a call, an input.
pub(in crate::model) fn expect_input<'e>(
    names: &Names,
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &'e [syntax::Expr],
    span: SourceSpan,
) -> Option<TakenInput<'e>> {
    let ident = expect_name(sink, word, "input", arguments, span)?;
    find_input(names, sink, word, ident)
}

/// An argument of a call of several, an input.
pub(in crate::model) fn find_input_argument<'e>(
    names: &Names,
    sink: &mut Sink,
    word: MechanicsWord,
    argument: &'e syntax::Expr,
) -> Option<TakenInput<'e>> {
    let ident = argument_name(sink, word, "input", argument)?;
    find_input(names, sink, word, ident)
}

fn find_input<'e>(
    names: &Names,
    sink: &mut Sink,
    word: MechanicsWord,
    ident: &'e Ident,
) -> Option<TakenInput<'e>> {
    let name = word.word();
    let text = ident.to_string();
    let symbol = names.find(&text);
    if symbol.is_some_and(|symbol| symbol.ty.is_error()) {
        return None;
    }
    if let Some(symbol) = symbol
        && let Name::Input(index) = symbol.name
        && let Some(dimension) = symbol.ty.dimension()
    {
        return Some(TakenInput {
            index,
            dimension,
            ident,
        });
    }
    let inputs = names.names_of(|name| matches!(name, Name::Input(_)));
    let fact = format!("`{name}` takes an input, `{text}` is none");
    let help = if inputs.is_empty() {
        "declare an `input`".to_owned()
    } else {
        format!("inputs are {}", list(&inputs))
    };
    sink.error_with_help(ident.into(), fact, help);
    None
}

/// `torque(input)` of an angle, `force(input)` of a length.
pub(in crate::model) fn expect_driven_input(
    names: &Names,
    sink: &mut Sink,
    word: MechanicsWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MechanicalQuantity, Type)> {
    let input = expect_input(names, sink, word, arguments, span)?;
    let right = if input.turns() {
        MechanicsWord::Torque
    } else {
        MechanicsWord::Force
    };
    if right != word {
        let (right, text, dimension) = (right.word(), input.ident, input.dimension);
        let fact = format!("the input `{text}` is {dimension}, it is driven by a {right}");
        let help = format!("write `{right}({text})`");
        sink.error_with_help(span, fact, help);
        return None;
    }
    Some((MechanicalQuantity::Drive(input.index), input.drive_type()))
}

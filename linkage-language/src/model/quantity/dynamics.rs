//! Quantities of the equation of motion: inertias, bias, forces and accelerations of inputs.

use super::force_arguments::{expect_input, find_input_argument};
use super::input_derivative::listed_inputs;
use crate::diagnostic::SourceSpan;
use crate::model::expression::call_messages::refuse_wrong_count;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Site;
use crate::model::types::{Dimension, MechanicalQuantity, MechanicsWord, Name, Type};
use crate::syntax::{self, Word};

/// `bias(input)`, `generalised_force(input)`, `driven_acceleration(input)`: a quantity of an input
/// with the type of its drive or of its acceleration.
pub(in crate::model) fn expect_input_of(
    names: &Names,
    sink: &mut Sink,
    word: MechanicsWord,
    quantity: fn(usize) -> MechanicalQuantity,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MechanicalQuantity, Type)> {
    let input = expect_input(names, sink, word, arguments, span)?;
    let ty = match word {
        MechanicsWord::DrivenAcceleration => Type::Scalar(input.dimension.rate(2)),
        _ => input.drive_type(),
    };
    Some((quantity(input.index), ty))
}

/// `inertia(input)`, `inertia(input, input)`, and `inertia()` of all inputs of the function.
pub(in crate::model) fn resolve_inertia(
    operands: &Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MechanicalQuantity, Type)> {
    let (word, names) = (MechanicsWord::Inertia, &operands.scope.names);
    let mut input = |argument| Some(find_input_argument(names, sink, word, argument)?.index);
    match arguments {
        [] => {
            let Site::Function(Some(listed)) = operands.context.site else {
                // A mistake in the list of inputs has been reported.
                return None;
            };
            let values = &operands.scope.values;
            let inputs = listed_inputs(names, values, sink, word.word(), listed, span)?;
            mass_matrix(names, inputs)
        }
        [of] => {
            let of = input(of)?;
            entry(names, [of, of])
        }
        [a, b] => {
            let inputs = [input(a)?, input(b)?];
            entry(names, inputs)
        }
        _ => {
            refuse_wrong_count(
                sink,
                word.word(),
                &["input", "input"],
                arguments.len(),
                span,
            );
            None
        }
    }
}

fn mass_matrix(names: &Names, inputs: Vec<usize>) -> Option<(MechanicalQuantity, Type)> {
    if let [of] = inputs[..] {
        return entry(names, [of, of]);
    }
    let row = |&a: &usize| {
        let entries = inputs.iter().map(|&b| Some(entry(names, [a, b])?.1));
        Some(Type::Array(entries.collect::<Option<_>>()?))
    };
    let rows = inputs.iter().map(row).collect::<Option<_>>()?;
    Some((MechanicalQuantity::MassMatrix(inputs), Type::Array(rows)))
}

/// A moment of inertia divided by the length of each input that is a length.
fn entry(names: &Names, inputs: [usize; 2]) -> Option<(MechanicalQuantity, Type)> {
    let mut dimension = Dimension::INERTIA;
    for input in inputs {
        let by = names.symbol(Name::Input(input))?.ty.dimension()?;
        dimension = dimension.over(by)?;
    }
    Some((MechanicalQuantity::Inertia(inputs), Type::Scalar(dimension)))
}

/// Reports a quantity of masses in a mechanism without masses, one of loads without loads, or one of
/// friction without friction.
pub(in crate::model) fn check_members(
    members: &MemberNames,
    sink: &mut Sink,
    word: MechanicsWord,
    span: SourceSpan,
) -> bool {
    let name = word.word();
    let (fact, help) = match word {
        MechanicsWord::Inertia | MechanicsWord::Bias | MechanicsWord::DrivenAcceleration
            if !members.has_masses =>
        {
            (
                format!("`{name}` in a mechanism without masses"),
                "give a body a mass or a moment of inertia: `mass 100g at c, inertia 50kg*mm^2`",
            )
        }
        MechanicsWord::GeneralisedForce if !members.has_loads && !members.has_friction => (
            format!("`{name}` in a mechanism without loads"),
            "declare a `force`, a `torque`, a `spring` or a `damper`",
        ),
        MechanicsWord::FrictionPower | MechanicsWord::Efficiency if !members.has_friction => (
            format!("`{name}` in a mechanism without friction"),
            "declare it: `friction 0.1 on PIN, radius 8mm`, `friction 0.1 on SLIDE`",
        ),
        _ => return true,
    };
    sink.error_with_help(span, fact, help);
    false
}

//! Derivatives with respect to the inputs of a function.

use crate::diagnostic::SourceSpan;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::values::Values;
use crate::model::types::{Dimension, Expr, ExprKind, Name, Type, Variable};

/// The inputs that a function lists among its arguments; that there is none is a mistake.
pub(in crate::model) fn listed_inputs(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    name: &str,
    arguments: &[usize],
    span: SourceSpan,
) -> Option<Vec<usize>> {
    let drives = arguments
        .iter()
        .filter(|input| **input < values.input_count);
    let drives: Vec<usize> = drives.copied().collect();
    if drives.is_empty() {
        let fact = format!("`{name}` in a function without an input");
        let help = match names
            .names_of(|name| matches!(name, Name::Input(_)))
            .first()
        {
            Some(input) => format!("list the input: `fn name({input})`"),
            None => "declare an `input` in the struct block".to_owned(),
        };
        sink.error_with_help(span, fact, help);
        return None;
    }
    Some(drives)
}

pub(in crate::model) fn refuse_several_inputs(
    sink: &mut Sink,
    name: &str,
    count: usize,
    help: &str,
    span: SourceSpan,
) {
    let fact = format!("`{name}` needs one input, the function has {count}");
    sink.error_with_help(span, fact, help);
}

/// The derivative by these inputs; of a frame that of the vector by which it turns.
pub(in crate::model) fn make_derivative(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    value: Expr,
    inputs: &[usize],
    order: u8,
    span: SourceSpan,
) -> Expr {
    let ty = match value.ty {
        Type::Frame => type_by_inputs(
            names,
            values,
            &Type::Vector(3, Dimension::ANGLE),
            inputs,
            order,
        ),
        _ => type_by_inputs(names, values, &value.ty, inputs, order),
    };
    make_unless_error(
        sink,
        ExprKind::InputDerivative(Box::new(value), order),
        ty,
        span,
    )
}

pub(in crate::model) fn make_unless_error(
    sink: &mut Sink,
    kind: ExprKind,
    ty: Type,
    span: SourceSpan,
) -> Expr {
    if ty.is_error() {
        error_expr(sink, span)
    } else {
        make_expr(sink, kind, ty, span)
    }
}

/// One input: the derivative itself; several: an array for each order.
pub(in crate::model) fn type_by_inputs(
    names: &Names,
    values: &Values,
    ty: &Type,
    inputs: &[usize],
    order: u8,
) -> Type {
    if order == 0 {
        return ty.clone();
    }
    let by = |input: &usize| type_by_variable(names, values, ty, Variable::Input(*input));
    if let [input] = inputs {
        return type_by_inputs(names, values, &by(input), inputs, order - 1);
    }
    Type::Array(
        inputs
            .iter()
            .map(|input| type_by_inputs(names, values, &by(input), inputs, order - 1))
            .collect(),
    )
}

/// The type of a derivative: dimensions divide.
pub(in crate::model) fn type_by_variable(
    names: &Names,
    values: &Values,
    ty: &Type,
    variable: Variable,
) -> Type {
    let Some(by) = dimension_of_variable(names, values, variable) else {
        return Type::Error;
    };
    match ty {
        Type::Array(entries) => Type::Array(
            entries
                .iter()
                .map(|entry| type_by_variable(names, values, entry, variable))
                .collect(),
        ),
        other => {
            let quotient = other.dimension().and_then(|dimension| dimension.over(by));
            quotient.map_or(Type::Error, |dimension| other.with(dimension))
        }
    }
}

pub(in crate::model) fn dimension_of_variable(
    names: &Names,
    values: &Values,
    variable: Variable,
) -> Option<Dimension> {
    match variable {
        Variable::Parameter(scalar) => Some(values.scalar_parameters[scalar.0].dimension),
        Variable::Input(input) => {
            let symbol = names.symbol(Name::Input(input))?;
            symbol.ty.dimension()
        }
    }
}

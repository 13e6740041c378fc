//! Variables of derivatives: inputs, scalar parameters, components of vector parameters.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::list;
use crate::model::expression::refused_names::refuse_unknown_name;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::symbols::values::Values;
use crate::model::types::{COMPONENTS, Name, ScalarParameterId, Type, Variable};
use crate::syntax;

/// A variable of `d`; `None` after a report.
pub(in crate::model) fn resolve_variable(
    operands: Operands,
    sink: &mut Sink,
    expr: &syntax::Expr,
) -> Option<Variable> {
    let (text, field) = match &expr.kind {
        syntax::ExprKind::Error => return None,
        syntax::ExprKind::Number { .. } => {
            return refuse_variable(
                &operands.scope.names,
                &operands.scope.values,
                sink,
                "a constant",
                expr.span,
            );
        }
        syntax::ExprKind::Field(value, field) => {
            match (
                operands.scope.parts.dotted(expr),
                operands.scope.parts.dotted(value),
            ) {
                (Some(text), _) => (text, None),
                (None, Some(text)) => (text, Some(field)),
                (None, None) => {
                    return refuse_variable(
                        &operands.scope.names,
                        &operands.scope.values,
                        sink,
                        "an expression",
                        expr.span,
                    );
                }
            }
        }
        _ => match operands.scope.parts.dotted(expr) {
            Some(text) => (text, None),
            None => {
                return refuse_variable(
                    &operands.scope.names,
                    &operands.scope.values,
                    sink,
                    "an expression",
                    expr.span,
                );
            }
        },
    };
    let Some((name, ty, kind)) = operands
        .scope
        .names
        .find(&text)
        .map(|symbol| (symbol.name, symbol.ty.clone(), symbol.kind()))
    else {
        if text == "PI" {
            return refuse_variable(
                &operands.scope.names,
                &operands.scope.values,
                sink,
                "a constant",
                expr.span,
            );
        }
        match &expr.kind {
            syntax::ExprKind::Name(ident) if !operands.scope.parts.is_part(&text) => {
                refuse_unknown_name(
                    &operands.scope.names,
                    &operands.scope.members,
                    sink,
                    ident,
                    None,
                )
            }
            // It is reported as any other name that a part does not have.
            _ => drop(operands.within(Context::FUNCTION).resolve(sink, expr)),
        }
        return None;
    };
    if ty.is_error() {
        return None;
    }
    match (name, field) {
        (Name::Input(input), None) => Some(Variable::Input(input)),
        (Name::Parameter(parameter), _) => {
            let scalars =
                scalars_of_parameter(&operands.scope.values, sink, &text, parameter, &ty, field)?;
            match scalars[..] {
                [scalar] => Some(Variable::Parameter(scalar)),
                _ => {
                    let fact = format!("derivative with respect to `{text}`, a vector");
                    let help = format!("name a component, like `{text}.x`");
                    sink.error_with_help(expr.span, fact, help);
                    None
                }
            }
        }
        _ => refuse_variable(
            &operands.scope.names,
            &operands.scope.values,
            sink,
            &format!("`{text}`, {kind}"),
            expr.span,
        ),
    }
}

fn refuse_variable<T>(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    what: &str,
    span: SourceSpan,
) -> Option<T> {
    let inputs = names.names_of(|name| matches!(name, Name::Input(_)));
    let parameters: Vec<&str> = values
        .scalar_parameters
        .iter()
        .map(|scalar| scalar.name.as_str())
        .collect();
    let variables = [&inputs[..], &parameters[..]].concat();
    let help = if variables.is_empty() {
        "declare an `input` or a `param`".to_owned()
    } else {
        format!("variables are {}", list(&variables))
    };
    let fact = format!("derivative with respect to {what}");
    sink.error_with_help(span, fact, help);
    None
}

/// The scalar parameters of a parameter, or one of its components.
fn scalars_of_parameter(
    values: &Values,
    sink: &mut Sink,
    text: &str,
    parameter: usize,
    ty: &Type,
    field: Option<&Ident>,
) -> Option<Vec<ScalarParameterId>> {
    let scalars = values.scalar_parameters.iter().enumerate();
    let mine = scalars.filter(|(_, scalar)| scalar.parameter == parameter);
    let mine: Vec<_> = mine.map(|(index, _)| ScalarParameterId(index)).collect();
    let Some(field) = field else {
        return Some(mine);
    };
    let component = COMPONENTS.iter().position(|component| field == component);
    match component.and_then(|component| mine.get(component)) {
        Some(scalar) if mine.len() > 1 => Some(vec![*scalar]),
        _ => {
            let fact = format!("`{text}`, {ty}, has no component `{field}`");
            let help = match mine.len() {
                1 => format!("write `{text}`"),
                count => format!("components are `.{}`", COMPONENTS[..count].join("`, `.")),
            };
            sink.error_with_help(field.into(), fact, help);
            None
        }
    }
}

pub(in crate::model) fn all_scalar_parameters(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    span: SourceSpan,
) -> Option<Vec<ScalarParameterId>> {
    if names
        .symbols
        .iter()
        .any(|symbol| matches!(symbol.name, Name::Parameter(_)))
    {
        return Some(
            (0..values.scalar_parameters.len())
                .map(ScalarParameterId)
                .collect(),
        );
    }
    let fact = "`sensitivity` in a mechanism without parameters";
    sink.error_with_help(span, fact, "declare a `param`");
    None
}

/// Resolves `[crank, pivot_d.x]`. A vector means all its components.
pub(in crate::model) fn resolve_listed_parameters(
    operands: Operands,
    sink: &mut Sink,
    expr: &syntax::Expr,
) -> Option<Vec<ScalarParameterId>> {
    let syntax::ExprKind::List(entries) = &expr.kind else {
        let fact = "expected a list of parameters";
        let listed = match &expr.kind {
            syntax::ExprKind::Name(_) | syntax::ExprKind::Field(..) => format!("[{expr}]"),
            _ => "[crank, rocker]".to_owned(),
        };
        let help = format!("write them in brackets: `{listed}`");
        sink.error_with_help(expr.span, fact, help);
        return None;
    };
    if entries.is_empty() {
        let fact = "the list of parameters is empty";
        let help = "leave it out for all parameters";
        sink.error_with_help(expr.span, fact, help);
        return None;
    }
    let mut found = Vec::new();
    let mut sound = true;
    for entry in entries {
        match resolve_listed_parameter(operands, sink, entry) {
            Some(scalars) if scalars.iter().any(|scalar| found.contains(scalar)) => {
                let fact = "a parameter is listed twice";
                sink.error_with_help(entry.span, fact, "leave one of them out");
                sound = false;
            }
            Some(scalars) => found.extend(scalars),
            None => sound = false,
        }
    }
    sound.then_some(found)
}

fn resolve_listed_parameter(
    operands: Operands,
    sink: &mut Sink,
    entry: &syntax::Expr,
) -> Option<Vec<ScalarParameterId>> {
    let text = operands.scope.parts.dotted(entry);
    if let Some(text) = &text
        && let Some(symbol) = operands.scope.names.find(text)
        && let Name::Parameter(parameter) = symbol.name
    {
        let ty = symbol.ty.clone();
        return if ty.is_error() {
            None
        } else {
            scalars_of_parameter(&operands.scope.values, sink, text, parameter, &ty, None)
        };
    }
    if let Some(text) = &text
        && let Some(symbol) = operands.scope.names.find(text)
        && !matches!(symbol.name, Name::Input(_))
        && !symbol.ty.is_error()
    {
        let fact = format!(
            "a sensitivity is with respect to parameters, found {}",
            symbol.kind()
        );
        let parameters = operands
            .scope
            .names
            .names_of(|name| matches!(name, Name::Parameter(_)));
        let help = if parameters.is_empty() {
            "declare a `param`".to_owned()
        } else {
            format!("parameters are {}", list(&parameters))
        };
        sink.error_with_help(entry.span, fact, help);
        return None;
    }
    match resolve_variable(operands, sink, entry)? {
        Variable::Parameter(scalar) => Some(vec![scalar]),
        Variable::Input(_) => {
            let fact = "a sensitivity is with respect to parameters, found an input";
            let help = "write `d(q, x)` for the derivative with respect to an input";
            sink.error_with_help(entry.span, fact, help);
            None
        }
    }
}

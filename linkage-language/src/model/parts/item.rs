//! Items of parts: expressions for the inputs of a part, and its location.

use super::embed::Embedding;
use super::lets::add_let;
use super::location::place_part;
use super::rates::{speed_and_acceleration, unfollowed_help};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{list, nearest};
use crate::model::dispatch::resolve_expression;
use crate::model::expression::argument_use::refuse_argument;
use crate::model::expression::fitting::fit_to_type;
use crate::model::expression::nodes::error_expr;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::part_scopes::{PartBody, Parts};
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::symbols::values::Values;
use crate::model::types::{Expr, Let, Mechanism, Name, Parameter, Placed, Type};
use crate::syntax::{self, GivenPart, PartItem};

/// Resolves a part. Its derived quantities and loops come after those that they depend on.
pub(in crate::model) fn resolve_part(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &PartItem,
    position: usize,
    mechanism: &mut Mechanism,
) {
    let context = Context {
        site: Site::LetOrLoop,
        item: position,
    };
    let mut parts = scope.parts.scopes.iter();
    let part = parts.position(|part| part.item == position);
    let Some((part, body)) =
        part.and_then(|part| Some((part, scope.parts.scopes[part].body.clone()?)))
    else {
        let given = item.given.iter().map(|given| &given.value);
        let values: Vec<&syntax::Expr> = given.chain(&item.at).chain(&item.turned).collect();
        for value in values {
            resolve_expression(scope, sink, value, context);
        }
        return;
    };
    check_given(sink, item, &body);
    let first = mechanism.lets.len();
    for (index, input) in body.mechanism().inputs.iter().enumerate() {
        let what = format!("the input `{}` of the part `{}`", input.name, item.name);
        let value = match given(item, &input.name) {
            Some(value) => {
                let mut value = resolve_expression(scope, sink, &value.value, context);
                refuse_argument(&scope.names, &scope.values, sink, &mut value, &what);
                fit_to_type(
                    &scope.names,
                    &scope.units,
                    sink,
                    value,
                    &Type::Scalar(input.dimension),
                    &what,
                )
            }
            // The missing input has been reported.
            None => error_expr(sink, (&item.name).into()),
        };
        pass_rates_on(
            &mut scope.parts,
            &scope.values,
            part,
            index,
            &value,
            &mechanism.lets,
        );
        add_let(&mut scope.values, mechanism, item, &input.name, value);
    }
    for argument in &body.mechanism().arguments {
        if let Some(value) = given(item, &argument.name) {
            let what = format!(
                "the argument `{}` of the part `{}`",
                argument.name, item.name
            );
            let value = resolve_expression(scope, sink, &value.value, context);
            let value = fit_to_type(
                &scope.names,
                &scope.units,
                sink,
                value,
                &Type::Scalar(argument.dimension),
                &what,
            );
            add_let(&mut scope.values, mechanism, item, &argument.name, value);
        }
    }
    let of_parameters = Context {
        site: Site::PartParameter,
        ..context
    };
    for parameter in &body.mechanism().parameters {
        if let Some(value) = given(item, &parameter.name) {
            let what = format!(
                "the parameter `{}` of the part `{}`",
                parameter.name, item.name
            );
            let value = resolve_expression(scope, sink, &value.value, of_parameters);
            let value = fit_to_type(
                &scope.names,
                &scope.units,
                sink,
                value,
                &parameter.ty,
                &what,
            );
            add_let(&mut scope.values, mechanism, item, &parameter.name, value);
        }
    }
    refuse_open_arguments(&scope.names, &scope.parts, sink, item, part);
    place_part(scope, sink, item, &body, context, mechanism);
    debug_assert!(mechanism.lets.len() - first == body.own_lets() - body.first_let);
    let Some(embedding) = Embedding::new(
        &scope.parts.scopes[part],
        &mechanism.lets,
        &scope.parts.placed,
    ) else {
        return;
    };
    let lets: Vec<Let> = embedding.lets().collect();
    let inner: Vec<Placed> = embedding.placed(mechanism.loops.len()).collect();
    mechanism.leaves.extend(body.leaves(mechanism.loops.len()));
    mechanism.loops.extend(embedding.loops());
    mechanism.arcs.extend(embedding.arcs());
    mechanism.link_elements.append(embedding.link_elements());
    mechanism.parts.push(embedding.as_part());
    scope.parts.placed.extend(inner);
    for item in lets {
        scope.values.note_let(&item.value);
        mechanism.lets.push(item);
    }
}

/// Reports a value that is given twice, one for an unknown name, and a missing one.
fn check_given(sink: &mut Sink, item: &PartItem, body: &PartBody) {
    let mechanism = body.mechanism();
    let inputs: Vec<&str> = mechanism
        .inputs
        .iter()
        .map(|input| input.name.as_str())
        .collect();
    let parameters = mechanism
        .parameters
        .iter()
        .map(|parameter| parameter.name.as_str());
    let arguments = mechanism
        .arguments
        .iter()
        .map(|argument| argument.name.as_str());
    let others: Vec<&str> = parameters.chain(arguments).collect();
    for (index, value) in item.given.iter().enumerate() {
        let text = value.name.to_string();
        if item.given[..index]
            .iter()
            .any(|before| before.name == value.name)
        {
            let fact = format!("`{text}` is given twice to the part `{}`", item.name);
            let help = "leave one of them out";
            sink.error_with_help((&value.name).into(), fact, help);
        } else if !inputs.contains(&text.as_str()) && !others.contains(&text.as_str()) {
            let known = inputs.iter().chain(&others).copied();
            let help = match nearest(&text, known) {
                Some(name) => format!("did you mean `{name}`?"),
                None if inputs.is_empty() => format!("`{}` has no input", mechanism.name),
                None => format!("its inputs are {}", list(&inputs)),
            };
            let fact = format!(
                "`{text}` is no input, parameter or argument of `{}`",
                mechanism.name
            );
            sink.error_with_help((&value.name).into(), fact, help);
        }
    }
    let open = inputs.iter().filter(|input| given(item, input).is_none());
    let open: Vec<&str> = open.copied().collect();
    if let ([first, ..], true) = (&open[..], item.whole) {
        let fact = format!(
            "{} of `{}` {} left open in the part `{}`",
            list(&open),
            mechanism.name,
            if open.len() == 1 { "is" } else { "are" },
            item.name
        );
        let help = format!("write `{first} = ...` between the braces");
        let span = SourceSpan::from(&item.name).to((&item.mechanism).into());
        sink.error_with_help(span, fact, help);
    }
}

/// Passes speed and acceleration of an expression on to the input that it is given to, by the chain
/// rule.
fn pass_rates_on(
    parts: &mut Parts,
    values: &Values,
    part: usize,
    input: usize,
    value: &Expr,
    lets: &[Let],
) {
    let rates = speed_and_acceleration(values, value, lets);
    let Some(body) = &mut parts.scopes[part].body else {
        return;
    };
    let input = &body.model.mechanism.inputs[input];
    for (argument, rate) in [input.speed, input.acceleration].into_iter().zip(rates) {
        if let Some(argument) = argument {
            body.rates[argument] = Some(rate);
        }
    }
}

/// Reports arguments that something of a part is made of and that are not given.
fn refuse_open_arguments(
    names: &Names,
    parts: &Parts,
    sink: &mut Sink,
    item: &PartItem,
    part: usize,
) {
    let Some(body) = parts.scopes[part].body.as_ref().filter(|_| item.whole) else {
        return;
    };
    let mechanism = body.mechanism();
    let values = mechanism.lets.iter().map(|item| &item.value);
    let values = values.chain(mechanism.expressions_of_mechanics());
    let below = values.flat_map(Expr::parts).filter_map(Expr::as_name);
    let used: Vec<usize> = below
        .filter_map(|name| match name {
            Name::Argument(index) => Some(index),
            _ => None,
        })
        .collect();
    let mechanism_name = mechanism.name.clone();
    let arguments = mechanism.arguments.iter().enumerate();
    let open =
        arguments.filter(|(index, _)| body.arguments[*index].is_none() && used.contains(index));
    let open = open.filter_map(|(index, argument)| match &body.rates[index] {
        Some(Ok(_)) => None,
        Some(Err(why)) => Some((argument.name.clone(), Some(why.clone()))),
        None => Some((argument.name.clone(), None)),
    });
    let open: Vec<_> = open.collect();
    for (name, why) in open {
        let fact = format!(
            "the argument `{name}` of `{mechanism_name}` is left open in the part `{}`",
            item.name
        );
        let mut help =
            format!("write `{name} = ...` between the braces: an `argument` or a number");
        if let Some(why) = why {
            help += &unfollowed_help(names, why);
        }
        sink.error_with_help((&item.name).into(), fact, help);
    }
}

/// Reports a parameter of a part whose field has the name of another one.
pub(in crate::model) fn check_field(
    parts: &Parts,
    sink: &mut Sink,
    name: &str,
    part: usize,
    before: &[Parameter],
) {
    let field = |name: &str| name.replace('.', "_");
    let mut before = before.iter();
    if let Some(other) = before.find(|other| field(&other.name) == field(name)) {
        let fact = format!(
            "`{name}` and `{}` have one field, `{}`",
            other.name,
            field(name)
        );
        let span = parts.scopes[part].span;
        sink.error_with_help(span, fact, "choose another name for one of them");
    }
}

fn given<'i>(item: &'i PartItem, name: &str) -> Option<&'i GivenPart> {
    item.given.iter().find(|given| given.name == name)
}

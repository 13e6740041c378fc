//! Declaration of the names that parts bring.

use std::rc::Rc;

use super::name_counts::{Counts, next};
use crate::model::expression::part_messages::refuse_unknown_mechanism;
use crate::model::expression::refused_names::{check_new_name, check_reserved};
use crate::model::library::{Model, PartSource};
use crate::model::symbols::declared_names::{Names, Symbol};
use crate::model::symbols::part_scopes::{PartBody, PartScope, Parts};
use crate::model::symbols::sink::Sink;
use crate::model::types::{Name, Type};
use crate::syntax::PartItem;

/// Declares a part's name, and reserves derived quantities for the values that the part is given.
pub(in crate::model) fn declare_part(
    names: &Names,
    parts: &mut Parts,
    sink: &mut Sink,
    item: &PartItem,
    position: usize,
    found: &PartSource,
    counts: &mut Counts,
) {
    check_reserved(sink, &item.name);
    let new = check_new_name(names, parts, sink, &item.name);
    let name = item.name.to_string();
    let body = match found {
        // Its names would be those of another part.
        _ if !new => None,
        PartSource::Sound(model) => Some(make_part_body(sink, item, model, counts)),
        PartSource::Broken => None,
        PartSource::Unknown(names) => {
            refuse_unknown_mechanism(sink, &item.mechanism, names);
            None
        }
    };
    parts.scopes.push(PartScope {
        name,
        span: (&item.name).into(),
        item: position,
        body,
    });
}

fn make_part_body(
    sink: &mut Sink,
    item: &PartItem,
    model: &Rc<Model>,
    counts: &mut Counts,
) -> PartBody {
    let mechanism = &model.mechanism;
    let is_given = |name: &str| item.given.iter().any(|given| given.name == name);
    let first_let = counts.lets;
    counts.lets += mechanism.inputs.len();
    let mut next_let = |is_given: bool| {
        counts.lets += usize::from(is_given);
        is_given.then(|| Name::Let(counts.lets - 1))
    };
    let arguments = mechanism.arguments.iter();
    let arguments = arguments
        .map(|argument| next_let(is_given(&argument.name)))
        .collect();
    let parameters = mechanism.parameters.iter();
    let parameters = parameters
        .map(|parameter| next_let(is_given(&parameter.name)))
        .collect();
    let body = PartBody {
        first_origin: sink
            .origins
            .add_part(&item.name.to_string(), &model.origins),
        first_constant: 0,
        first_unknown: 0,
        first_let,
        parameters,
        rates: vec![None; mechanism.arguments.len()],
        arguments,
        is_placed: item.at.is_some(),
        is_turned: item.turned.is_some(),
        model: model.clone(),
    };
    let placing = usize::from(body.is_placed) + usize::from(body.is_turned);
    counts.lets += placing + mechanism.lets.len();
    body
}

/// Declares all names of parts. All other names have been counted before.
pub(in crate::model) fn declare_names_of_parts(
    names: &mut Names,
    parts: &mut Parts,
    counts: &mut Counts,
) {
    for part in 0..parts.scopes.len() {
        let Some(mut body) = parts.scopes[part].body.take() else {
            continue;
        };
        let mechanism = &body.model.mechanism;
        body.first_constant = counts.constants;
        counts.constants += mechanism.constants.len();
        body.first_unknown = counts.unknowns;
        counts.unknowns += mechanism.unknowns.len();
        for parameter in &mut body.parameters {
            parameter.get_or_insert_with(|| Name::Parameter(next(&mut counts.parameters)));
        }
        for (name, text, ty) in members(&body) {
            let PartScope {
                name: part,
                span,
                item,
                ..
            } = &parts.scopes[part];
            let symbol = Symbol {
                name,
                text: format!("{part}.{text}"),
                ty,
                item: *item,
                bare_zero: false,
                is_unknown_frame: false,
                span: *span,
            };
            if text.contains('.') {
                parts.quantities.insert(symbol.text.clone());
            }
            names.add_symbol(symbol);
        }
        parts.scopes[part].body = Some(body);
    }
}

/// Returns the names of a part: the name in the mechanism around it, its text in the part's own
/// mechanism, its type.
fn members(body: &PartBody) -> Vec<(Name, String, Type)> {
    let mechanism = body.mechanism();
    let mut names = Vec::new();
    let mut add = |name, text: &str, ty: &Type| names.push((name, text.to_owned(), ty.clone()));
    for (index, constant) in mechanism.constants.iter().enumerate() {
        add(
            Name::Const(body.first_constant + index),
            &constant.name,
            &constant.value.ty,
        );
    }
    for (parameter, name) in mechanism.parameters.iter().zip(&body.parameters) {
        if let Some(name) = name {
            add(*name, &parameter.name, &parameter.ty);
        }
    }
    for (index, input) in mechanism.inputs.iter().enumerate() {
        add(
            Name::Let(body.input(index)),
            &input.name,
            &Type::Scalar(input.dimension),
        );
    }
    for (argument, name) in mechanism.arguments.iter().zip(&body.arguments) {
        if let Some(name) = name {
            add(*name, &argument.name, &Type::Scalar(argument.dimension));
        }
    }
    for (index, unknown) in mechanism.unknowns.iter().enumerate() {
        add(
            Name::Unknown(body.first_unknown + index),
            &unknown.name,
            &unknown.ty,
        );
    }
    let first = body.own_lets();
    for (index, item) in mechanism.lets.iter().enumerate() {
        add(Name::Let(first + index), &item.name, &item.value.ty);
    }
    names
}

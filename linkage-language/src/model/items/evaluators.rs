//! The functions of the `impl` block: names that do not collide, inputs, quantities.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use crate::diagnostic::text::{list, nearest};
use crate::diagnostic::{OriginId, SourceSpan};
use crate::model::dispatch::{operands, resolve_expression};
use crate::model::expression::operators::settle_alone;
use crate::model::expression::refused_names::{
    check_new_type, check_reserved, check_type_parameter, report_duplicate, undeclared_rate,
};
use crate::model::generated::{ASSEMBLY, COLUMNS, FOLLOWER, Sweep};
use crate::model::quantity::picture_links::{check_one_picture, resolve_picture};
use crate::model::symbols::declared_names::{Names, kind};
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::types::{EvaluatorDef, MotionWord, Name, Quantity};
use crate::syntax::{
    Expr, ExprKind, FunctionDef, Item, MechanismDef, QuantityDef, Word, documentation,
};

/// Names in use: the span, and the owner of a name that the user did not write.
type Taken = BTreeMap<String, (SourceSpan, Option<String>)>;

pub(in crate::model) fn resolve_functions(
    scope: &Scope,
    sink: &mut Sink,
    definition: &MechanismDef,
) -> Vec<EvaluatorDef> {
    check_function_names(sink, definition);
    check_type_names(sink, definition);
    let functions = definition.functions.iter();
    let functions: Vec<_> = functions
        .map(|function| resolve_function(scope, sink, function))
        .collect();
    check_one_picture(sink, &functions);
    functions
}

/// Two functions of one name, or one with the name of a generated one.
fn check_function_names(sink: &mut Sink, definition: &MechanismDef) {
    let mut taken = Taken::new();
    for function in &definition.functions {
        check_reserved(sink, &function.name);
        take_name(sink, &mut taken, &function.name, "function");
    }
    for function in &definition.functions {
        for sweep in Sweep::all() {
            let generated = format!("{}{}", function.name, sweep.word());
            if let Some((span, _)) = taken.get(&generated).cloned() {
                let fact = format!(
                    "the function `{generated}` is also generated for `{}`",
                    function.name
                );
                sink.error_with_help(span, fact, "choose another name");
            }
        }
    }
}

fn check_type_names(sink: &mut Sink, definition: &MechanismDef) {
    let name = &definition.name;
    check_type_parameter(sink, name);
    let mut taken = Taken::new();
    let span = SourceSpan::from(name);
    taken.insert(name.to_string(), (span, Some("the mechanism".to_owned())));
    let assembly = Some(format!("the assembly of `{name}`"));
    taken.insert(format!("{name}{ASSEMBLY}"), (span, assembly));
    let inputs = definition.items.iter();
    let inputs = inputs.filter(|item| matches!(item, Item::Input(_)));
    if inputs.count() > 1 {
        let follower = Some(format!("the follower of `{name}`"));
        taken.insert(format!("{name}{FOLLOWER}"), (span, follower));
    }
    for function in &definition.functions {
        check_reserved(sink, &function.result);
        check_new_type(sink, &function.result);
        take_name(sink, &mut taken, &function.result, "result type");
    }
    for function in &definition.functions {
        let generated = format!("{}{COLUMNS}", function.result);
        if let Some((span, owner)) = taken.get(&generated).cloned() {
            let fact = format!(
                "the type `{generated}` is also generated for sweeps of `{}`",
                function.name
            );
            let span = if owner.is_some() {
                (&function.result).into()
            } else {
                span
            };
            sink.error_with_help(span, fact, "choose another name");
        }
    }
}

fn take_name(sink: &mut Sink, taken: &mut Taken, ident: &Ident, what: &str) {
    let text = ident.to_string();
    match taken.get(&text).cloned() {
        None => {
            taken.insert(text, (ident.into(), None));
        }
        Some((first, None)) => {
            let fact = format!("the {what} `{text}` is named twice");
            report_duplicate(sink, &fact, &text, ident.into(), first);
        }
        Some((_, Some(owner))) => {
            let fact = format!("the {what} `{text}` has the name of {owner}");
            sink.error_with_help(ident.into(), fact, "choose another name");
        }
    }
}

fn resolve_function(scope: &Scope, sink: &mut Sink, function: &FunctionDef) -> EvaluatorDef {
    let inputs: Vec<Option<usize>> = function
        .inputs
        .iter()
        .map(|ident| resolve_listed_input(scope, sink, ident))
        .collect();
    let repeated = check_repeated(sink, &function.inputs);
    let sound: Option<Vec<usize>> = inputs.iter().copied().collect();
    let sound = sound.filter(|_| !repeated);
    let site = Site::Function(sound.as_deref());
    let context = Context {
        site,
        item: usize::MAX,
    };
    let mut fields = BTreeMap::new();
    let quantities = function
        .quantities
        .iter()
        .map(|quantity| resolve_field(scope, sink, quantity, &mut fields, context))
        .collect();
    EvaluatorDef {
        name: function.name.to_string(),
        documentation: documentation(&function.attributes),
        result: function.result.to_string(),
        inputs: inputs.into_iter().flatten().collect(),
        input_origins: argument_origins(sink, function),
        quantities,
        origin: sink.add_origin((&function.name).into()),
    }
}

fn argument_origins(sink: &mut Sink, function: &FunctionDef) -> Vec<OriginId> {
    function
        .inputs
        .iter()
        .map(|ident| sink.add_origin(ident.into()))
        .collect()
}

fn resolve_listed_input(scope: &Scope, sink: &mut Sink, ident: &Ident) -> Option<usize> {
    let names = &scope.names;
    let text = ident.to_string();
    let inputs = names.names_of(|name| matches!(name, Name::Input(_) | Name::Argument(_)));
    let fact = match names.find(&text) {
        Some(symbol) => match symbol.name {
            Name::Input(input) => return Some(input),
            Name::Argument(argument) => return Some(scope.values.input_count + argument),
            other => format!("`{text}` is {}, not an input", kind(other)),
        },
        // The mistake in the links may be that it is not declared.
        None if inputs.is_empty() && scope.members.links.lost => return None,
        None => format!("unknown input `{text}`"),
    };
    let others = inputs.iter().copied().filter(|input| *input != text);
    let near = nearest(&text, others);
    let help = match near {
        Some(input) => format!("did you mean `{input}`?"),
        None if inputs.is_empty() => "the mechanism has no input: write `()`".to_owned(),
        None => {
            undeclared_rate(names, &text).unwrap_or_else(|| format!("inputs are {}", list(&inputs)))
        }
    };
    let message = sink.error_with_help(ident.into(), fact, help);
    if let Some(input) = near {
        message.suggest(format!("write `{input}`"), ident.into(), input);
    }
    None
}

fn check_repeated(sink: &mut Sink, inputs: &[Ident]) -> bool {
    let mut repeated = false;
    for (index, ident) in inputs.iter().enumerate() {
        if inputs[..index].contains(ident) {
            let fact = format!("the input `{ident}` is listed twice");
            sink.error_with_help(ident.into(), fact, "leave one of them out");
            repeated = true;
        }
    }
    repeated
}

fn resolve_field(
    scope: &Scope,
    sink: &mut Sink,
    quantity: &QuantityDef,
    fields: &mut BTreeMap<String, SourceSpan>,
    context: Context,
) -> Quantity {
    let field = quantity.field.to_string();
    check_reserved_field(&scope.names, sink, quantity);
    let span = SourceSpan::from(&quantity.field);
    match fields.get(&field) {
        Some(first) => {
            let fact = format!("the field `{field}` is listed twice");
            report_duplicate(sink, &fact, &field, span, *first);
        }
        None => {
            fields.insert(field.clone(), span);
        }
    }
    let mut value = match resolve_picture(operands(scope, context), sink, &quantity.value) {
        Some(picture) => picture,
        None => resolve_expression(scope, sink, &quantity.value, context),
    };
    settle_alone(&mut value);
    Quantity {
        field,
        documentation: documentation(&quantity.attributes),
        value,
        written: written(&quantity.value),
        subject: written(subject(&quantity.value)),
        origin: sink.add_origin(span),
    }
}

/// The shorthand `__a` is reported where `__a` is declared.
fn check_reserved_field(names: &Names, sink: &mut Sink, quantity: &QuantityDef) {
    if names.find(&quantity.field.to_string()).is_none() {
        check_reserved(sink, &quantity.field);
    }
}

/// Returns the expression below all derivatives.
fn subject(value: &Expr) -> &Expr {
    match &value.kind {
        ExprKind::Call(function, arguments) => {
            let word = MotionWord::from_word(&function.to_string());
            match (
                word.is_some_and(MotionWord::differentiates),
                arguments.first(),
            ) {
                (true, Some(inner)) => subject(inner),
                _ => value,
            }
        }
        _ => value,
    }
}

/// An expression as text, without parentheses around all of it.
fn written(value: &Expr) -> String {
    let text = value.to_string();
    match (&value.kind, text.strip_prefix('(')) {
        (ExprKind::Binary(..) | ExprKind::Negate(_), Some(rest)) => {
            rest.strip_suffix(')').unwrap_or(rest).to_owned()
        }
        _ => text,
    }
}

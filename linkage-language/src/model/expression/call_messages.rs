//! Messages about calls: the function, the number of its arguments, their order and types.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{count, nearest};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, Function, MotionLawWord, QuantityWord};
use crate::syntax::{self, Word};

pub(in crate::model) fn refuse_unknown_function(names: &Names, sink: &mut Sink, ident: &Ident) {
    let name = ident.to_string();
    let courses = || MotionLawWord::all().map(MotionLawWord::word);
    let functions = || Function::all().map(Function::word).chain(courses());
    let known = functions().chain(QuantityWord::all().map(QuantityWord::word));
    let fact = match names.find(&name) {
        Some(symbol) => format!("`{name}` is {}, not a function", symbol.kind()),
        None => format!("unknown function `{name}`"),
    };
    let notation = other_notation(&name);
    let near = other_word(&name).or_else(|| nearest(&name, known));
    let near = near.filter(|_| names.find(&name).is_none() && notation.is_none());
    let help = match (names.find(&name), notation, near) {
        (Some(_), ..) => format!("write `{name} * (...)` for a product"),
        (None, Some(help), _) => help.to_owned(),
        (None, None, Some(function)) => format!("did you mean `{function}`?"),
        (None, None, None) => {
            let functions: Vec<&str> = functions().collect();
            let quantities: Vec<&str> = QuantityWord::all().map(QuantityWord::word).collect();
            format!(
                "functions are {}; quantities are {}",
                functions.join(" "),
                quantities.join(" ")
            )
        }
    };
    let message = sink.error_with_help(ident.into(), fact, help);
    if let Some(function) = near {
        message.suggest(format!("write `{function}`"), ident.into(), function);
    }
}

/// Returns the function or quantity for which other programs have this word.
fn other_word(name: &str) -> Option<&'static str> {
    Some(match name {
        "speed" | "vel" | "rate" => "velocity",
        "acc" | "accel" => "acceleration",
        "arcsin" => "asin",
        "arccos" => "acos",
        "arctan" => "atan",
        "arctan2" => "atan2",
        _ => return None,
    })
}

/// Returns the notation for a function of other programs that has none of its own here.
fn other_notation(name: &str) -> Option<&'static str> {
    Some(match name {
        "pow" | "powi" | "powf" | "sq" => "write `a * a` for a square",
        "deriv" | "derivative" | "diff" => "write `d(quantity, input)`, or `velocity(quantity)`",
        "length" | "len" | "mag" | "magnitude" => {
            "write `norm(vector)`, or `distance(a, b)` for two points"
        }
        _ => return None,
    })
}

/// A function with the wrong number of arguments.
pub(in crate::model) fn refuse_count_of_arguments(
    sink: &mut Sink,
    function: Function,
    found: usize,
    span: SourceSpan,
) {
    let (name, parameters) = (function.word(), function.parameters());
    match (function, found) {
        (Function::Rotate, 3) => {
            let fact = wrong_count(name, parameters, found);
            let help = "write `turn(vector, axis, angle)` for a space vector";
            sink.error_with_help(span, fact, help);
        }
        (Function::Turn, 2) => {
            let fact = wrong_count(name, parameters, found);
            let help = "write `rotate(vector, angle)` for a plane vector, `turn(vector, axis, angle)` for a space vector";
            sink.error_with_help(span, fact, help);
        }
        _ => refuse_wrong_count(sink, name, parameters, found, span),
    }
}

pub(in crate::model) fn refuse_wrong_count(
    sink: &mut Sink,
    name: &str,
    parameters: &[&str],
    found: usize,
    span: SourceSpan,
) {
    let fact = wrong_count(name, parameters, found);
    let help = format!("write `{name}({})`", parameters.join(", "));
    sink.error_with_help(span, fact, help);
}

/// Reports `velocity(quantity, input)`. The inputs of a derivative are those of the function.
pub(in crate::model) fn refuse_listed_input(
    sink: &mut Sink,
    name: &str,
    order: u8,
    [quantity, input]: [&syntax::Expr; 2],
    span: SourceSpan,
) {
    let fact = wrong_count(name, &["quantity"], 2);
    let derivative = match order {
        1 => format!("`d({quantity}, {input})`"),
        2 => format!("`d({quantity}, {input}, {input})`"),
        _ => {
            let help = format!("write `{name}({quantity})`");
            sink.error_with_help(span, fact, help);
            return;
        }
    };
    let help = format!(
        "write `{name}({quantity})`; with several inputs, {derivative} is the derivative for one of them"
    );
    sink.error_with_help(span, fact, help);
}

/// Reports `polar(angle, length)`, `rotate(angle, vector)` and `turn(vector, angle, axis)`. `order`
/// is the right order.
pub(in crate::model) fn refuse_swapped(
    sink: &mut Sink,
    function: Function,
    arguments: &[Expr],
    order: Option<&str>,
    span: SourceSpan,
) -> Option<()> {
    let Some(order) = order else {
        return Some(());
    };
    let found: Vec<String> = arguments.iter().map(|a| a.ty.to_string()).collect();
    let (last, before) = found.split_last()?;
    let fact = format!(
        "the arguments of `{}` are swapped: found {} and {last}",
        function.word(),
        before.join(", ")
    );
    sink.error_with_help(span, fact, format!("write `{order}`"));
    None
}

pub(in crate::model) fn refuse_argument_type<T>(
    sink: &mut Sink,
    function: Function,
    wanted: &str,
    found: &Expr,
    help: &str,
) -> Option<T> {
    let fact = format!("`{}` takes {wanted}, found {}", function.word(), found.ty);
    let span = sink.span(found.origin);
    match help {
        "" => sink.error(span, fact),
        _ => sink.error_with_help(span, fact, help),
    };
    None
}

fn wrong_count(name: &str, parameters: &[&str], found: usize) -> String {
    let wanted = count(parameters.len(), "argument");
    format!("`{name}` takes {wanted}, found {found}")
}

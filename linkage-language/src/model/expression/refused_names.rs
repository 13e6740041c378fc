//! Names that cannot be: unknown, defined twice, reserved.

use std::fmt::Display;

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::nearest;
use crate::model::generated::TYPE_PARAMETER;
use crate::model::symbols::declared_names::{Names, Symbol};
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, refusal, rule};
use crate::model::types::{Name, is_function};
use crate::syntax::{is_meant_as_unit, units_within};

/// Reports an unknown name. `context` is its place; `None` if any name can be used there.
pub(in crate::model) fn refuse_unknown_name(
    names: &Names,
    members: &MemberNames,
    sink: &mut Sink,
    ident: &Ident,
    context: Option<Context>,
) {
    let text = ident.to_string();
    let rule = context.and_then(|context| rule(context.site));
    let may_stand =
        |symbol: &&Symbol| context.is_none_or(|context| refusal(symbol, context).is_none());
    let rate = undeclared_rate(names, &text);
    let known = names
        .symbols
        .iter()
        .filter(may_stand)
        .map(|symbol| symbol.text.as_str())
        // `phi` is no misspelt `PI`.
        .chain(text.eq_ignore_ascii_case("PI").then_some("PI"));
    let fact = format!("unknown name `{text}`");
    let help = match (nearest(&text, known.clone()), rate) {
        _ if members.has(&text) => format!(
            "`{text}` is the name of a body or joint: ask for forces like `reaction(joint)`"
        ),
        (Some(name), _) => format!("did you mean `{name}`?"),
        (None, Some(rate)) => rate,
        (None, None) if is_meant_as_unit(&text) => {
            format!("write the unit as a factor: `1 * {text}`")
        }
        (None, None) if is_function(&text) => {
            format!("`{text}` is a function: write `{text}(...)`")
        }
        (None, None) => {
            let help = rule.unwrap_or("declare it in the struct block, for example with `let`");
            match units_within(&text) {
                Some(units) => format!("{help}; units are written `{units}`"),
                None if is_constant_of_rust(&text) => {
                    format!("{help}; names of the Rust program are not known here")
                }
                None => help.to_owned(),
            }
        }
    };
    let meant = nearest(&text, known.clone()).filter(|_| !members.has(&text));
    let message = sink.error_with_help(ident.into(), fact, help);
    if let Some(name) = meant {
        message.suggest(format!("write `{name}`"), ident.into(), name);
    }
}

/// Returns the help for the usual name of a speed or an acceleration that no input declares.
pub(in crate::model) fn undeclared_rate(names: &Names, text: &str) -> Option<String> {
    let inputs = names.names_of(|name| matches!(name, Name::Input(_)));
    let input = inputs.first()?;
    let (rate, declared) = match text {
        "omega" | "speed" => ("the speed", text.to_owned()),
        "epsilon" | "alpha" | "acceleration" => ("the acceleration", format!("omega, {text}")),
        _ => return None,
    };
    Some(format!(
        "{rate} of an input is declared with it, `input {input} = ... at {declared}`, and listed by functions"
    ))
}

/// Returns true for names like `CRANK` and `ROD_LENGTH`, which constants of Rust have.
fn is_constant_of_rust(text: &str) -> bool {
    let letters = text.chars().filter(char::is_ascii_alphabetic).count();
    let is_capital = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    letters > 1 && text.chars().all(is_capital)
}

/// Reports a name that has another meaning already. Returns true if it has none.
pub(in crate::model) fn check_new_name<'n, N: Display>(
    names: &Names,
    parts: &Parts,
    sink: &mut Sink,
    ident: &'n N,
) -> bool
where
    SourceSpan: From<&'n N>,
{
    let text = ident.to_string();
    let symbol = names.find(&text).map(|symbol| symbol.span);
    let mut parts = parts.scopes.iter();
    let part = parts.find_map(|part| (part.name == text).then_some(part.span));
    if let Some(first) = symbol.or(part) {
        let fact = format!("the name `{text}` is defined twice");
        report_duplicate(sink, &fact, &text, ident.into(), first);
        return false;
    }
    true
}

/// Reports both places.
pub(in crate::model) fn report_duplicate(
    sink: &mut Sink,
    fact: &str,
    text: &str,
    span: SourceSpan,
    first: SourceSpan,
) {
    sink.error_with_help(span, fact, "choose another name");
    let related = sink.error(first, format!("`{text}` is first defined here"));
    related.is_related = true;
}

pub(in crate::model) fn check_reserved<'n, N: Display>(sink: &mut Sink, ident: &'n N)
where
    SourceSpan: From<&'n N>,
{
    let text = ident.to_string();
    if text.starts_with("__") {
        let fact = format!("the name `{text}` starts with `__`, which generated code uses");
        let help = match text.trim_start_matches('_') {
            "" => "choose another name".to_owned(),
            plain => format!("write `{plain}`"),
        };
        sink.error_with_help(ident.into(), fact, help);
    }
}

/// The mechanism cannot be called as the type parameter that all its types have.
pub(in crate::model) fn check_type_parameter(sink: &mut Sink, ident: &Ident) {
    if ident == TYPE_PARAMETER {
        let fact = format!(
            "a mechanism cannot be called `{TYPE_PARAMETER}`: that is the scalar type of all types that the macro makes, as in \
             `Motion<{TYPE_PARAMETER}>`"
        );
        let help = "choose a longer name";
        sink.error_with_help(ident.into(), fact, help);
    }
}

/// Refuses a result type with the name of a well-known type: that is a misunderstanding, and would
/// hide the type.
pub(in crate::model) fn check_new_type(sink: &mut Sink, ident: &Ident) {
    const KNOWN: [&str; 15] = [
        "f64",
        "f32",
        "bool",
        "usize",
        "i32",
        "u32",
        "Vector2",
        "Vector3",
        "Frame",
        "Self",
        "Option",
        "Result",
        "Vec",
        "String",
        TYPE_PARAMETER,
    ];
    let text = ident.to_string();
    if KNOWN.contains(&text.as_str()) {
        let fact = format!(
            "`{text}` cannot be the result type: the macro makes a new struct of that name, with one field for \
             each quantity"
        );
        let help = "choose a name of your own, such as `Path` or `Motion`";
        sink.error_with_help(ident.into(), fact, help);
    }
}

//! A text that is compiled with functions of its editor instead of those of its user.

use std::ops::Range;

use linkage_compiler::{Checked, check_all};
use linkage_engine::{Mechanism, Source};
use proc_macro2::extra::invalidate_current_thread_spans;

use crate::analysis::offset_of_text;
use crate::facts::Facts;
use crate::outline::Outline;

/// A text that can be compiled.
#[derive(Debug)]
pub(crate) struct Snapshot {
    pub(crate) text: String,
    pub(crate) outlines: Vec<Outline>,
    /// The types of each mechanism.
    pub(crate) facts: Vec<Facts>,
}

/// Functions of a mechanism.
#[derive(Debug)]
pub(crate) struct Request {
    pub(crate) mechanism: String,
    /// The arguments of each function.
    pub(crate) inputs: Vec<String>,
    /// The expressions that each function returns.
    pub(crate) functions: Vec<Vec<String>>,
}

/// The result of compiling a mechanism with functions.
pub(crate) enum Outcome {
    Compiled(Box<Mechanism>),
    /// The indices of expressions with a mistake, counted through all functions.
    Refused(Vec<usize>),
}

/// Compiles the mechanisms of a text with other functions. Returns the outcome of each request.
pub(crate) fn compiled_with(snapshot: &Snapshot, requests: &[Request]) -> Vec<Outcome> {
    let (text, places) = text_with(snapshot, requests);
    let checked = checked(&text);
    let outcomes = requests.iter().zip(&places);
    let outcomes = outcomes.map(|(request, places)| {
        let mut checked = checked.iter();
        let found = checked.find(|checked| checked.name.as_ref() == Some(&request.mechanism));
        found.map_or(Outcome::Refused(Vec::new()), |found| {
            outcome(found, places, offset_of_text(&text))
        })
    });
    let outcomes = outcomes.collect();
    invalidate_current_thread_spans();
    outcomes
}

fn checked(text: &str) -> Vec<Checked> {
    let source = Source::new("values.mech", text);
    let calls = source.iter().flat_map(Source::calls);
    let checked = calls.flat_map(|call| check_all(call.tokens.clone()));
    checked.map(Checked::in_any_range).collect()
}

fn outcome(checked: &Checked, places: &[Range<usize>], offset: usize) -> Outcome {
    if let Some(mechanism) = Mechanism::new(checked) {
        return Outcome::Compiled(Box::new(mechanism));
    }
    let faults = checked.messages.iter();
    let faults = faults.map(|message| message.span.first.byte_range().start + offset);
    let refused = faults.filter_map(|start| {
        let mut places = places.iter();
        places.position(|location| location.contains(&start))
    });
    Outcome::Refused(refused.collect())
}

/// Returns the text with other functions than those of its user, and the bytes of the expressions of
/// each request.
fn text_with(
    Snapshot { text, outlines, .. }: &Snapshot,
    requests: &[Request],
) -> (String, Vec<Vec<Range<usize>>>) {
    let mut name = "values".to_owned();
    let mut result = "Values".to_owned();
    while text.contains(&name) || text.contains(&result) {
        name.push('_');
        result.push('V');
    }
    let mut written = without_functions(text, outlines);
    let mut places = Vec::new();
    for request in requests {
        let arguments = request.inputs.join(", ");
        let mut places_here = Vec::new();
        written += &format!("\nimpl {} {{ ", request.mechanism);
        for (number, expressions) in request.functions.iter().enumerate() {
            written += &format!("fn {name}{number}({arguments}) -> {result}{number} {{ ");
            for (index, expression) in expressions.iter().enumerate() {
                let start = written.len();
                written += &format!("q{index}: {expression}, ");
                places_here.push(start..written.len());
            }
            written += "} ";
        }
        written += "}";
        places.push(places_here);
    }
    (written, places)
}

/// Returns the text with blanks instead of the functions, whose programs are not needed.
fn without_functions(text: &str, outlines: &[Outline]) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for block in outlines.iter().flat_map(|outline| &outline.implementations) {
        bytes[block.clone()].fill(b' ');
    }
    // Blocks begin and end at brackets, so no character is cut.
    String::from_utf8(bytes).unwrap_or_default()
}

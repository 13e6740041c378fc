//! Texts with mechanisms, and the messages about them.

use std::sync::Arc;

use linkage_compiler::{Checked, Message, check_all};
use linkage_engine::{MechanismCall, Source, SourceError, rendered};
use pyo3::prelude::*;

use crate::mechanism::Mechanism;
use crate::raised::raised;

/// A message: its text, whether it is a mistake, line and column of its first character and of the
/// one after its last, counted from 1; without a position 0.
pub(crate) type Located = (String, bool, [usize; 4]);

/// The rounding of multiply-adds: as the machine does it, once, or twice.
pub(crate) type Fused = Option<bool>;

/// The text of a mechanism, with the name of its file.
pub(crate) struct File {
    name: String,
    text: String,
}

impl File {
    /// Reads the text as the compiler does. Tokens belong to one thread, so nobody keeps them.
    pub(crate) fn source(&self) -> Result<Source, SourceError> {
        Source::new(&self.name, &self.text)
    }
}

/// Compiles all mechanisms of a text.
///
/// The name is that of its file. `any_range` accepts ranges in which a mechanism comes apart.
/// `fused` is the rounding of multiply-adds: once, twice, or `None` for that of this machine.
#[pyfunction]
pub(crate) fn compile(
    py: Python<'_>,
    name: &str,
    text: &str,
    any_range: bool,
    fused: Fused,
) -> PyResult<Vec<Mechanism>> {
    match py.detach(|| compiled(name, text, any_range, fused)) {
        Ok(all) => Ok(all),
        Err((text, messages)) => Err(raised(py, "CompileError", (text, messages))),
    }
}

fn compiled(
    name: &str,
    text: &str,
    any_range: bool,
    fused: Fused,
) -> Result<Vec<Mechanism>, (String, Vec<Located>)> {
    let source = Source::new(name, text).map_err(|error| no_source(&error))?;
    let file = Arc::new(File {
        name: name.to_owned(),
        text: text.to_owned(),
    });
    let mut all = Vec::new();
    let mut texts = String::new();
    let mut mistakes = Vec::new();
    for call in source.calls() {
        for checked in check_all(call.tokens.clone()) {
            let checked = match any_range {
                true => Checked::in_any_range(checked),
                false => checked,
            };
            let messages = located(&source, call, &checked);
            match linkage_engine::Mechanism::new(&checked) {
                Some(mechanism) => {
                    let mechanism = rounded(mechanism, fused);
                    let rendered = rendered(&source, call, &checked, false);
                    let file = Arc::clone(&file);
                    all.push(Mechanism::new(mechanism, file, messages, rendered, fused));
                }
                None => {
                    texts += &rendered(&source, call, &checked, false);
                    mistakes.extend(messages);
                }
            }
        }
    }
    match mistakes.is_empty() {
        true => Ok(all),
        false => Err((texts.trim_end().to_owned(), mistakes)),
    }
}

/// The mechanism with multiply-adds that are rounded in this way.
pub(crate) fn rounded(
    mechanism: linkage_engine::Mechanism,
    fused: Fused,
) -> linkage_engine::Mechanism {
    match fused {
        None => mechanism,
        Some(true) => mechanism.with_fused_multiply_adds(),
        Some(false) => mechanism.with_separate_multiply_adds(),
    }
}

/// The error of a text that is no sequence of tokens.
fn no_source(error: &SourceError) -> (String, Vec<Located>) {
    let text = error.to_string();
    let first = text.lines().next().unwrap_or_default();
    let first = first.strip_prefix("error: ").unwrap_or(first).to_owned();
    // The line of the picture under the message: ` --> name:line:column`.
    let position = text.lines().find_map(|line| {
        let (_, position) = line.split_once("--> ")?;
        let mut numbers = position.rsplit(':').map_while(|part| part.parse().ok());
        let (column, line) = (numbers.next()?, numbers.next()?);
        Some([line, column, line, column + 1])
    });
    (text, vec![(first, true, position.unwrap_or_default())])
}

/// The messages about a mechanism: its mistakes, or the warnings if there are none.
fn located(source: &Source, call: &MechanismCall, checked: &Checked) -> Vec<Located> {
    let is_mistake = !checked.messages.is_empty();
    let messages = match is_mistake {
        true => &checked.messages,
        false => &checked.warnings,
    };
    let one = |message: &Message| {
        let position = position(source.text(), call, message);
        (message.text.clone(), is_mistake, position)
    };
    messages.iter().map(one).collect()
}

/// Lines and columns of a message.
fn position(text: &str, call: &MechanismCall, message: &Message) -> [usize; 4] {
    let [first, last] = [message.span.first, message.span.last].map(|span| span.byte_range());
    let (start, end) = match (first.start, last.end) {
        // Only text that was made up by the compiler begins and ends with the text.
        (0, 0) => (call.range.start, call.range.end),
        range => range,
    };
    let ([a, b], [c, d]) = (line_and_column(text, start), line_and_column(text, end));
    [a, b, c, d]
}

/// Line and column, in characters, of a byte of a text.
fn line_and_column(text: &str, byte: usize) -> [usize; 2] {
    let before = text.get(..byte).unwrap_or(text);
    let begin = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.matches('\n').count() + 1;
    [line, before[begin..].chars().count() + 1]
}

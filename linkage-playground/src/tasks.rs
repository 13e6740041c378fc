//! Requests and their answers.

use linkage_editor::formatted;
use proc_macro2::extra::invalidate_current_thread_spans;
use serde_json::{Value, json};

use crate::{analysis, benchmark, bits, document, examples, exports};

/// Answers a request: an object of JSON whose field `do` has the name of the work.
///
/// | `do` | further fields | answer |
/// |---|---|---|
/// | `analyse` | `text` | lines: messages with their places, then data and programs of each page |
/// | `messages` | `text` | messages that need no solution, and those of the last one |
/// | `hover` | `text`, `at` | the description of a word as Markdown, with its place |
/// | `complete` | `text`, `at` | words that can be written |
/// | `signature` | `text`, `at` | the call around a place with its arguments, or `null` |
/// | `hints` | `text` | values next to names, and names that are words elsewhere |
/// | `words` | | the words of the language by their colours |
/// | `format` | `text` | the text with other blanks, or `null` if it cannot be read |
/// | `actions` | `text`, `from`, `to` | changes for some words, each with its title |
/// | `export` | `text`, `format`, `mechanism` | files with their names |
/// | `examples` | | texts to choose from |
/// | `values` | `text`, `steps` | all functions over the first input, as bits |
/// | `sweep` | `text`, `function`, `positions`, `repeats` | a sum of all results |
///
/// A request that cannot be answered has the field `failure` in its answer.
#[must_use]
pub fn answer(request: &str) -> String {
    let answered = serde_json::from_str::<Value>(request)
        .map_err(|error| error.to_string())
        .and_then(|request| answered(&request));
    // Otherwise all texts stay in memory.
    invalidate_current_thread_spans();
    answered.unwrap_or_else(|failure| json!({ "failure": failure }).to_string())
}

fn answered(request: &Value) -> Result<String, String> {
    let text = |name: &str| request[name].as_str().unwrap_or_default();
    let count = |name: &str| request[name].as_u64().unwrap_or_default() as usize;
    match text("do") {
        "analyse" => Ok(analysis::analysis(text("text"))),
        "messages" => Ok(json!({ "messages": document::first_messages(text("text")) }).to_string()),
        "hover" => Ok(document::hover(text("text"), count("at"))),
        "signature" => Ok(document::signature(text("text"), count("at"))),
        "hints" => Ok(document::hints(text("text"))),
        "words" => Ok(document::words()),
        "format" => Ok(json!({ "text": formatted(text("text")) }).to_string()),
        "actions" => Ok(document::actions(text("text"), count("from"), count("to"))),
        "complete" => Ok(document::completions(text("text"), count("at"))),
        "export" => exports::export(text("text"), text("format"), text("mechanism")),
        "examples" => Ok(examples::examples()),
        "values" => bits::values(text("text"), count("steps")),
        "sweep" => benchmark::sweep(
            text("text"),
            text("function"),
            count("positions"),
            count("repeats"),
        ),
        other => Err(format!("there is no work `{other}`")),
    }
}

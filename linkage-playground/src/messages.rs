//! Messages of the compiler with their places, as the editor shows them.

use linkage_compiler::{Checked, Message};
use linkage_engine::MechanismCall;
use serde_json::{Value, json};

use crate::positions::Positions;

/// The messages about a mechanism: its mistakes, or warnings if there is none.
pub(crate) fn messages(
    checked: &Checked,
    call: &MechanismCall,
    positions: &Positions<'_>,
) -> Vec<Value> {
    let (severity, messages) = match checked.messages.is_empty() {
        true => ("warning", &checked.warnings),
        false => ("error", &checked.messages),
    };
    let one = |message: &Message| {
        let [first, last] = [message.span.first, message.span.last].map(|span| span.byte_range());
        // Only text that was made up by the compiler begins and ends with the text.
        let range = match (first.start, last.end) {
            (0, 0) => call.range.clone(),
            (start, end) => start..end,
        };
        json!({
            "from": positions.utf16(range.start),
            "to": positions.utf16(range.end),
            "severity": severity,
            "text": message.text,
        })
    };
    messages.iter().map(one).collect()
}

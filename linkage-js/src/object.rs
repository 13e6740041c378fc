//! Objects, lists and texts of JavaScript.

use std::fmt::Write;

use crate::instruction::literal;

/// An object, field by field.
#[derive(Debug)]
pub(crate) struct Object {
    fields: Vec<String>,
}

impl Object {
    pub(crate) fn new() -> Self {
        Self { fields: Vec::new() }
    }

    pub(crate) fn with(mut self, name: &str, value: String) -> Self {
        self.fields.push(format!("{name}: {value}"));
        self
    }

    pub(crate) fn text(self) -> String {
        format!("{{ {} }}", self.fields.join(", "))
    }
}

pub(crate) fn list(entries: impl Iterator<Item = String>) -> String {
    let entries: Vec<String> = entries.collect();
    format!("[{}]", entries.join(", "))
}

pub(crate) fn numbers(values: &[f64]) -> String {
    list(values.iter().map(|x| literal(*x)))
}

/// A text of JavaScript that ends neither itself nor an element of a page.
pub(crate) fn text(content: &str) -> String {
    let mut text = String::from("\"");
    for c in content.chars() {
        match c {
            '"' | '\\' => {
                text.push('\\');
                text.push(c);
            }
            '<' | '\u{2028}' | '\u{2029}' => {
                let _ = write!(text, "\\u{:04x}", u32::from(c));
            }
            c if c.is_control() => {
                let _ = write!(text, "\\u{:04x}", u32::from(c));
            }
            c => text.push(c),
        }
    }
    text.push('"');
    text
}

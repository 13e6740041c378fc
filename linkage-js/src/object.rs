//! Objects, lists and texts of JavaScript.

use std::fmt::Write;

use linkage_symbolic::program::Program;

use crate::instruction::{function, literal};
use crate::program_data::{json_number, json_program};

/// The notation of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Notation {
    /// JavaScript, with programs as functions.
    Script,
    /// JSON, with programs as data for the interpreter.
    Json,
}

impl Notation {
    /// A number, which is read back to the last bit.
    pub(crate) fn literal(self, x: f64) -> String {
        match self {
            Self::Script => literal(x),
            Self::Json => json_number(x),
        }
    }

    /// A list of numbers.
    pub(crate) fn numbers(self, values: &[f64]) -> String {
        list(values.iter().map(|x| self.literal(*x)))
    }

    /// A program as a function of an assembly, inputs, states and results.
    pub(crate) fn function(self, program: &Program, inputs: usize) -> String {
        match self {
            Self::Script => function(program, inputs),
            Self::Json => json_program(program, inputs),
        }
    }

    /// A program as a function of an assembly and results.
    pub(crate) fn preparation(self, program: &Program, inputs: usize) -> String {
        let function = self.function(program, inputs);
        match self {
            Self::Script => format!("(own, out) => ({function})(own, null, null, out)"),
            Self::Json => function,
        }
    }
}

/// An object, field by field.
#[derive(Debug)]
pub(crate) struct Object {
    notation: Notation,
    fields: Vec<String>,
}

impl Object {
    pub(crate) fn new(notation: Notation) -> Self {
        Self {
            notation,
            fields: Vec::new(),
        }
    }

    pub(crate) fn with(mut self, name: &str, value: String) -> Self {
        self.fields.push(match self.notation {
            Notation::Script => format!("{name}: {value}"),
            Notation::Json => format!("\"{name}\": {value}"),
        });
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

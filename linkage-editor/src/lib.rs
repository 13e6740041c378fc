//! Everything that an editor asks about a text of linkage: messages, hover, completion, navigation,
//! formatting. No protocol and no files: a language server and a page in a browser have the same
//! answers.
//!
#![doc = include_str!("../README.md")]
//!
//! | to | call |
//! |---|---|
//! | read a text, and each change of it | [`Document::new`], [`Document::set_text`], [`Document::edit`] |
//! | leave solving to another thread | [`Document::read`], [`Document::finish`], [`Document::take_values`] |
//! | show messages | [`Document::diagnostics`] |
//! | describe the word under the pointer | [`Document::hover`] |
//! | show values next to names | [`Document::hints`] |
//! | complete the word before the caret | [`Document::completions`], [`Document::signature`] |
//! | go to a declaration, list uses | [`Document::definition`], [`Document::references`] |
//! | rename | [`Document::renamed`] |
//! | list the names of a text | [`Document::symbols`] |
//! | offer changes | [`Document::actions`] |
//! | format | [`formatted`] |
//! | colour words | [`Document::words`], [`language_words`] |
//! | convert bytes to lines and columns | [`Lines`] |
//!
//! Places are bytes of the text.

mod actions;
mod alike;
mod analysis;
mod answers;
mod colours;
mod completion;
mod completion_list;
mod completion_words;
mod computed;
mod context;
mod cursor;
mod declaration;
mod declared_names;
mod diagnostics;
mod document;
mod facts;
mod formatter;
mod function_facts;
mod hints;
mod hover;
mod insertion;
mod lexer;
mod loop_terms;
mod moved;
mod name_values;
mod navigation;
mod outline;
mod position;
mod probe;
mod rename;
mod repair;
mod shown;
mod signature;
mod statements;
mod suggested;
mod symbols;
mod two_stages;
mod uses;

pub use actions::Action;
pub use colours::{Colour, ColouredWord, language_words};
pub use completion_list::{Completion, CompletionKind};
pub use computed::{Evaluated, Evaluation};
pub use declaration::NameKind;
pub use diagnostics::{Diagnostic, Edit, Fix, Related, Severity};
pub use document::Document;
pub use formatter::formatted;
pub use hints::Hint;
pub use hover::Hover;
pub use position::{Encoding, Lines, Position};
pub use signature::Signature;
pub use symbols::Symbol;
pub use two_stages::{Solved, Solving};

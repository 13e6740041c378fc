//! The grammars of editors against the texts and the words of the language.

mod corpus;
mod queries;
mod snippets;
mod texts;
mod words;

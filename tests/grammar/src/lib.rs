//! The parser of editors and the texts that it has to read.

mod captures;
mod parsed;
mod texts;
mod words;

pub use captures::Captures;
pub use parsed::{faults, language, tree};
pub use texts::{Text, mechanism_files, read, root, rust_macros, samples};
pub use words::{kinds_of_words, quoted};

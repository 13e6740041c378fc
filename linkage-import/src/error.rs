//! Reasons why a file cannot be imported.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

/// A message about a file: the fact, and advice after `help:` on its next line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImportError {
    message: String,
}

impl ImportError {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
        }
    }

    /// Puts the number of the line in front of the message.
    pub(crate) fn in_line(self, line: usize) -> Self {
        Self::new(format!("line {line}: {}", self.message))
    }
}

impl Display for ImportError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for ImportError {}

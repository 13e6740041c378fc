//! Why a command ends without a result.

use std::fmt::{self, Display, Formatter};
use std::io::{self, ErrorKind};
use std::path::Path;

use linkage_compiler::{nearest, short_words, shortened};
use linkage_engine::SourceError;
use linkage_runtime::AssemblyError;

use crate::confusable::{letters, look_alike};

/// The last message of a command with exit status 1.
#[derive(Clone, Debug)]
pub enum Failure {
    /// A message.
    Told(String),
    /// The same with the source under it.
    Rendered(String),
    /// Everything has been printed already.
    Silent,
}

impl Failure {
    /// A file that cannot be shown, made or written; `doing` says which.
    pub(crate) fn file(doing: &str, path: &Path, error: &io::Error) -> Self {
        let is_missing = |folder: &&Path| !folder.as_os_str().is_empty() && !folder.exists();
        let folder = path.parent().filter(is_missing);
        let why = match (error.kind(), folder) {
            (ErrorKind::NotFound, Some(folder)) if doing == "write" => format!(
                "there is no folder `{}`\nhelp: make the folder first, or give another name",
                folder.display()
            ),
            _ => error.to_string(),
        };
        Self::Told(format!("cannot {doing} `{}`: {why}", path.display()))
    }
}

impl From<SourceError> for Failure {
    fn from(error: SourceError) -> Self {
        match error {
            SourceError::Message(text) => Self::Told(text),
            SourceError::Rendered(text) => Self::Rendered(text),
        }
    }
}

impl From<AssemblyError> for Failure {
    fn from(error: AssemblyError) -> Self {
        Self::Told(short_words(&error.to_string()))
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Told(text) => writeln!(f, "error: {text}"),
            Self::Rendered(text) => writeln!(f, "{text}"),
            Self::Silent => Ok(()),
        }
    }
}

/// A shorter name is near to too many others.
const LONG_NAME: usize = 4;

/// Returns the names that there are instead of an unknown one, and the one that looks like it or is
/// spelt nearly as it.
pub(crate) fn known_names<'a>(name: &str, words: impl IntoIterator<Item = &'a str>) -> String {
    let words: Vec<&str> = words.into_iter().collect();
    let alike = words.iter().find(|word| look_alike(name, word));
    let help = match alike {
        Some(word) => format!(
            "\nhelp: `{}` looks like `{}`, and is another name: {}",
            shortened(name),
            shortened(word),
            letters(name, word)
        ),
        None => match nearest(name, words.iter().copied()).filter(|_| name.len() >= LONG_NAME) {
            Some(word) => format!("\nhelp: did you mean `{}`?", shortened(word)),
            None => String::new(),
        },
    };
    listed(words) + &help
}

/// `a`, `b` and `c`, in back-ticks.
pub(crate) fn listed<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words = words.into_iter();
    let quoted: Vec<String> = words.map(|word| format!("`{}`", shortened(word))).collect();
    match &quoted[..] {
        [] => "none".to_owned(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

//! Names of a declaration that have another form in the target language.

use std::fmt::{self, Display, Formatter};

/// A name of the declaration that has another form in the target language, because the language,
/// its library or the exported files have the name themselves, or because the language does not
/// have its letters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Renamed {
    /// Kind and name in the declaration: ``the parameter `int` ``.
    pub what: String,
    /// The name in the target language.
    pub name: String,
    /// The target language: `C`.
    pub language: &'static str,
}

impl Display for Renamed {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Self {
            what,
            name,
            language,
        } = self;
        write!(f, "{what} is called `{name}` in {language}")
    }
}

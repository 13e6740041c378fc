//! Names of a declaration that have another form in C.

use std::fmt::{self, Display, Formatter};

use crate::comment::comment;

/// A name of the declaration that has another form in C, because C, C++, their libraries or the
/// exported files have the name themselves, or because C does not know its letters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Renamed {
    /// Kind and name in the declaration: ``the parameter `int` ``.
    pub what: String,
    /// The name in C.
    pub name: String,
}

impl Display for Renamed {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{} is called `{}` in C", self.what, self.name)
    }
}

/// The names of a mechanism that have another form.
#[derive(Debug, Default)]
pub(crate) struct Log(pub(crate) Vec<Renamed>);

impl Log {
    /// Notes a name, unless it is the expected one.
    pub(crate) fn note(&mut self, what: impl FnOnce() -> String, expected: &str, name: &str) {
        if name != expected {
            self.0.push(Renamed {
                what: what(),
                name: name.to_owned(),
            });
        }
    }
}

/// A comment with all of them; nothing if there is none.
pub(crate) fn listed(all: &[Renamed]) -> String {
    if all.is_empty() {
        return String::new();
    }
    let lines = all.iter().map(|item| item.to_string().replace('`', ""));
    let lines: Vec<String> = lines.collect();
    comment(
        "",
        &format!(
            "Names of the declaration that C, C++, their libraries or this file have themselves, or whose letters C does not know:\n{}.",
            lines.join(",\n")
        ),
    ) + "\n"
}

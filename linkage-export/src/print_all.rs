//! Mechanisms that one program may use, whose names must differ.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::{self, Display, Formatter};

use linkage_compiler::ir::CompiledMechanism;

/// The reason for which a mechanism is not printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    message: String,
}

impl Refused {
    /// A refusal with its text.
    pub fn new(message: String) -> Self {
        Self { message }
    }
}

impl Display for Refused {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for Refused {}

/// Prints mechanisms: each by its name in the declaration, with its unit. `printer` returns the
/// files of one, and the names that they give to other files.
///
/// # Errors
///
/// Those of `printer`, and for two mechanisms that would have a name of the language in common.
pub fn print_all<P>(
    language: &str,
    mechanisms: &[(&str, &CompiledMechanism)],
    printer: impl Fn(&str, &CompiledMechanism) -> Result<(P, Vec<String>), Refused>,
) -> Result<Vec<P>, Refused> {
    let printed = mechanisms.iter().map(|(title, unit)| printer(title, unit));
    let printed = printed.collect::<Result<Vec<_>, _>>()?;
    let mut owners: BTreeMap<String, &str> = BTreeMap::new();
    let mut files = Vec::new();
    for ((title, _), (printed, names)) in mechanisms.iter().zip(printed) {
        let mut taken = names
            .iter()
            .filter_map(|name| Some((name, owners.get(name)?)));
        if let Some((name, other)) = taken.next() {
            return Err(Refused::new(format!(
                "`{other}` and `{title}` would both have the name `{name}` in {language}. Call one of them otherwise, or write them one by one, \
                 into two folders, for programs that use one of them"
            )));
        }
        owners.extend(names.into_iter().map(|name| (name, *title)));
        files.push(printed);
    }
    Ok(files)
}

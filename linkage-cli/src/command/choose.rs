//! The mechanism and the function that a command is about.

use std::path::{Path, PathBuf};

use clap::Args;
use linkage_compiler::{Checked, check_all, shortened};
use linkage_engine::{Mechanism, Source, rendered};

use super::terminal::is_coloured;
use crate::failure::{Failure, known_names, listed};
use crate::look_alike::look_alikes;
use crate::normal::normal;

/// A file and, where it holds several, one of its mechanisms.
#[derive(Debug, Args)]
pub(super) struct Chosen {
    /// File with what stands between the braces of `mechanism! { ... }`, or a Rust file
    file: PathBuf,
    /// The mechanism, if there are several in the file
    #[arg(long, value_name = "NAME", value_parser = normal)]
    mechanism: Option<String>,
}

impl Chosen {
    /// The file.
    pub(super) fn file(&self) -> &Path {
        &self.file
    }

    /// All mechanisms that are meant; mistakes in any of the file are reported.
    pub(super) fn all(&self) -> Result<Vec<Mechanism>, Failure> {
        self.all_of(&Source::read(&self.file)?)
    }

    /// The same, whose declared ranges may be refused: a refusal is printed as a warning.
    pub(super) fn all_in_any_range(&self) -> Result<Vec<Mechanism>, Failure> {
        let source = Source::read(&self.file)?;
        self.chosen_of(accepted(&source, Checked::in_any_range)?)
    }

    /// The mechanisms of a text of the file that are meant.
    pub(super) fn all_of(&self, source: &Source) -> Result<Vec<Mechanism>, Failure> {
        self.chosen_of(checked(source)?)
    }

    fn chosen_of(&self, mut all: Vec<Mechanism>) -> Result<Vec<Mechanism>, Failure> {
        let Some(name) = &self.mechanism else {
            return Ok(all);
        };
        let names: Vec<&'static str> = all.iter().map(|mechanism| mechanism.name()).collect();
        all.retain(|mechanism| mechanism.name() == name);
        match all.is_empty() {
            true => Err(Failure::Told(format!(
                "there is no mechanism `{}` in `{}`; there is {}",
                shortened(name),
                self.file.display(),
                known_names(name, names)
            ))),
            false => Ok(all),
        }
    }

    /// The mechanism with a function of this name, and the function's number.
    pub(super) fn with_function(&self, name: &str) -> Result<(Mechanism, usize), Failure> {
        let number = |mechanism: &Mechanism| {
            mechanism
                .headings()
                .iter()
                .position(|heading| heading.function == name)
        };
        let all = self.all()?;
        let functions: Vec<&str> = all
            .iter()
            .flat_map(|mechanism| mechanism.headings().iter().map(|heading| heading.function))
            .collect();
        let (mut with, _): (Vec<_>, Vec<_>) = all
            .into_iter()
            .partition(|mechanism| number(mechanism).is_some());
        match &with[..] {
            [] => Err(Failure::Told(format!(
                "there is no function `{}` in `{}`; there is {}",
                shortened(name),
                self.file.display(),
                known_names(name, functions)
            ))),
            [only] => {
                let number = number(only).unwrap_or_default();
                Ok((with.swap_remove(0), number))
            }
            several => Err(self.ambiguous(
                &format!("the function `{}` is in", shortened(name)),
                several,
            )),
        }
    }

    fn ambiguous(&self, what: &str, several: &[Mechanism]) -> Failure {
        Failure::Told(format!(
            "{what} {} in `{}`: choose one by `--mechanism NAME`",
            listed(several.iter().map(|mechanism| mechanism.name())),
            self.file.display()
        ))
    }
}

/// All mistakes of a text without colours, as a page shows them; empty if there are none.
pub(super) fn mistakes(source: &Source) -> String {
    let calls = source.calls().iter();
    let all = calls.flat_map(|call| {
        let checked = check_all(call.tokens.clone()).into_iter();
        let faulty = checked.filter(|checked| !checked.messages.is_empty());
        faulty.map(|checked| rendered(source, call, &checked, false))
    });
    all.collect()
}

/// All mechanisms of a text; messages about them are printed.
pub(super) fn checked(source: &Source) -> Result<Vec<Mechanism>, Failure> {
    accepted(source, |checked| checked)
}

/// The same with other results of the checks.
fn accepted(
    source: &Source,
    result: impl Fn(Checked) -> Checked,
) -> Result<Vec<Mechanism>, Failure> {
    let mut all = Vec::new();
    let mut sound = true;
    for found in source.calls() {
        eprint!("{}", look_alikes(source, found, is_coloured()));
        for checked in check_all(found.tokens.clone()).into_iter().map(&result) {
            eprint!("{}", rendered(source, found, &checked, is_coloured()));
            match Mechanism::new(&checked) {
                Some(mechanism) => all.push(mechanism),
                None => sound = false,
            }
        }
    }
    match sound {
        true => Ok(all),
        false => Err(Failure::Silent),
    }
}

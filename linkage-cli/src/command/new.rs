//! `linkage new`: a mechanism to start from.

use std::fs::OpenOptions;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use linkage_compiler::shortened;

use super::output::print;
use crate::failure::Failure;
use crate::normal::normal;
use crate::templates::{TEMPLATES, Template};

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// The file, which must not be there yet; a name without an ending gets `.mech`
    #[arg(required_unless_present = "list")]
    file: Option<PathBuf>,
    /// The mechanism to start from
    #[arg(long, value_name = "TEMPLATE", default_value = TEMPLATES[0].name, value_parser = normal)]
    from: String,
    /// Lists all mechanisms to start from
    #[arg(long, conflicts_with_all = ["file", "from"])]
    list: bool,
}

/// Writes a mechanism, but never over a file.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let Some(file) = &options.file else {
        return print(&listed_templates());
    };
    let Template { about, text, .. } = template(&options.from)?;
    let file = with_ending(file)?;
    put_new(&file, text)?;
    let file = file.display();
    print(&format!(
        "{about} is in `{file}`: change it, then `linkage check {file}`\n"
    ))
}

/// The ending of files with mechanisms.
const ENDING: &str = "mech";

/// Returns the name of the file, with an ending if it has none.
fn with_ending(file: &Path) -> Result<PathBuf, Failure> {
    match file.extension() {
        None => Ok(file.with_extension(ENDING)),
        // Commands look for calls of the macro in it.
        Some(ending) if ending == "rs" => Err(Failure::Told(format!(
            "cannot write `{}`: a mechanism without Rust code does not belong in a Rust file\n\
             help: write `linkage new {}`",
            file.display(),
            file.with_extension(ENDING).display()
        ))),
        Some(_) => Ok(file.to_owned()),
    }
}

/// Writes a text to a file that is not there yet.
pub(super) fn put_new(file: &Path, text: &str) -> Result<(), Failure> {
    let made = OpenOptions::new().write(true).create_new(true).open(file);
    let written = made.and_then(|mut made| made.write_all(text.as_bytes()));
    written.map_err(|error| refused(file, &error))
}

/// Returns the reason why a file was not written, and the way out.
fn refused(file: &Path, error: &io::Error) -> Failure {
    let why = match error.kind() {
        ErrorKind::AlreadyExists if file.is_dir() => {
            "it is a folder\nhelp: give the name of a file in it"
        }
        ErrorKind::AlreadyExists => {
            "it exists, and no file is replaced\nhelp: give another name, or remove the file"
        }
        _ => return Failure::file("write", file, error),
    };
    Failure::Told(format!("cannot write `{}`: {why}", file.display()))
}

/// Returns the template of a name.
fn template(name: &str) -> Result<&'static Template, Failure> {
    let found = TEMPLATES.iter().find(|template| template.name == name);
    found.ok_or_else(|| {
        Failure::Told(format!(
            "there is no template `{}`; there is\n{}",
            shortened(name),
            listed_templates().trim_end()
        ))
    })
}

/// A line for each template.
fn listed_templates() -> String {
    let names = TEMPLATES.iter().map(|template| template.name.len());
    let width = names.max().unwrap_or(0);
    let line = |Template { name, about, .. }: &Template| format!("{name:width$}  {about}\n");
    TEMPLATES.iter().map(line).collect()
}

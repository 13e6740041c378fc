//! `linkage new`: a mechanism to start from.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use linkage_compiler::shortened;

use super::output::print;
use crate::failure::Failure;
use crate::normal::normal;
use crate::templates::{TEMPLATES, Template};

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// The file, which must not be there yet
    #[arg(required_unless_present = "list")]
    file: Option<PathBuf>,
    /// The mechanism to start from
    #[arg(long, value_name = "TEMPLATE", default_value = TEMPLATES[0].name, value_parser = normal)]
    from: String,
    /// Lists all mechanisms to start from
    #[arg(long)]
    list: bool,
}

/// Writes a mechanism, but never over a file.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let file = match (&options.file, options.list) {
        (Some(file), false) => file,
        _ => return print(&listed_templates()),
    };
    let Template { about, text, .. } = template(&options.from)?;
    let made = OpenOptions::new().write(true).create_new(true).open(file);
    let written = made.and_then(|mut made| made.write_all(text.as_bytes()));
    written.map_err(|error| Failure::file("write", file, &error))?;
    let file = file.display();
    print(&format!(
        "{about} is in `{file}`: change it, then `linkage check {file}`\n"
    ))
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

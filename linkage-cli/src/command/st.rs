//! `linkage st`: mechanisms as structured text for programmable controllers.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use linkage_st::{StructuredText, all_structured_text};

use super::c::set_defaults;
use super::choose::Chosen;
use super::output::{print, put};
use super::replaced::refuse_mechanism;
use super::values::Dimensions;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    #[command(flatten)]
    dimensions: Dimensions,
    /// The folder; by default the current one
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

/// Writes a file for each mechanism; none of them if one cannot be printed. Names that structured
/// text does not allow are reported.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let mut mechanisms = options.chosen.all()?;
    set_defaults(&mut mechanisms, &options.dimensions)?;
    let named = mechanisms
        .iter()
        .map(|mechanism| (mechanism.name(), mechanism.compiled()));
    let all = all_structured_text(&named.collect::<Vec<_>>())
        .map_err(|refused| Failure::Told(refused.to_string()))?;
    let folder = &options.output;
    refuse_mechanism(folder, options.chosen.file())?;
    fs::create_dir_all(folder).map_err(|error| Failure::file("make", folder, &error))?;
    for StructuredText {
        name,
        text,
        renamed,
    } in &all
    {
        let path = folder.join(format!("{name}.st"));
        put(Some(&path), options.chosen.file(), |out| {
            out.write_all(text.as_bytes())
        })?;
        print(&format!("{}\n", path.display()))?;
        for note in renamed {
            eprintln!("note: {name}.st: {note}");
        }
    }
    Ok(())
}

//! `linkage st`: mechanisms as structured text for programmable controllers.

use clap::Args;
use linkage_st::{StructuredText, all_structured_text};

use super::c::set_defaults;
use super::choose::Chosen;
use super::target_folder::TargetFolder;
use super::values::Dimensions;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    #[command(flatten)]
    dimensions: Dimensions,
    #[command(flatten)]
    folder: TargetFolder,
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
    let (folder, input) = (&options.folder, options.chosen.file());
    folder.make(input)?;
    for StructuredText {
        name,
        text,
        renamed,
    } in &all
    {
        folder.write(input, &format!("{name}.st"), text)?;
        for note in renamed {
            eprintln!("note: {name}.st: {note}");
        }
    }
    Ok(())
}

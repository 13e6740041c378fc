//! `linkage js`: mechanisms as JavaScript for pages.

use clap::Args;
use linkage_js::{Module, modules};

use super::choose::Chosen;
use super::target_folder::TargetFolder;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    #[command(flatten)]
    folder: TargetFolder,
}

/// Writes a module and its types for each mechanism; none of them if two would have one name. Names
/// that JavaScript has otherwise are reported.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let mechanisms = options.chosen.all()?;
    let named: Vec<_> = mechanisms
        .iter()
        .map(|mechanism| (mechanism.name(), mechanism.compiled()))
        .collect();
    let modules = modules(&named).map_err(|clash| Failure::Told(clash.to_string()))?;
    let (folder, input) = (&options.folder, options.chosen.file());
    folder.make(input)?;
    for ((title, _), module) in named.iter().zip(modules) {
        let Module {
            name,
            script,
            types,
        } = module;
        for (ending, text) in [("js", &script), ("d.ts", &types)] {
            folder.write(input, &format!("{name}.{ending}"), text)?;
        }
        if name != *title {
            eprintln!("note: {name}.js: the mechanism `{title}` is called `{name}` in JavaScript");
        }
    }
    Ok(())
}

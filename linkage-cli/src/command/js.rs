//! `linkage js`: mechanisms as JavaScript for pages.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use linkage_js::{Module, modules};

use super::choose::Chosen;
use super::output::{print, put};
use super::replaced::refuse_mechanism;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// The folder; by default the one at hand
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

/// Writes a module and its types for each mechanism; none of them if two would have one name. Names
/// that JavaScript has otherwise are reported.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let folder = &options.output;
    refuse_mechanism(folder, options.chosen.file())?;
    let mechanisms = options.chosen.all()?;
    let named: Vec<_> = mechanisms
        .iter()
        .map(|mechanism| (mechanism.name(), mechanism.compiled()))
        .collect();
    let modules = modules(&named).map_err(|clash| Failure::Told(clash.to_string()))?;
    fs::create_dir_all(folder).map_err(|error| Failure::file("make", folder, &error))?;
    for ((title, _), module) in named.iter().zip(modules) {
        let Module {
            name,
            script,
            types,
        } = module;
        for (ending, text) in [("js", &script), ("d.ts", &types)] {
            let path = folder.join(format!("{name}.{ending}"));
            put(Some(&path), options.chosen.file(), |out| {
                out.write_all(text.as_bytes())
            })?;
            print(&format!("{}\n", path.display()))?;
        }
        if name != *title {
            eprintln!("note: {name}.js: the mechanism `{title}` is called `{name}` in JavaScript");
        }
    }
    Ok(())
}

//! Robots and suspensions: texts that compile, the motion of their points against a solver, choices
//! that are asked for, mutated files.

mod choices;
mod closures;
mod huge;
mod masses;
mod motion;
mod mutations;
mod solver;

#[path = "../shared/memory.rs"]
mod memory;
#[path = "../shared/survival.rs"]
mod survival;

use std::fs;
use std::path::Path;

use linkage_import::{Import, Options, import};

/// The content of a test file.
fn file(name: &str) -> Vec<u8> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/robots/files");
    fs::read(Path::new(folder).join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn imported(name: &str, options: &Options) -> Import {
    import(&file(name), name, options).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The message of a file that is refused.
fn refused(content: &str, name: &str, options: &Options) -> String {
    match import(content.as_bytes(), name, options) {
        Ok(imported) => panic!("{}", imported.text),
        Err(error) => error.to_string(),
    }
}

/// Options for a table of points.
fn hard_points(axes: &str, side: &str) -> Options {
    Options {
        format: Some(linkage_import::Format::HardPoints),
        axes: Some(axes.to_owned()),
        length: Some("mm".to_owned()),
        side: Some(side.to_owned()),
        ..Options::default()
    }
}

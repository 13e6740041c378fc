//! `linkage import`: a file of another program as a mechanism.

mod compared;

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::Args;
use linkage_import::{Format, Import, import};

use self::compared::compared;
use super::new::put_new;
use super::output::print;
use crate::failure::{Failure, listed};

/// The largest file that is read, in bytes: a mechanism of thousands of joints is smaller.
const MOST_BYTES: u64 = 16 << 20;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// The file of another program, `-` for the standard input, or an address in quotes
    #[arg(required_unless_present = "list")]
    file: Option<String>,
    /// The file for the mechanism, which must not be there yet; without it the mechanism is printed
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The format, if the name does not decide it: `linkage2`, `pmks`, `pyslvs`, `pylinkage`, `csv`,
    /// `mjcf`, `urdf`, `sdf`, `hard-points`
    #[arg(long, value_name = "FORMAT")]
    format: Option<String>,
    /// The name of the mechanism, otherwise from the name of the file
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Lists all formats
    #[arg(long)]
    list: bool,
    /// An input instead of those of the file: a pivot and another joint of the link that turns,
    /// or a joint that has a slot; of a robot the name of a joint
    #[arg(long, value_name = "PIVOT,JOINT")]
    input: Vec<String>,
    /// For URDF: a table of the joints that close loops, as CSV
    #[arg(long, value_name = "FILE")]
    closures: Option<String>,
    /// For points of a suspension: the directions of x, y and z, as `forward,left,up`
    #[arg(long, value_name = "X,Y,Z")]
    axes: Option<String>,
    /// For points of a suspension: their unit, `mm`, `cm`, `m` or `inch`
    #[arg(long, value_name = "UNIT")]
    length: Option<String>,
    /// For points of a suspension: their side, `left` or `right`
    #[arg(long, value_name = "SIDE")]
    side: Option<String>,
    /// For points of a suspension: the role of a point with another name, as `lower_ball=P3`
    #[arg(long, value_name = "ROLE=NAME")]
    role: Vec<String>,
}

/// Writes the mechanism, but never over a file, compares it with its file, and prints each warning.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let file = match (&options.file, options.list) {
        (Some(file), false) => file,
        _ => return print(&listed_formats()),
    };
    let format = options.format.as_deref().map(format_named).transpose()?;
    let choices = linkage_import::Options {
        format,
        mechanism: options.name.clone(),
        inputs: options.input.clone(),
        closures: options.closures.as_deref().map(text_of).transpose()?,
        axes: options.axes.clone(),
        length: options.length.clone(),
        side: options.side.clone(),
        roles: options.role.clone(),
    };
    let imported = import(&content(file)?, file, &choices);
    let imported = imported.map_err(|error| Failure::Told(error.to_string()))?;
    let Import { text, warnings, .. } = &imported;
    match &options.output {
        None => print(text)?,
        Some(file) => put_new(file, text)?,
    }
    let comparison = compared(&imported);
    for warning in warnings.iter().chain(&comparison.warnings) {
        eprintln!("warning: {warning}");
    }
    if let Some(note) = comparison.note {
        eprintln!("note: {note}");
    }
    Ok(())
}

/// A line for each format.
fn listed_formats() -> String {
    let names = Format::ALL.iter().map(|format| format.name().len());
    let width = names.max().unwrap_or(0);
    let line = |format: &Format| format!("{:width$}  {}\n", format.name(), format.about());
    Format::ALL.iter().map(line).collect()
}

fn format_named(name: &str) -> Result<Format, Failure> {
    Format::named(name).ok_or_else(|| {
        let names = Format::ALL.iter().map(|format| format.name());
        Failure::Told(format!(
            "there is no format `{name}`; there are {}",
            listed(names)
        ))
    })
}

/// Reads a table.
fn text_of(file: &str) -> Result<String, Failure> {
    let text = String::from_utf8(content(file)?);
    text.map_err(|_| Failure::Told(format!("`{file}` is no text in UTF-8")))
}

/// Reads a file or the standard input. An address has no content.
fn content(file: &str) -> Result<Vec<u8>, Failure> {
    if file.contains("://") {
        return Ok(Vec::new());
    }
    let mut content = Vec::new();
    let path = Path::new(file);
    let read = if file == "-" {
        std::io::stdin()
            .lock()
            .take(MOST_BYTES)
            .read_to_end(&mut content)
    } else {
        fs::File::open(path).and_then(|opened| opened.take(MOST_BYTES).read_to_end(&mut content))
    };
    read.map_err(|error| Failure::file("read", path, &error))?;
    if content.len() as u64 == MOST_BYTES {
        return Err(Failure::Told(format!(
            "`{file}` has more than {MOST_BYTES} bytes"
        )));
    }
    Ok(content)
}

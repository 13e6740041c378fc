//! `linkage c`: mechanisms as C99 for controllers.

use clap::{Args, ValueEnum};
use linkage_c::{Real, Refused, Sources, all_sources, column_sweeps};
use linkage_engine::Mechanism;

use super::choose::Chosen;
use super::range;
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
    /// What is computed with; with `float` nothing is computed in double
    #[arg(long, value_enum, default_value_t = Scalar::Double)]
    scalar: Scalar,
    /// Two more files for each mechanism: sweeps into an array for each number of a result
    #[arg(long)]
    columns: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Scalar {
    Double,
    /// Doubles of processors with fused multiply-adds: sines from a table
    Fused,
    Float,
}

impl Scalar {
    fn real(self) -> Real {
        match self {
            Self::Double => Real::Double,
            Self::Fused => Real::Fused,
            Self::Float => Real::Single,
        }
    }
}

/// Writes a header and a source for each mechanism; none of them if one cannot be printed. Names
/// that C has otherwise are reported.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let mut mechanisms = options.chosen.all()?;
    set_defaults(&mut mechanisms, &options.dimensions)?;
    let named: Vec<_> = mechanisms
        .iter()
        .map(|mechanism| (mechanism.name(), mechanism.compiled()))
        .collect();
    let refused = |refused: Refused| Failure::Told(refused.to_string());
    let real = options.scalar.real();
    let all = all_sources(&named, real).map_err(refused)?;
    let mut columns = Vec::new();
    for (name, unit) in named.iter().filter(|_| options.columns) {
        columns.push(column_sweeps(name, unit, real).map_err(refused)?);
    }
    let (folder, input) = (&options.folder, options.chosen.file());
    folder.make(input)?;
    let write = |file: String, text: &str| folder.write(input, &file, text);
    for Sources {
        name,
        header,
        source,
        renamed,
    } in &all
    {
        write(format!("{name}.h"), header)?;
        write(format!("{name}.c"), source)?;
        for note in renamed {
            eprintln!("note: {name}.h: {note}");
        }
    }
    for sweeps in &columns {
        let name = &sweeps.sources.name;
        write(format!("{name}_columns.h"), &sweeps.header)?;
        write(format!("{name}_columns.c"), &sweeps.columns)?;
    }
    Ok(())
}

/// Makes other dimensions the defaults of the mechanisms that have them.
pub(super) fn set_defaults(
    mechanisms: &mut [Mechanism],
    given: &Dimensions,
) -> Result<(), Failure> {
    given.known_to_any(mechanisms)?;
    for mechanism in mechanisms {
        let known = given.known_to(mechanism);
        if known.are_given() {
            set(mechanism, &known)?;
        }
    }
    Ok(())
}

/// Makes other dimensions the defaults of a mechanism.
fn set(mechanism: &mut Mechanism, given: &Dimensions) -> Result<(), Failure> {
    if !mechanism.compiled().coupled.is_empty() {
        return Err(Failure::Told(format!(
            "{}: `--set` cannot change the tables of its coupled groups: write the dimensions into the file, or set them when the program \
             runs",
            mechanism.name()
        )));
    }
    let dimensions = range::assembled(given, mechanism)?.dimensions().to_vec();
    mechanism.set_dimensions(&dimensions);
    Ok(())
}

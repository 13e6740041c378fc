//! `linkage table`: a function over a range of its input, for spreadsheets and programs.

mod streamed;

use clap::{Args, value_parser};
use linkage_report::Mistake;

use super::arguments_given::inputs_given;
use super::choose::Chosen;
use super::csv_options::CsvOptions;
use super::gap_reason::reason_of_gap;
use super::output::put;
use super::range;
use super::running_input::RunningInput;
use super::values::Dimensions;
use crate::failure::Failure;
use crate::normal::normal;
use streamed::Streamed;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// The function
    #[arg(value_parser = normal)]
    function: String,
    #[command(flatten)]
    course: RunningInput,
    /// How many positions, both ends included
    #[arg(long, default_value_t = 361, value_name = "COUNT", value_parser = value_parser!(u32).range(1..))]
    steps: u32,
    #[command(flatten)]
    dimensions: Dimensions,
    /// JSON instead of CSV, with all digits
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    csv: CsvOptions,
}

/// Writes the table.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let style = options.csv.style();
    let (mechanism, function) = options.chosen.with_function(&options.function)?;
    let assembly = range::assembled(&options.dimensions, &mechanism)?;
    let along = options
        .course
        .resolve(&mechanism, function, options.steps)?;
    let mut table = Streamed::new(&mechanism, &assembly, function, &along, options.csv.degrees);
    let input = options.chosen.file();
    put(options.csv.output.as_deref(), input, |out| {
        match options.json {
            true => table.in_json(out, &options.function, assembly.dimensions()),
            false => table.in_lines(out, &style),
        }
    })?;
    if let Some(first) = &table.first_missing {
        let inputs = inputs_given(&mechanism, function, first);
        eprintln!(
            "note: at {} of {} positions a number is missing, first {}",
            table.missing,
            along.positions.count,
            reason_of_gap(&mechanism, &assembly, &inputs)
        );
    }
    for message in table.singular_positions() {
        eprintln!("note: {message}");
    }
    Ok(())
}

impl Options {
    /// Returns the mistake of a style whose cells are ambiguous.
    pub(super) fn mistake(&self) -> Option<Mistake> {
        self.csv.style().mistake().filter(|_| !self.json)
    }
}

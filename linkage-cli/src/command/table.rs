//! `linkage table`: a function over a range of its input, for spreadsheets and programs.

mod streamed;

use std::path::PathBuf;

use clap::{Args, value_parser};
use linkage_report::{CsvStyle, Mistake};

use super::arguments_given::inputs_given;
use super::choose::Chosen;
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
    /// Angles in degrees; their rates stay in radians
    #[arg(long)]
    degrees: bool,
    /// Significant digits; by default as many as it takes to read the numbers back exactly
    #[arg(long, value_name = "COUNT", value_parser = value_parser!(u8).range(1..=17))]
    digits: Option<u8>,
    /// What stands between columns
    #[arg(long, default_value = ",", value_name = "TEXT")]
    separator: String,
    /// The decimal mark
    #[arg(long, default_value_t = '.', value_name = "CHARACTER")]
    decimal: char,
    /// JSON instead of CSV, with all digits
    #[arg(long)]
    json: bool,
    /// A file instead of the standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Writes the table.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let style = options.style();
    let (mechanism, function) = options.chosen.with_function(&options.function)?;
    let assembly = range::assembled(&options.dimensions, &mechanism)?;
    let along = options
        .course
        .resolve(&mechanism, function, options.steps)?;
    let mut table = Streamed::new(&mechanism, &assembly, function, &along, options.degrees);
    let input = options.chosen.file();
    put(options.output.as_deref(), input, |out| match options.json {
        true => table.in_json(out, &options.function, assembly.dimensions()),
        false => table.in_lines(out, &style),
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
        self.style().mistake().filter(|_| !self.json)
    }

    fn style(&self) -> CsvStyle {
        let style = CsvStyle::default()
            .separator(&self.separator.replace("\\t", "\t"))
            .decimal(self.decimal);
        match self.digits {
            Some(digits) => style.digits(digits.into()),
            None => style,
        }
    }
}

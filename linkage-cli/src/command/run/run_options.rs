//! Options of `linkage run`.

use clap::{Args, value_parser};
use linkage_report::Mistake;

use super::super::choose::Chosen;
use super::super::csv_options::CsvOptions;
use super::super::values::Dimensions;
use crate::normal::normal;

/// Options of the command.
#[derive(Debug, Args)]
pub(in crate::command) struct Options {
    #[command(flatten)]
    pub(super) chosen: Chosen,
    /// A function that has `driven_acceleration` of each input and takes their speeds; by default
    /// the first one
    #[arg(value_parser = normal)]
    pub(super) function: Option<String>,
    /// The time for which it moves, as `2s` or `500ms`
    #[arg(long = "for", value_name = "TIME", value_parser = normal)]
    pub(super) time: String,
    /// An input or a speed at the start, or a load, as `phi=45deg`, `omega=2`, `motor=3N*m`; by
    /// default inputs have their reference and speeds are zero
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    pub(super) at: Vec<String>,
    /// An earlier end: an input, a speed or a result passes a value, as `phi=360deg` or `omega=0`
    #[arg(long, value_name = "NAME=VALUE", value_parser = normal)]
    pub(super) stop: Vec<String>,
    /// How many rows at even distances in time, both ends included; by default 201, on a page 1001
    #[arg(long, value_name = "COUNT", value_parser = value_parser!(u32).range(2..))]
    pub(super) steps: Option<u32>,
    /// The error of a step of integration, relative and absolute
    #[arg(long, default_value_t = 1e-10, value_name = "NUMBER")]
    pub(super) tolerance: f64,
    /// An implicit method, for stiff springs
    #[arg(long)]
    pub(super) stiff: bool,
    #[command(flatten)]
    pub(super) dimensions: Dimensions,
    #[command(flatten)]
    pub(super) csv: CsvOptions,
}

impl Options {
    /// Returns the mistake of a style whose cells are ambiguous.
    pub(in crate::command) fn mistake(&self) -> Option<Mistake> {
        self.csv.style().mistake()
    }
}

//! Options of tables that are written as CSV.

use std::path::PathBuf;

use clap::{Args, value_parser};
use linkage_report::CsvStyle;

/// The form of numbers and lines, and the file.
#[derive(Debug, Args)]
pub(super) struct CsvOptions {
    /// Angles in degrees; their rates stay in radians
    #[arg(long)]
    pub(super) degrees: bool,
    /// Significant digits; by default as many as it takes to read the numbers back exactly
    #[arg(long, value_name = "COUNT", value_parser = value_parser!(u8).range(1..=17))]
    digits: Option<u8>,
    /// What stands between columns
    #[arg(long, default_value = ",", value_name = "TEXT")]
    separator: String,
    /// The decimal mark
    #[arg(long, default_value_t = '.', value_name = "CHARACTER")]
    decimal: char,
    /// A file instead of the standard output
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

impl CsvOptions {
    /// The style of the lines.
    pub(super) fn style(&self) -> CsvStyle {
        let style = CsvStyle::default()
            .separator(&self.separator.replace("\\t", "\t"))
            .decimal(self.decimal);
        match self.digits {
            Some(digits) => style.digits(digits.into()),
            None => style,
        }
    }
}

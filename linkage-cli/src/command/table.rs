//! `linkage table`: a function over a range of its input, for spreadsheets and programs.

use std::borrow::Cow;
use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, value_parser};
use linkage_runtime::Table;
use linkage_runtime::report::CsvStyle;
use serde_json::{Value, json};

use super::choose::Chosen;
use super::course::{Along, Course};
use super::output::put;
use super::range;
use super::sweep::Rows;
use super::values::Dimensions;
use crate::failure::Failure;
use crate::mechanism::Mechanism;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// The function
    function: String,
    #[command(flatten)]
    course: Course,
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

/// A column with its name and unit.
struct Column<'a> {
    name: &'a str,
    unit: &'a str,
    values: Vec<f64>,
}

/// Writes the table.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let style = options.style();
    if let Some(mistake) = style.mistake().filter(|_| !options.json) {
        let mut command = super::Arguments::command();
        command.error(ErrorKind::ArgumentConflict, mistake).exit();
    }
    let (mechanism, function) = options.chosen.with_function(&options.function)?;
    let assembly = range::assembled(&options.dimensions, &mechanism)?;
    let Along {
        given,
        running,
        positions,
    } = options.course.of(&mechanism, function, options.steps)?;
    let place = running.map(|(place, _)| place);
    let rows = Rows::new(&mechanism, &assembly, function, &given, place, &positions);
    let missing = rows.missing();
    if missing > 0 {
        let count = positions.len();
        eprintln!(
            "note: at {missing} of {count} positions a number is missing: the mechanism cannot be assembled there, or stands at a dead point"
        );
    }
    let input = running.map(|(_, input)| Column {
        name: input.name,
        unit: input.unit,
        values: positions,
    });
    let mut columns: Vec<Column> = input.into_iter().collect();
    let heading = rows.heading().columns.iter().enumerate();
    columns.extend(heading.map(|(index, own)| Column {
        name: own.name,
        unit: own.unit,
        values: rows.column(index).to_vec(),
    }));
    if options.degrees {
        columns.iter_mut().for_each(Column::show_degrees);
    }
    let text = match options.json {
        true => in_json(
            &mechanism,
            &options.function,
            assembly.dimensions(),
            &columns,
        ),
        false => in_lines(&style, &columns),
    };
    put(&text, options.output.as_deref())
}

impl Column<'_> {
    fn show_degrees(&mut self) {
        if self.unit == "rad" {
            self.unit = "deg";
            self.values.iter_mut().for_each(|x| *x = x.to_degrees());
        }
    }

    fn title(&self) -> String {
        match self.unit {
            "" => self.name.to_owned(),
            unit => format!("{} [{unit}]", self.name),
        }
    }
}

impl Options {
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

/// A line for each position, names and units in the first one.
fn in_lines(style: &CsvStyle, columns: &[Column]) -> String {
    let titles: Vec<String> = columns.iter().map(Column::title).collect();
    let mut text = style.line(titles.iter().map(|title| style.word(title)));
    for row in 0..columns.first().map_or(0, |own| own.values.len()) {
        let cells = columns.iter().map(|own| style.number(own.values[row]));
        text += &style.line(cells.map(Cow::Owned));
    }
    text
}

fn in_json(
    mechanism: &Mechanism,
    function: &str,
    dimensions: &[f64],
    columns: &[Column],
) -> String {
    let parameters = mechanism.parameters.iter().zip(dimensions);
    let parameters: Vec<Value> = parameters
        .map(|(own, value)| json!({ "name": own.name, "unit": own.unit, "value": value }))
        .collect();
    let columns: Vec<Value> = columns
        .iter()
        .map(|own| json!({ "name": own.name, "unit": own.unit, "values": own.values }))
        .collect();
    let all = json!({
        "mechanism": mechanism.name,
        "function": function,
        "dimensions": parameters,
        "columns": columns,
    });
    format!("{all}\n")
}

//! `linkage tolerance`: effects of the tolerances of the declaration on the results of a function.

mod aligned;
mod effects;

use std::fmt::Write;

use clap::{Args, value_parser};
use linkage_analysis::tolerance::largest;
use linkage_compiler::ir::{Field, Meaning, Shape};
use linkage_report::CsvStyle;
use linkage_runtime::Input;

use super::choose::Chosen;
use super::output::print;
use super::range;
use super::running_input::{Along, RunningInput};
use super::values::Dimensions;
use crate::engine::Assembly;
use crate::failure::Failure;
use crate::mechanism::Mechanism;
use crate::normal::normal;
use aligned::aligned;
use effects::Figures;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// A function with `sensitivity(...)` among its results
    #[arg(value_parser = normal)]
    function: String,
    #[command(flatten)]
    course: RunningInput,
    /// How many positions, both ends included
    #[arg(long, default_value_t = 37, value_name = "COUNT", value_parser = value_parser!(u32).range(2..))]
    steps: u32,
    #[command(flatten)]
    dimensions: Dimensions,
}

/// Bytes for each number, about: the number, and its text in the table.
const BYTES: usize = 120;

/// A quantity with its derivatives by parameters.
struct Sensitive {
    /// The field, with the number of a component where it has further indices.
    name: String,
    /// The parameters, by index.
    parameters: Vec<usize>,
    /// For each of them, the columns of the components.
    columns: Vec<Vec<usize>>,
    /// The number of further parameters that change nothing.
    idle: usize,
}

impl Sensitive {
    /// Without the parameters that change nothing at any position, as those of the other parts of a
    /// machine. All of them if none changes anything.
    fn acting(mut self, rows: &[Vec<f64>]) -> Self {
        let acts = |columns: &Vec<usize>| {
            let mut numbers = rows
                .iter()
                .flat_map(|row| columns.iter().map(|&column| row[column]));
            numbers.any(|x| x != 0.0)
        };
        let acting: Vec<bool> = self.columns.iter().map(acts).collect();
        let count = acting.iter().filter(|acting| **acting).count();
        if count > 0 {
            self.idle = acting.len() - count;
            let mut flags = acting.iter();
            self.parameters.retain(|_| flags.next() == Some(&true));
            let mut flags = acting.iter();
            self.columns.retain(|_| flags.next() == Some(&true));
        }
        self
    }
}

/// Prints the errors over the range, and the contributions of all parameters at the worst position.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let (mut mechanism, function) = options.chosen.with_function(&options.function)?;
    options.dimensions.tolerate(&mut mechanism)?;
    let all = sensitive(&mechanism, function);
    if all.is_empty() {
        let name = &options.function;
        return Err(Failure::Told(format!(
            "`{name}` has no sensitivities: ask for `e: sensitivity(...)` among its results"
        )));
    }
    if mechanism
        .parameters
        .iter()
        .all(|parameter| parameter.tolerance == 0.0)
    {
        let name = mechanism.name;
        return Err(Failure::Told(format!(
            "no dimension of {name} has a tolerance: declare it as `param crank = 40mm +- 10um;`"
        )));
    }
    let assembly = range::assembled(&options.dimensions, &mechanism)?;
    let Along {
        given,
        running,
        positions,
    } = options
        .course
        .resolve(&mechanism, function, options.steps)?;
    let columns = mechanism.headings[function].columns.len();
    let positions = positions.held(columns, BYTES)?;
    let row = |x: Option<f64>| {
        let mut arguments = given.clone();
        if let (Some((argument_index, _)), Some(x)) = (running, x) {
            arguments[argument_index] = x;
        }
        assembly.call(function, &arguments)
    };
    let rows: Vec<Vec<f64>> = match running {
        Some(_) => positions.iter().map(|&x| row(Some(x))).collect(),
        None => vec![row(None)],
    };
    for sensitive in all {
        let sensitive = sensitive.acting(&rows);
        let at = Position {
            mechanism: &mechanism,
            assembly: &assembly,
            function,
            given: &given,
            sensitive: &sensitive,
        };
        print(&match running {
            Some((argument_index, input)) => at.over(argument_index, input, &positions)?,
            None => format!("{}\n{}\n", at.title(), at.figures(&given)?.text),
        })?;
    }
    Ok(())
}

/// One quantity of an assembly.
struct Position<'a> {
    mechanism: &'a Mechanism,
    assembly: &'a Assembly<'a>,
    function: usize,
    given: &'a [f64],
    sensitive: &'a Sensitive,
}

impl Position<'_> {
    /// The figures with these arguments.
    fn figures(&self, arguments: &[f64]) -> Result<Figures, Failure> {
        let row = self.assembly.call(self.function, arguments);
        let parameters = self.sensitive.parameters.iter();
        let parameters: Vec<_> = parameters
            .map(|&index| self.mechanism.parameters[index])
            .collect();
        let values = self.sensitive.columns.iter();
        let values: Vec<Vec<f64>> = values
            .map(|columns| columns.iter().map(|&column| row[column]).collect())
            .collect();
        effects::figures(&parameters, &values)
    }

    /// `e [mm]`: the unit of the errors is that of a derivative times its dimension.
    fn title(&self) -> String {
        let column = &self.mechanism.headings[self.function].columns[self.sensitive.columns[0][0]];
        let per = self.mechanism.parameters[self.sensitive.parameters[0]].unit;
        let divided = column.unit.strip_suffix(per);
        let name = &self.sensitive.name;
        let title = match divided.and_then(|unit| unit.strip_suffix('/')) {
            Some("1") => name.clone(),
            Some(unit) => format!("{name} [{unit}]"),
            None if per.is_empty() && !column.unit.is_empty() => {
                format!("{name} [{}]", column.unit)
            }
            None => name.clone(),
        };
        match self.sensitive.idle {
            0 => title,
            1 => format!("{title}; one more dimension changes nothing"),
            idle => format!("{title}; {idle} more dimensions change nothing"),
        }
    }

    /// The errors at positions, then all figures where the worst case is largest.
    fn over(
        &self,
        argument_index: usize,
        input: &Input,
        positions: &[f64],
    ) -> Result<String, Failure> {
        let at = |x: f64| {
            let mut arguments = self.given.to_vec();
            arguments[argument_index] = x;
            self.figures(&arguments)
        };
        let style = CsvStyle::default().digits(6);
        let (unit, shown): (&str, fn(f64) -> f64) = match input.unit {
            "rad" => ("deg", f64::to_degrees),
            other => (other, |x| x),
        };
        let parameters = self.sensitive.parameters.iter();
        let parameters = parameters.map(|&index| self.mechanism.parameters[index]);
        let parameters: Vec<_> = parameters.collect();
        let toleranced = |parts: Vec<f64>| {
            let pairs = parts.into_iter().zip(&parameters);
            let with = pairs.filter(|(_, parameter)| parameter.tolerance > 0.0);
            with.map(|(part, _)| style.number(part))
        };
        let names = parameters
            .iter()
            .filter(|parameter| parameter.tolerance > 0.0);
        let names = names.map(|parameter| parameter.name.to_owned());
        let titles = ["worst case", "statistical"].map(str::to_owned);
        let mut rows: Vec<Vec<String>> = vec![
            [format!("{} [{unit}]", input.name)]
                .into_iter()
                .chain(titles)
                .chain(names)
                .collect(),
        ];
        for &x in positions {
            let figures = at(x)?;
            let numbers = [shown(x), figures.worst, figures.statistical];
            let numbers = numbers.map(|x| style.number(x)).into_iter();
            rows.push(numbers.chain(toleranced(figures.parts)).collect());
        }
        let mut text = format!("{}\n{}", self.title(), aligned(&rows));
        let [Some(&low), Some(&high)] = [positions.first(), positions.last()] else {
            return Ok(text);
        };
        let figure = |x: f64| at(x).map_or(f64::NAN, |at| at.worst);
        let worst = largest(low..high, positions.len().max(2), figure);
        let worst = worst.map_err(|error| Failure::Told(error.to_string()))?;
        // The place of a largest value is as accurate as the root of roundoff.
        let is_zero = worst.at.abs() < 1e-7 * (high - low);
        let argument_index = super::assemblies::placed(input, if is_zero { 0.0 } else { worst.at });
        let _ = writeln!(text, "\nworst at {argument_index}\n{}", at(worst.at)?.text);
        Ok(text)
    }
}

/// The fields of a function that are arrays over parameters; where an entry is no number or vector,
/// each number of it by itself.
fn sensitive(mechanism: &Mechanism, function: usize) -> Vec<Sensitive> {
    let compiled = &mechanism.unit.functions[function];
    let mut first = 0;
    let mut all = Vec::new();
    for field in &compiled.fields {
        let width = width(&field.shape);
        let columns = &compiled.columns[first..first + width];
        let parameters: Vec<usize> = columns
            .iter()
            .filter_map(|column| match column.meaning {
                Meaning::Sensitivity { parameter, .. } => Some(parameter),
                Meaning::Value | Meaning::Rate { .. } | Meaning::Margin | Meaning::Picture => None,
            })
            .collect();
        if parameters.len() == width && width > 0 {
            all.extend(quantities(field, &parameters, first));
        }
        first += width;
    }
    all
}

/// The quantities of a field whose columns are derivatives by these parameters.
fn quantities(field: &Field, parameters: &[usize], first: usize) -> Vec<Sensitive> {
    // A derivative by one parameter has no index.
    let (entries, entry) = match &field.shape {
        Shape::Array(count, entry) if parameters.windows(2).any(|pair| pair[0] != pair[1]) => {
            (*count, &**entry)
        }
        whole => (1, whole),
    };
    let inner = width(entry);
    let together = match entry {
        Shape::Scalar | Shape::Vector(_) => inner,
        Shape::Array(..) | Shape::Frame | Shape::PlaneFrame => 1,
    };
    let part = |start: usize| {
        let components = start..start + together;
        let columns = |entry: usize| {
            let components = components.clone();
            components.map(move |k| first + entry * inner + k).collect()
        };
        Sensitive {
            name: match together == inner {
                true => field.name.clone(),
                false => format!("{}, number {}", field.name, start + 1),
            },
            parameters: (0..entries)
                .map(|entry| parameters[entry * inner])
                .collect(),
            columns: (0..entries).map(columns).collect(),
            idle: 0,
        }
    };
    (0..inner).step_by(together).map(part).collect()
}

fn width(shape: &Shape) -> usize {
    match shape {
        Shape::Scalar => 1,
        Shape::Vector(count) => *count,
        Shape::Array(count, entry) => count * width(entry),
        Shape::Frame => 12,
        Shape::PlaneFrame => 6,
    }
}

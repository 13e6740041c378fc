//! `linkage tolerance`: effects of the tolerances of the declaration on the results of a function.

mod aligned;

use std::fmt::Write;

use clap::{Args, value_parser};
use linkage_analysis::tolerance::largest;
use linkage_engine::{Assembly, Mechanism, SensitiveQuantity, ToleranceEffects};
use linkage_report::CsvStyle;
use linkage_runtime::Input;

use super::choose::Chosen;
use super::output::print;
use super::range;
use super::running_input::{Along, RunningInput};
use super::values::Dimensions;
use crate::failure::Failure;
use crate::normal::normal;
use aligned::aligned;

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

/// Prints the errors over the range, and the contributions of all parameters at the worst position.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let (mut mechanism, function) = options.chosen.with_function(&options.function)?;
    options.dimensions.tolerate(&mut mechanism)?;
    let all = mechanism.sensitive_quantities(function);
    if all.is_empty() {
        let name = &options.function;
        return Err(Failure::Told(format!(
            "`{name}` has no sensitivities: ask for `e: sensitivity(...)` among its results"
        )));
    }
    if mechanism
        .parameters()
        .iter()
        .all(|parameter| parameter.tolerance == 0.0)
    {
        let name = mechanism.name();
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
    let columns = mechanism.headings()[function].columns.len();
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
    sensitive: &'a SensitiveQuantity,
}

impl Position<'_> {
    /// The figures with these arguments.
    fn figures(&self, arguments: &[f64]) -> Result<ToleranceEffects, Failure> {
        let row = self.assembly.call(self.function, arguments);
        let effects = self.sensitive.effects(self.mechanism, &row);
        effects.map_err(|error| Failure::Told(error.to_string()))
    }

    /// `e [mm]`: the unit of the errors is that of a derivative times its dimension.
    fn title(&self) -> String {
        let column =
            &self.mechanism.headings()[self.function].columns[self.sensitive.columns[0][0]];
        let per = self.mechanism.parameters()[self.sensitive.parameters[0]].unit;
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
        let parameters = parameters.map(|&index| self.mechanism.parameters()[index]);
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

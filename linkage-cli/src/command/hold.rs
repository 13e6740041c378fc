//! `linkage hold`: the load, the spring rate or the mass for which a result has a wanted value.
//!
//! Forces are linear in loads, spring rates and masses. Two evaluations give the line, and a third
//! one at the solution proves that the result has the wanted value.

mod position;

use clap::Args;
use linkage_compiler::{short_words, shortened};
use linkage_engine::Mechanism;

use super::arguments_given::inputs_given;
use super::choose::Chosen;
use super::gap_reason::reason_of_gap;
use super::output::print;
use super::range;
use super::rounded::rounded;
use super::sweep::arguments;
use super::values::{Dimensions, number, parts};
use crate::failure::{Failure, known_names, listed};
use crate::normal::normal;
use position::note_of_range;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// The function
    #[arg(value_parser = normal)]
    function: String,
    /// A result of the function and its value, as `t=0N*mm` or `p.x=250N`
    #[arg(value_name = "RESULT=VALUE", value_parser = normal)]
    wanted: String,
    /// The argument or the dimension that gives the result this value: a load, a spring rate, a
    /// mass
    #[arg(long, value_name = "NAME", value_parser = normal)]
    by: String,
    /// Another argument of the function, as `phi=45deg`; by default inputs have their reference
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    at: Vec<String>,
    #[command(flatten)]
    dimensions: Dimensions,
}

/// The largest difference from the wanted value, relative to the numbers whose sum the result is.
/// Rounding is far below, and a result that is not linear far above.
const LINEAR: f64 = 1e-9;

/// The number of significant digits of the answer: the last digits of a number are rounding.
const DIGITS: usize = 12;

/// Prints the value.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let (mechanism, function) = options.chosen.with_function(&options.function)?;
    let columns = mechanism.headings()[function].columns;
    let (name, text) = parts(&options.function, &options.wanted)?;
    let Some(column) = columns.iter().position(|column| column.name == name) else {
        return Err(Failure::Told(format!(
            "`{}` has no result `{}`; it has {}",
            options.function,
            shortened(name),
            known_names(name, columns.iter().map(|column| column.name))
        )));
    };
    let wanted = number(&mechanism, name, text, columns[column].unit)?;
    let varied = Varied::new(options, &mechanism, function)?;
    // Mistakes and warnings of other dimensions come first.
    range::assembled(&options.dimensions, &mechanism)?;
    let result = |x: f64| {
        varied
            .results(x)
            .map_or(f64::NAN, |results| results[column])
    };
    let by = &options.by;
    let inputs = inputs_given(&mechanism, function, &varied.arguments);
    note_of_range(&mechanism, &inputs, by);
    match solution(result, varied.nominal, wanted) {
        Solution::Value(x) => print(&format!("{by} = {}\n", shown(x, varied.unit))),
        Solution::Beyond(x) => Err(Failure::Told(format!(
            "`{by} = {}` is needed, but {}",
            shown(x, varied.unit),
            varied.reason_beyond(x)
        ))),
        Solution::Constant => Err(Failure::Told(format!("`{by}` does not change `{name}`"))),
        Solution::Missing => Err(Failure::Told(format!(
            "`{name}` is no number {}",
            reason_of_gap(
                &mechanism,
                &mechanism.assemble(&varied.dimensions)?,
                &inputs
            )
        ))),
        Solution::Curved => Err(Failure::Told(format!(
            "`{name}` is not linear in `{by}`\n\
             help: name a load, a spring rate or a mass after `--by`; `linkage table` shows `{name}` for others"
        ))),
    }
}

/// The argument or the dimension that is varied.
struct Varied<'a> {
    mechanism: &'a Mechanism,
    function: usize,
    /// The arguments of the function, and the number of the varied one among them.
    arguments: Vec<f64>,
    argument: Option<usize>,
    /// The dimensions, and the number of the varied one among them.
    dimensions: Vec<f64>,
    dimension: Option<usize>,
    /// The value in the declaration; zero if it has none.
    nominal: f64,
    unit: &'a str,
}

impl<'a> Varied<'a> {
    /// Finds the name after `--by` among the arguments of the function and the dimensions.
    fn new(options: &Options, mechanism: &'a Mechanism, function: usize) -> Result<Self, Failure> {
        let by = options.by.as_str();
        let heading = mechanism.headings()[function];
        let argument = heading.arguments.iter().position(|name| *name == by);
        let mut parameters = mechanism.parameters().iter();
        let dimension = parameters.position(|parameter| parameter.name == by);
        let mut given = options.at.clone();
        for given in &given {
            let (name, _) = parts("--at", given)?;
            if name == by {
                return Err(Failure::Told(format!(
                    "`{}` is sought and cannot be given by `--at`, too",
                    shortened(by)
                )));
            }
        }
        let places = &mechanism.compiled().functions[function].arguments;
        let (nominal, unit) = match (argument, dimension) {
            (Some(argument), _) => {
                let nominal = mechanism.default_argument(places[argument]);
                let (_, unit) = mechanism.argument(places[argument]);
                if nominal.is_none() {
                    // A speed has no default; its value is replaced.
                    given.push(format!("{by}=0"));
                }
                (nominal.unwrap_or_default(), unit)
            }
            (None, Some(dimension)) => {
                let parameter = mechanism.parameters()[dimension];
                let values = options.dimensions.resolve(mechanism)?;
                (values[dimension], parameter.unit)
            }
            (None, None) => {
                return Err(unknown(mechanism, function, by));
            }
        };
        let arguments = arguments(mechanism, function, &given)?.complete();
        Ok(Self {
            mechanism,
            function,
            arguments: arguments.map_err(|why| {
                let function = heading.function;
                Failure::Told(format!("`{function}` cannot be evaluated: {why}"))
            })?,
            argument,
            dimensions: options.dimensions.resolve(mechanism)?,
            dimension: dimension.filter(|_| argument.is_none()),
            nominal,
            unit,
        })
    }

    /// The results of the function for another value.
    fn results(&self, x: f64) -> Result<Vec<f64>, Failure> {
        let (arguments, dimensions) = self.with(x);
        let assembly = self.mechanism.assemble(&dimensions)?;
        Ok(assembly.call(self.function, &arguments))
    }

    /// Returns the reason why there are no results for another value.
    fn reason_beyond(&self, x: f64) -> String {
        let (arguments, dimensions) = self.with(x);
        let assembly = match self.mechanism.assemble(&dimensions) {
            Ok(assembly) => assembly,
            Err(error) => return format!("with it {}", short_words(&error.to_string())),
        };
        let inputs = inputs_given(self.mechanism, self.function, &arguments);
        let reason = reason_of_gap(self.mechanism, &assembly, &inputs);
        format!("there is no result {reason}")
    }

    /// All arguments and dimensions with another value.
    fn with(&self, x: f64) -> (Vec<f64>, Vec<f64>) {
        let [mut arguments, mut dimensions] = [&self.arguments, &self.dimensions].map(Clone::clone);
        if let Some(argument) = self.argument {
            arguments[argument] = x;
        }
        if let Some(dimension) = self.dimension {
            dimensions[dimension] = x;
        }
        (arguments, dimensions)
    }
}

/// Returns the message for a name that is neither an argument nor a dimension.
fn unknown(mechanism: &Mechanism, function: usize, by: &str) -> Failure {
    let heading = mechanism.headings()[function];
    let all = mechanism.headings().iter();
    let taking = all.filter(|other| other.arguments.contains(&by));
    let taking: Vec<&str> = taking.map(|other| other.function).collect();
    if !taking.is_empty() {
        return Failure::Told(format!(
            "`{}` does not depend on `{by}`, which it does not take\n\
             help: `{by}` is an argument of {}",
            heading.function,
            listed(taking)
        ));
    }
    let parameters = mechanism.parameters().iter();
    let names = parameters.map(|parameter| parameter.name);
    let names = heading.arguments.iter().copied().chain(names);
    Failure::Told(format!(
        "`{}` is no argument of `{}` and no dimension of {}; there is {}",
        shortened(by),
        heading.function,
        mechanism.name(),
        known_names(by, names)
    ))
}

/// The answer to the question for which value a result is as wanted.
enum Solution {
    Value(f64),
    /// The result is as wanted for a value with which the mechanism cannot be assembled.
    Beyond(f64),
    /// The result does not depend on the value.
    Constant,
    /// The result is not linear in the value.
    Curved,
    /// The result is not a number.
    Missing,
}

/// Solves `result(x) = wanted` for a result that is linear in `x`.
fn solution(result: impl Fn(f64) -> f64, nominal: f64, wanted: f64) -> Solution {
    let step = if nominal == 0.0 { 1.0 } else { nominal };
    let [first, second] = [nominal, nominal + step].map(&result);
    if !first.is_finite() {
        return Solution::Missing;
    }
    let change = second - first;
    if change.abs() <= LINEAR * (first.abs() + second.abs()) {
        return Solution::Constant;
    }
    let steps = (wanted - first) / change;
    let x = nominal + steps * step;
    let scale = first.abs() + wanted.abs() + (steps * change).abs();
    // A curve might pass through the wanted value by chance: the middle has to fit, too. Nothing
    // fits for a dimension that prevents the assembly.
    let middle = nominal + 0.5 * (steps * step);
    let [found, halfway] = [x, middle].map(&result);
    let fits = |found: f64, line: f64| (found - line).abs() <= LINEAR * scale;
    let is_straight = || fits(result(nominal + 0.5 * step), 0.5 * (first + second));
    if fits(found, wanted) && fits(halfway, 0.5 * (first + wanted)) {
        Solution::Value(x)
    } else if found.is_nan() && is_straight() {
        Solution::Beyond(x)
    } else {
        Solution::Curved
    }
}

/// A value with its unit, without the digits that are rounding.
fn shown(x: f64, unit: &str) -> String {
    let x = rounded(x, DIGITS);
    match unit {
        "" => format!("{x}"),
        unit => format!("{x} {unit}"),
    }
}

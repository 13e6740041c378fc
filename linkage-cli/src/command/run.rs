//! `linkage run`: the motion that loads, weights and springs make, as CSV over time.

mod driven;
mod stops;

use std::borrow::Cow;
use std::io::{self, Write};

use clap::{Args, value_parser};
use linkage_dynamics::{Cause, Ended, Method, Motion, Problem, State};
use linkage_engine::{Assembly, Mechanism};
use linkage_report::Mistake;

use super::assemblies::placed;
use super::choose::Chosen;
use super::column::Column;
use super::csv_options::CsvOptions;
use super::gap_reason::reason_of_gap;
use super::output::put;
use super::range;
use super::rounded::rounded;
use super::values::{Dimensions, number};
use crate::failure::Failure;
use crate::normal::normal;
use driven::Driven;
use stops::Stop;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// A function that has `driven_acceleration` of each input and takes their speeds; by default
    /// the first one
    #[arg(value_parser = normal)]
    function: Option<String>,
    /// The time for which it moves, as `2s` or `500ms`
    #[arg(long = "for", value_name = "TIME", value_parser = normal)]
    time: String,
    /// An input or a speed at the start, or a load, as `phi=45deg`, `omega=2`, `motor=3N*m`; by
    /// default inputs have their reference and speeds are zero
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    at: Vec<String>,
    /// An earlier end: an input, a speed or a result passes a value, as `phi=360deg` or `omega=0`
    #[arg(long, value_name = "NAME=VALUE", value_parser = normal)]
    stop: Vec<String>,
    /// How many rows at even distances in time, both ends included
    #[arg(long, default_value_t = 201, value_name = "COUNT", value_parser = value_parser!(u32).range(2..))]
    steps: u32,
    /// The error of a step of integration, relative and absolute
    #[arg(long, default_value_t = 1e-10, value_name = "NUMBER")]
    tolerance: f64,
    /// An implicit method, for stiff springs
    #[arg(long)]
    stiff: bool,
    #[command(flatten)]
    dimensions: Dimensions,
    #[command(flatten)]
    csv: CsvOptions,
}

/// Significant digits of a time in messages.
const DIGITS: usize = 10;

/// The most inputs that move together.
const MOST: usize = 4;

/// Writes the motion.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let (mechanism, function) = driven::chosen(&options.chosen, options.function.as_deref())?;
    let driven = Driven::new(&mechanism, function, &options.at)?;
    match driven.count() {
        1 => moved::<1>(options, &driven),
        2 => moved::<2>(options, &driven),
        3 => moved::<3>(options, &driven),
        MOST => moved::<MOST>(options, &driven),
        count => Err(Failure::Told(format!(
            "{} has {count} inputs; at most {MOST} move together",
            mechanism.name()
        ))),
    }
}

impl Options {
    /// Returns the mistake of a style whose cells are ambiguous.
    pub(super) fn mistake(&self) -> Option<Mistake> {
        self.csv.style().mistake()
    }
}

fn moved<const N: usize>(options: &Options, driven: &Driven<'_>) -> Result<(), Failure> {
    let mechanism = driven.mechanism;
    let time = number(mechanism, "--for", &options.time, "s")?;
    let stops = Stop::all(driven, &options.stop)?;
    let assembly = &range::assembled(&options.dimensions, mechanism)?;
    let [inputs, speeds] = driven.start::<N>();
    let method = match options.stiff {
        true => Method::Implicit,
        false => Method::Explicit,
    };
    let accelerations =
        |_, inputs: [f64; N], speeds: [f64; N]| driven.accelerations(assembly, inputs, speeds);
    let mut problem = Problem::new(accelerations)
        .start(inputs, speeds)
        .tolerance(options.tolerance)
        .method(method);
    for stop in &stops {
        problem = problem.event(stop.event(driven, assembly));
    }
    let result = problem.until(time);
    let (motion, failure) = match &result {
        Ok(motion) => (motion, None),
        Err(interrupted) => {
            let cause = explained(mechanism, assembly, interrupted.cause());
            (interrupted.motion(), Some(cause))
        }
    };
    // A start without accelerations has no motion at all.
    if motion.steps() > 0 {
        put(
            options.csv.output.as_deref(),
            options.chosen.file(),
            |out| written(options, driven, assembly, motion, out),
        )?;
        if let Ended::Event(stop) = motion.ended() {
            eprintln!(
                "note: `{}` after {} s",
                options.stop[stop],
                rounded(motion.end().time, DIGITS)
            );
        }
    }
    failure.map_or(Ok(()), |cause| Err(Failure::Told(cause)))
}

/// The cause of a motion that ends early, with names of inputs.
fn explained<const N: usize>(
    mechanism: &Mechanism,
    assembly: &Assembly<'_>,
    cause: &Cause<N>,
) -> String {
    match cause {
        Cause::DeadPoint { state, input } => format!(
            "the motion ends after {} s at a dead point, {}\nhelp: beyond it the links are in another assembly: \
             use an input that has no dead point there",
            rounded(state.time, DIGITS),
            placed(&mechanism.inputs()[*input], state.inputs[*input])
        ),
        Cause::Undefined { state, .. } => {
            let gap = reason_of_gap(mechanism, assembly, &state.inputs);
            format!(
                "the motion ends after {} s, since there are no accelerations beyond: {gap}\nhelp: look for a dead \
                 point, links without masses, or a load that is no number",
                rounded(state.time, DIGITS)
            )
        }
        other => other.to_string(),
    }
}

/// A line for each time: inputs, speeds and all results of the function.
fn written<const N: usize>(
    options: &Options,
    driven: &Driven<'_>,
    assembly: &Assembly<'_>,
    motion: &Motion<N>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let style = options.csv.style();
    let heading = driven.mechanism.headings()[driven.function];
    let results = heading
        .columns
        .iter()
        .map(|result| (result.name, result.unit));
    let titles = [("time", "s")].into_iter().chain(driven.titles());
    let columns: Vec<Column<'_>> = titles
        .chain(results)
        .map(|(name, unit)| Column::new(name, unit, options.csv.degrees))
        .collect();
    let titles: Vec<String> = columns.iter().map(Column::title).collect();
    let title = style.line(titles.iter().map(|title| style.word(title)));
    out.write_all(title.as_bytes())?;
    for State {
        time,
        inputs,
        speeds,
    } in motion.states(options.steps as usize)
    {
        let row = [time].into_iter().chain(inputs).chain(speeds);
        let row = row.chain(driven.results(assembly, inputs, speeds));
        let cells = row.zip(&columns).map(|(x, column)| column.shown(x));
        let cells = cells.map(|x| Cow::Owned(style.number(x)));
        out.write_all(style.line(cells).as_bytes())?;
    }
    Ok(())
}

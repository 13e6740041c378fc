//! The motion as a page.

use linkage_dynamics::State;
use linkage_engine::{Driven, Mechanism, Source};
use linkage_js::description;
use linkage_page::{
    EnergyFunctions, MotionContents, MotionFunctions, MotionRows, motion_report,
    with_motion_functions,
};
use linkage_runtime::Programs;

use super::super::declaration::declaration;
use super::super::output;
use super::motion_result::MotionResult;
use super::run_options::Options;
use super::stops::Stop;
use crate::failure::Failure;

/// Rows of a page without `--steps`: enough for slow motion.
const ROWS: u32 = 1001;

/// Endings of files that are pages.
const ENDINGS: [&str; 2] = ["html", "htm"];

/// Returns true if the file of the command line is a page.
pub(super) fn is_asked(options: &Options) -> bool {
    let file = options.csv.output.as_deref();
    let ending = file.and_then(|file| file.extension()?.to_str());
    ending.is_some_and(|ending| {
        let mut pages = ENDINGS.iter();
        pages.any(|page| page.eq_ignore_ascii_case(ending))
    })
}

/// The mechanism with the functions of the page.
pub(super) struct PageFunctions {
    mechanism: Mechanism,
    energy: Option<EnergyFunctions>,
}

impl PageFunctions {
    /// Compiles the text once more, with further functions.
    pub(super) fn new(options: &Options, driven: &Driven<'_>) -> Result<Self, Failure> {
        let source = Source::read(options.chosen.file())?;
        let MotionFunctions {
            mut mechanism,
            energy,
        } = with_motion_functions(&source, driven);
        if energy.is_none() {
            eprintln!(
                "note: the page has no check of the energy, since the compiler refuses its functions"
            );
        }
        options.dimensions.tolerate(&mut mechanism)?;
        Ok(Self { mechanism, energy })
    }

    /// Returns the same equation of motion, of the mechanism with further functions.
    pub(super) fn driven(&self, driven: &Driven<'_>) -> Result<Driven<'_>, Failure> {
        let name = driven.mechanism().headings()[driven.function()].function;
        let function = self.mechanism.function(name);
        let function = function.map_err(|error| Failure::Told(error.to_string()))?;
        let driven = self.mechanism.driven(function, driven.start_arguments());
        driven.map_err(|error| Failure::Told(error.to_string()))
    }
}

/// Returns the first line of a message as a sentence without back-ticks.
pub(super) fn sentence(message: &str) -> String {
    let line = message.lines().next().unwrap_or_default();
    let line = line.replace('`', "");
    let mut letters = line.chars();
    let first = letters.next().map(char::to_uppercase);
    let first: String = first.into_iter().flatten().collect();
    format!("{first}{}.", letters.as_str())
}

/// Writes the page to the file of the command line.
pub(super) fn put<const N: usize>(
    options: &Options,
    functions: &PageFunctions,
    result: &MotionResult<'_, N>,
    stops: &[Stop],
    until: f64,
    end: Option<String>,
) -> Result<(), Failure> {
    let mechanism = &functions.mechanism;
    let description = description(mechanism.name(), mechanism.compiled());
    let stops = stops.iter().zip(&options.stop);
    let contents = MotionContents {
        driven: result.driven,
        assembly: result.assembly,
        energy: functions.energy.clone(),
        rows: rows(options, functions.energy.as_ref(), result),
        until,
        tolerance: options.tolerance,
        stops: stops.map(|(stop, text)| stop.on_page(text)).collect(),
        end,
        programs: Programs {
            description: Box::leak(description.into_boxed_str()),
        },
        source: declaration(options.chosen.file(), mechanism.name()),
    };
    let report = motion_report(&contents);
    let html = report.html();
    let html = html.map_err(|error| Failure::Told(error.to_string()))?;
    let file = options.csv.output.as_deref();
    output::put(file, options.chosen.file(), |out| {
        out.write_all(html.as_bytes())
    })
}

/// The states at even distances in time.
fn rows<const N: usize>(
    options: &Options,
    energy: Option<&EnergyFunctions>,
    result: &MotionResult<'_, N>,
) -> MotionRows {
    let MotionResult {
        driven,
        assembly,
        motion,
    } = result;
    let count = options.steps.unwrap_or(ROWS) as usize;
    let states: Vec<State<N>> = motion.states(count).collect();
    let columns = |numbers: &dyn Fn(&State<N>) -> [f64; N]| -> Vec<Vec<f64>> {
        let rows: Vec<[f64; N]> = states.iter().map(numbers).collect();
        (0..N)
            .map(|k| rows.iter().map(|row| row[k]).collect())
            .collect()
    };
    let work = match energy {
        Some(energy) => motion.integrals(count, |state| {
            energy.power(driven, assembly, &state.inputs, &state.speeds)
        }),
        None => Vec::new(),
    };
    MotionRows {
        times: states.iter().map(|state| state.time).collect(),
        inputs: columns(&|state| state.inputs),
        speeds: columns(&|state| state.speeds),
        accelerations: columns(&|state| driven.accelerations(assembly, state.inputs, state.speeds)),
        work,
    }
}

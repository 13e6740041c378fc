//! `linkage run`: the motion that loads, weights and springs make, as CSV over time or as a page.

mod driven;
mod motion_page;
mod motion_result;
mod motion_table;
mod run_options;
mod stops;

use linkage_dynamics::{Cause, Ended, Method, Problem};
use linkage_engine::{Assembly, Driven, Mechanism};

use super::assemblies::placed;
use super::gap_reason::reason_of_gap;
use super::range;
use super::rounded::rounded;
use super::values::number;
use crate::failure::Failure;
use motion_page::PageFunctions;
use motion_result::MotionResult;
pub(super) use run_options::Options;
use stops::Stop;

/// Significant digits of a time in messages.
const DIGITS: usize = 10;

/// The most inputs that move together.
const MOST: usize = 4;

/// Writes the motion.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let (mechanism, function) = driven::chosen(&options.chosen, options.function.as_deref())?;
    let driven = driven::driven(&mechanism, function, &options.at)?;
    if !motion_page::is_asked(options) {
        return moved_by_count(options, &driven, None);
    }
    let functions = PageFunctions::new(options, &driven)?;
    let driven = functions.driven(&driven)?;
    moved_by_count(options, &driven, Some(&functions))
}

/// Moves all inputs. The page has further functions.
fn moved_by_count(
    options: &Options,
    driven: &Driven<'_>,
    page: Option<&PageFunctions>,
) -> Result<(), Failure> {
    match driven.inputs().len() {
        1 => moved::<1>(options, driven, page),
        2 => moved::<2>(options, driven, page),
        3 => moved::<3>(options, driven, page),
        MOST => moved::<MOST>(options, driven, page),
        count => Err(Failure::Told(format!(
            "{} has {count} inputs; at most {MOST} move together",
            driven.mechanism().name()
        ))),
    }
}

fn moved<const N: usize>(
    options: &Options,
    driven: &Driven<'_>,
    page: Option<&PageFunctions>,
) -> Result<(), Failure> {
    let mechanism = driven.mechanism();
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
    let stopped = match motion.ended() {
        Ended::Event(stop) => Some(format!(
            "`{}` after {} s",
            options.stop[stop],
            rounded(motion.end().time, DIGITS)
        )),
        _ => None,
    };
    // A start without accelerations has no motion at all.
    if motion.steps() > 0 {
        let result = MotionResult {
            driven,
            assembly,
            motion,
        };
        let stop = stopped.as_ref();
        let stop = stop.map(|stop| format!("the motion stops at {stop}"));
        let end = failure.as_ref().or(stop.as_ref());
        let end = end.map(|message| motion_page::sentence(message));
        match page {
            None => motion_table::put(options, &result)?,
            Some(functions) => motion_page::put(options, functions, &result, &stops, time, end)?,
        }
        if let Some(stop) = stopped {
            eprintln!("note: {stop}");
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

//! Errors of a design problem, and reasons for a search without result.

mod message;
mod refusals;

use std::boxed::Box;
use std::string::String;
use std::time::Duration;
use std::vec::Vec;

use super::certificate::{Interrupted, Interruption};
use linkage_runtime::AssemblyError;

/// Why a design problem cannot be solved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DesignError {
    /// Several mistakes: all that could be found at once.
    Several(Vec<DesignError>),
    /// A parameter that the mechanism does not have.
    NoParameter {
        /// Its name.
        name: String,
        /// Those that it has.
        known: Vec<&'static str>,
    },
    /// Bounds that contradict each other, or are no numbers.
    Bounds {
        /// The parameter.
        name: String,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// A parameter that is listed twice.
    Twice {
        /// Its name.
        name: String,
    },
    /// A standard deviation that is not positive and finite.
    Deviation {
        /// The quantity that was measured.
        quantity: String,
        /// Its standard deviation.
        deviation: f64,
    },
    /// Readings without standard deviations beside others that have them.
    SomeDeviations {
        /// The quantities that were measured without.
        quantities: Vec<String>,
    },
    /// The mechanism that an identification begins with does not assemble where something was
    /// measured.
    StartOpen {
        /// The first of these inputs.
        input: f64,
        /// The number of readings that cannot be compared.
        open: usize,
        /// All readings.
        count: usize,
    },
    /// No least sum of squares is found.
    Unsettled {
        /// Evaluations that were made.
        steps: usize,
    },
    /// Nothing is to be varied, or nothing is wanted.
    Nothing {
        /// The missing item.
        what: &'static str,
        /// The objective.
        objective: String,
    },
    /// A number that is infinite or NaN.
    NotFinite {
        /// The objective.
        objective: String,
        /// The number.
        number: f64,
    },
    /// A list that has not as many entries as it should.
    Count {
        /// The listed items.
        what: &'static str,
        /// The objective.
        objective: String,
        /// The number that there should be.
        expected: usize,
        /// The number that there is.
        found: usize,
    },
    /// An input outside of the range of the mechanism.
    OutOfRange {
        /// The objective.
        objective: String,
        /// The input.
        input: f64,
        /// The lower end of the range.
        low: f64,
        /// The upper end of the range.
        high: f64,
    },
    /// Evenly spaced positions that are longer than the range of the mechanism.
    TooLong {
        /// The objective.
        objective: String,
        /// The number of positions.
        positions: usize,
        /// The distance from one to the next.
        step: f64,
        /// The distance from the first to the last.
        length: f64,
        /// The length of the range.
        range: f64,
    },
    /// An interval that is longer than where it is to be.
    NoRoom {
        /// The objective.
        objective: String,
        /// The length of the interval.
        length: f64,
        /// The start of its room.
        from: f64,
        /// The end of its room.
        to: f64,
    },
    /// The function has no such quantity.
    NoQuantity {
        /// The function.
        function: &'static str,
        /// The quantity.
        quantity: String,
    },
    /// The function lacks the derivative by the input, where inputs are free.
    NoVelocity {
        /// The function.
        function: &'static str,
        /// The quantity.
        quantity: String,
    },
    /// The function lacks derivatives by parameters that may vary.
    NoSensitivity {
        /// The function.
        function: &'static str,
        /// The quantity.
        quantity: String,
        /// The parameters.
        missing: Vec<String>,
    },
    /// Bounds and relations that cannot hold together: without any of them the others can.
    Contradiction {
        /// The relations, as text.
        relations: Vec<String>,
        /// The bounds, as text.
        bounds: Vec<String>,
        /// The least miss of the last relation where the others hold.
        missed: f64,
    },
    /// Not exactly one goal.
    Goals {
        /// The goals there are.
        goals: Vec<String>,
    },
    /// An objective finds nothing in the mechanism that the search begins with, although it runs
    /// through its whole range.
    NoStart {
        /// The objective.
        objective: String,
    },
    /// A condition that cannot be held within the bounds, as far as the search sees.
    OutOfReach {
        /// The objective.
        objective: String,
        /// The size of the miss, in its unit.
        by: f64,
        /// The parameters that vary, in the mechanism that comes nearest, in SI angles and the unit
        /// of length of the mechanism.
        nearest: Vec<(&'static str, f64)>,
        /// The parameters that are at a bound.
        at_bound: Vec<String>,
        /// The number of equations that must hold: figures that must have a value, and relations
        /// between parameters.
        equations: usize,
        /// The number of variables of the search.
        variables: usize,
        /// True if the search ended where no step makes the violation smaller.
        settled: bool,
    },
    /// Near the optimum there are no values of the catalogues with which all conditions hold.
    NoValues {
        /// The parameters that take values of catalogues.
        parameters: Vec<String>,
    },
    /// The mechanism that was found does not run through its whole range on one circuit, for this
    /// reason.
    NotWhole(Interruption),
    /// That which the search begins with does not.
    StartNotWhole(Interruption),
    /// The mechanism of the declaration does not assemble.
    Start(AssemblyError),
    /// A part of a search that there is not.
    Part {
        /// The part, counted from 0.
        part: usize,
        /// The number of parts.
        of: usize,
    },
    /// Descents of another problem.
    OtherProblem,
    /// Descents from the same starts twice.
    Repeated,
    /// Bytes that are no part of a search, or damaged.
    NoPart,
    /// A part of a search that is not made in parts.
    Undivided,
    /// No mechanism that meets all conditions was found.
    NotFound(Box<Refusals>),
    /// None was found before the search was ended.
    Ended {
        /// Starts that were tried until then, and the reasons for their refusal.
        refusals: Box<Refusals>,
        /// All starts.
        count: usize,
        /// The time limit; `None` if it was cancelled.
        limit: Option<Duration>,
    },
}

impl DesignError {
    /// The error of a search that ended where steps might make the violation smaller, if it did.
    pub(crate) fn unsettled(mut self, open: bool) -> Self {
        if let Self::OutOfReach { settled, .. } = &mut self {
            *settled = !open;
        }
        self
    }

    /// One error of some; `Ok` if there are none.
    pub(crate) fn all(mut errors: Vec<Self>) -> Result<(), Self> {
        match errors.len() {
            0 => Ok(()),
            1 => Err(errors.remove(0)),
            _ => Err(Self::Several(errors)),
        }
    }
}

impl core::error::Error for DesignError {}

/// Reasons why no start led to a mechanism that meets all conditions. Each start counts once: as
/// `refused`, `open`, `broken` or `ended`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Refusals {
    /// Starts that were tried.
    pub starts: usize,
    /// Starts that contradict relations between parameters.
    pub refused: usize,
    /// These relations, as text, with how many starts contradict each: one start may contradict
    /// several.
    pub relations: Vec<(String, usize)>,
    /// Starts that do not assemble where something is wanted.
    pub open: usize,
    /// Starts that end where a condition does not hold.
    pub broken: usize,
    /// These conditions, with how many starts end where each does not hold.
    pub conditions: Vec<(String, usize)>,
    /// The end that violates conditions least: its condition that is missed most, and the size of
    /// the miss.
    pub missed: Option<(String, f64)>,
    /// Starts that end at local optima which meet all conditions. They are refused for the reasons
    /// that follow.
    pub ended: usize,
    /// Distinct optima near which no values of catalogues hold all conditions.
    pub no_values: usize,
    /// Distinct optima that do not assemble over the whole range on one circuit.
    pub not_whole: usize,
    /// That of them with the least sum of squares, and why it does not.
    pub nearest: Option<Interrupted>,
    /// Distinct optima that violate a condition or a relation in the assembly that would be
    /// returned.
    pub unverified: usize,
    /// That of them with the least sum of squares: the condition or relation that is missed most,
    /// and by how much.
    pub violated: Option<(String, f64)>,
    /// The error of the first start of a search that has its own, with its numbers.
    pub first: Option<Box<DesignError>>,
}

/// Functions of users return it: clippy warns of errors of 128 bytes.
const _: () = assert!(size_of::<DesignError>() < 128, "results with it are large");

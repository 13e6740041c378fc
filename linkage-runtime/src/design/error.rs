//! What is wrong with a design problem, and why nothing is found.

mod message;
mod refusals;

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use std::time::Duration;

use super::certificate::{Interrupted, Interruption};
use crate::AssemblyError;

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
        /// What was measured.
        quantity: String,
        /// Its standard deviation.
        deviation: f64,
    },
    /// Readings without standard deviations beside others that have them.
    SomeDeviations {
        /// What was measured without.
        quantities: Vec<String>,
    },
    /// The mechanism that an identification begins with does not assemble where something was measured.
    StartOpen {
        /// The first of these inputs.
        input: f64,
        /// How many readings cannot be compared.
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
        /// What is missing.
        what: &'static str,
        /// Where.
        wish: String,
    },
    /// A number that is infinite or NaN.
    NotFinite {
        /// Where.
        wish: String,
        /// The number.
        number: f64,
    },
    /// A list that has not as many entries as it should.
    Count {
        /// What is listed.
        what: &'static str,
        /// Where.
        wish: String,
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// An input outside of the range of the mechanism.
    OutOfRange {
        /// Where.
        wish: String,
        /// The input.
        input: f64,
        /// The lower end of the range.
        low: f64,
        /// The upper end of the range.
        high: f64,
    },
    /// Evenly spaced positions that are longer than the range of the mechanism.
    TooLong {
        /// Where.
        wish: String,
        /// How many positions.
        positions: usize,
        /// From one to the next.
        step: f64,
        /// From the first to the last.
        length: f64,
        /// The length of the range.
        range: f64,
    },
    /// An interval that is longer than where it is to be.
    NoRoom {
        /// The wish.
        wish: String,
        /// The length of the interval.
        length: f64,
        /// Where its room begins.
        from: f64,
        /// Where it ends.
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
        /// The relations, in words.
        relations: Vec<String>,
        /// The bounds, in words.
        bounds: Vec<String>,
        /// By how much the last of the relations is missed at least where the others hold.
        missed: f64,
    },
    /// Not exactly one goal.
    Goals {
        /// The goals there are.
        goals: Vec<String>,
    },
    /// A wish finds nothing in the mechanism that the search begins with, although it runs through its whole range.
    NoStart {
        /// The wish.
        wish: String,
    },
    /// A condition that cannot be held within the bounds, as far as the search sees.
    OutOfReach {
        /// The wish.
        wish: String,
        /// By how much it is missed, in its unit.
        by: f64,
        /// The parameters that vary, in the mechanism that comes nearest, in SI angles and the unit of length of the mechanism.
        nearest: Vec<(&'static str, f64)>,
        /// The parameters that are at a bound.
        at_bound: Vec<String>,
        /// How many equations must hold: figures that must have a value, and relations between parameters.
        equations: usize,
        /// How many variables the search has.
        variables: usize,
        /// Whether the search ended where no step makes the violation smaller.
        settled: bool,
    },
    /// Near the optimum there are no values of the catalogues with which all conditions hold.
    NoValues {
        /// The parameters that take values of catalogues.
        parameters: Vec<String>,
    },
    /// The mechanism that was found does not run through its whole range on one circuit, for this reason.
    NotWhole(Interruption),
    /// That which the search begins with does not.
    StartNotWhole(Interruption),
    /// The mechanism of the declaration does not assemble.
    Start(AssemblyError),
    /// No mechanism that holds what must hold was found.
    NotFound(Box<Refusals>),
    /// None was found before the search was ended.
    Ended {
        /// Starts that were tried until then, and what refused them.
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

/// Why no start led to a mechanism that holds what must hold. Each start counts once: as `refused`, `open`, `broken` or `ended`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Refusals {
    /// Starts that were tried.
    pub starts: usize,
    /// Starts that contradict relations between parameters.
    pub refused: usize,
    /// These relations, in words, with how many starts contradict each: one start may contradict several.
    pub relations: Vec<(String, usize)>,
    /// Starts that do not assemble where something is wanted.
    pub open: usize,
    /// Starts that end where a condition does not hold.
    pub broken: usize,
    /// These conditions, with how many starts end where each does not hold.
    pub conditions: Vec<(String, usize)>,
    /// Of the ends that violate conditions the one that comes nearest: its condition that is missed most, and by how much.
    pub missed: Option<(String, f64)>,
    /// Starts that end at local optima which hold all conditions; they are refused for what follows.
    pub ended: usize,
    /// Distinct optima near which no values of catalogues hold all conditions.
    pub no_values: usize,
    /// Distinct optima that do not assemble over the whole range on one circuit.
    pub not_whole: usize,
    /// That of them with the least sum of squares, and why it does not.
    pub nearest: Option<Interrupted>,
    /// Distinct optima that violate a condition or a relation in the assembly that would be returned.
    pub unverified: usize,
    /// That of them with the least sum of squares: the condition or relation that is missed most, and by how much.
    pub violated: Option<(String, f64)>,
    /// What refused the first start of a search that has one of its own, with its numbers.
    pub first: Option<Box<DesignError>>,
}

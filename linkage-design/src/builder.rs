//! A design problem as it is written.

use core::sync::atomic::AtomicBool;
use std::boxed::Box;
use std::time::Duration;
use std::vec::Vec;

use super::condition::Condition;
use super::numbered::WHOLE;
use super::settings::{Progress, Settings, settings_methods};
use super::varied::{Freedom, freedom_methods};
use super::{DesignError, DesignPart, Objective, Relation};
use linkage_runtime::{AssemblyError, Circuits, DimensionSet};

/// Starts, unless the design says otherwise.
const STARTS: usize = 1024;
/// Evaluations of a descent, unless the design sets another number: ten times those of most
/// descents.
const STEPS: usize = 300;
/// Designs that are listed, unless the design says otherwise.
const LISTED: usize = 100;
/// The function `circuits()` of a mechanism.
pub(crate) type CircuitsOf<'a, M, A> =
    Box<dyn Fn(&M) -> Result<Circuits<A>, AssemblyError> + Send + Sync + 'a>;

/// A design problem: variables, goals and conditions.
pub struct Design<'a, M, A, const N: usize> {
    pub(super) nominal: M,
    pub(super) assemblies: Vec<A>,
    pub(super) circuits: CircuitsOf<'a, M, A>,
    pub(super) freedom: Freedom,
    pub(super) objectives: Vec<Box<dyn Objective<M, A> + 'a>>,
    pub(super) settings: Settings<'a>,
    pub(super) listed: usize,
    /// The part of the starts, and the number of parts.
    pub(super) part: [usize; 2],
    pub(super) known: Vec<DesignPart>,
}

impl<'a, M, A, const N: usize> Design<'a, M, A, N>
where
    M: DimensionSet<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// A problem for a mechanism, whose parameters stay as they are unless they [vary](Self::vary);
    /// for example `Design::new(FourBar::default(), FourBar::assemble, FourBar::assemblies,
    /// FourBar::circuits)`.
    ///
    /// The search tries the modes of all `assemblies`; `circuits` certifies its results. Where
    /// there are none at all, the error of `assemble` has the closure errors.
    ///
    /// # Errors
    ///
    /// `Start` if the mechanism assembles nowhere in its range.
    pub fn new(
        nominal: M,
        assemble: impl FnOnce(&M) -> Result<A, AssemblyError>,
        assemblies: impl FnOnce(&M) -> Result<Vec<A>, AssemblyError>,
        circuits: impl Fn(&M) -> Result<Circuits<A>, AssemblyError> + Send + Sync + 'a,
    ) -> Result<Self, DesignError> {
        let mut found = assemblies(&nominal).map_err(DesignError::Start)?;
        if found.is_empty() {
            // None at the reference, but perhaps elsewhere.
            let elsewhere = circuits(&nominal).map_err(DesignError::Start)?;
            found.extend(elsewhere.branches.into_iter().map(|branch| branch.assembly));
        }
        if found.is_empty() {
            found.push(assemble(&nominal).map_err(DesignError::Start)?);
        }
        Ok(Self {
            assemblies: found,
            nominal,
            circuits: Box::new(circuits),
            freedom: Freedom::default(),
            objectives: Vec::new(),
            settings: Settings::new(STARTS, STEPS),
            listed: LISTED,
            part: WHOLE,
            known: Vec::new(),
        })
    }

    freedom_methods!();
    settings_methods!(
        "How many starts are tried, 1024 without it.",
        "The most evaluations of a descent, 300 without it.",
        "starts are"
    );

    /// Something is wanted.
    #[must_use]
    pub fn want(mut self, objective: impl Objective<M, A> + 'a) -> Self {
        self.objectives.push(Box::new(objective));
        self
    }

    /// The most designs that are listed, 100 without it;
    /// [`DesignSearch::left_out`](super::DesignSearch::left_out) tells of how many optima more
    /// there are.
    #[must_use]
    pub fn listed(mut self, designs: usize) -> Self {
        self.listed = designs;
        self
    }

    /// Part `part` of `of`, counted from 0: some of the starts, nearly as many as each other part
    /// has. [`descend`](Self::descend) makes its descents.
    #[must_use]
    pub fn part(mut self, part: usize, of: usize) -> Self {
        self.part = [part, of];
        self
    }

    /// Takes descents of the same problem from another process or a file; they are not made again.
    /// `run` and `descend` return `OtherProblem` if they are of another one.
    #[must_use]
    pub fn known(mut self, part: DesignPart) -> Self {
        self.known.push(part);
        self
    }

    /// Calls `report` about ten times a second and at the end, on the thread that called `run`.
    #[must_use]
    pub fn progress(mut self, report: impl FnMut(Progress) + 'a) -> Self {
        self.settings.progress = Some(Box::new(report));
        self
    }
}

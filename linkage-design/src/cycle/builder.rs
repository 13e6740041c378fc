//! A design problem of a whole cycle as it is written.

use core::sync::atomic::AtomicBool;
use std::boxed::Box;
use std::time::Duration;
use std::vec::Vec;

use super::super::builder::CircuitsOf;
use super::super::condition::Condition;
use super::super::numbered::WHOLE;
use super::super::settings::{Progress, Settings, settings_methods};
use super::super::varied::{Freedom, freedom_methods};
use super::super::{DesignError, Relation};
use super::{CycleObjective, CyclePart};
use linkage_runtime::{AssemblyError, Circuits, Dimensions};

/// Positions from which limits are searched, unless the design says otherwise: three degrees of a
/// turn.
const POSITIONS: usize = 121;
/// Steps of a search, unless the design says otherwise: ten times the steps of most searches.
const STEPS: usize = 300;
pub(super) type AssembleFrom<'a, M, A> =
    Box<dyn Fn(&M, &A) -> Result<A, AssemblyError> + Send + Sync + 'a>;

/// The best mechanism for a goal that is a least or greatest value over a cycle, from a mechanism
/// that is there: parameters within bounds, one goal, conditions.
///
/// The search is by sequential quadratic programming with exact derivatives; it ends at a local
/// optimum. A mechanism is assembled in the modes of the first one, and any that does not run
/// through the whole range is refused at once. The result is certified by `circuits()`: assembled
/// over the whole range on one circuit.
pub struct CycleDesign<'a, M, A, const N: usize> {
    pub(super) nominal: M,
    pub(super) assembly: A,
    pub(super) assemble: AssembleFrom<'a, M, A>,
    pub(super) circuits: CircuitsOf<'a, M, A>,
    pub(super) freedom: Freedom,
    pub(super) objectives: Vec<Box<dyn CycleObjective<M, A, N> + 'a>>,
    pub(super) positions: usize,
    pub(super) all_assemblies: bool,
    pub(super) settings: Settings<'a>,
    /// The part of the starts, and the number of parts.
    pub(super) part: [usize; 2],
    pub(super) known: Vec<CyclePart>,
}

impl<'a, M, A, const N: usize> CycleDesign<'a, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Send + Sync,
{
    /// Builds a design from a mechanism and three of its generated methods:
    /// `CycleDesign::new(Press::default(), Press::assemble, Press::assemble_from,
    /// Press::circuits)`.
    ///
    /// # Errors
    ///
    /// `Start` if the mechanism does not assemble.
    pub fn new(
        nominal: M,
        assemble: impl FnOnce(&M) -> Result<A, AssemblyError>,
        assemble_from: impl Fn(&M, &A) -> Result<A, AssemblyError> + Send + Sync + 'a,
        circuits: impl Fn(&M) -> Result<Circuits<A>, AssemblyError> + Send + Sync + 'a,
    ) -> Result<Self, DesignError> {
        Ok(Self {
            assembly: assemble(&nominal).map_err(DesignError::Start)?,
            nominal,
            assemble: Box::new(assemble_from),
            circuits: Box::new(circuits),
            freedom: Freedom::default(),
            objectives: Vec::new(),
            positions: POSITIONS,
            all_assemblies: false,
            settings: Settings::new(1, STEPS),
            part: WHOLE,
            known: Vec::new(),
        })
    }

    freedom_methods!();
    settings_methods!(
        "From how many dimensions within the bounds the search begins; without it from those of the first mechanism alone, which always come first.",
        "The most steps of the search, 300 without it.",
        "step is"
    );

    /// The goal, or a condition.
    #[must_use]
    pub fn want(mut self, objective: impl CycleObjective<M, A, N> + 'a) -> Self {
        self.objectives.push(Box::new(objective));
        self
    }

    /// Begins in every other assembly of the first mechanism, too, that runs through its whole
    /// range: each start in the modes of each of them.
    #[must_use]
    pub fn in_all_assemblies(mut self) -> Self {
        self.all_assemblies = true;
        self
    }

    /// Sets the number of evenly spaced positions of the range from which limits are searched, both
    /// ends among them; 121 without it.
    #[must_use]
    pub fn positions(mut self, positions: usize) -> Self {
        self.positions = positions;
        self
    }

    /// Part `part` of `of`, counted from 0: some of the starts in all assemblies that are searched,
    /// nearly as many as each other part has. [`descend`](Self::descend) makes its descents.
    #[must_use]
    pub fn part(mut self, part: usize, of: usize) -> Self {
        self.part = [part, of];
        self
    }

    /// Takes descents of the same problem from another process or a file; they are not made again.
    /// `run`, `run_all` and `descend` return `OtherProblem` if they are of another one. A
    /// [`front`](Self::front) has searches of other problems, so that it takes no descents.
    #[must_use]
    pub fn known(mut self, part: CyclePart) -> Self {
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

//! A design problem of a whole cycle as it is written, and its solution.

use alloc::boxed::Box;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::ops::Range;
use core::sync::atomic::AtomicBool;
use std::time::Duration;

use super::super::builder::CircuitsOf;
use super::super::condition::Condition;
use super::super::rounds::in_rounds;
use super::super::settings::{Progress, Settings, settings_methods};
use super::super::turn;
use super::super::varied::{Freedom, Varied, freedom_methods};
use super::super::{DesignError, Relation};
use super::CycleWish;
use super::descents::{Descents, Optimum};
use super::found::BestCycle;
use super::problem::Problem;
use crate::{AssemblyError, Circuits, Dimensions};

/// Positions from which limits are searched, unless the design says otherwise: three degrees of a turn.
const POSITIONS: usize = 121;
/// Steps of a search, unless the design says otherwise: ten times what most searches take.
const STEPS: usize = 300;
type AssembleFrom<'a, M, A> = Box<dyn Fn(&M, &A) -> Result<A, AssemblyError> + Send + Sync + 'a>;

/// The best mechanism for a goal that is a least or greatest value over a cycle, from a mechanism that is there: parameters within bounds, one goal,
/// conditions.
///
/// The search is by sequential quadratic programming with exact derivatives; it ends at a local optimum. A mechanism is assembled in the
/// modes of the first one, and any that does not run through the whole range is refused at once. What it returns is certified by
/// `circuits()`: assembled over the whole range on one circuit.
pub struct CycleDesign<'a, M, A, const N: usize> {
    nominal: M,
    assembly: A,
    assemble: AssembleFrom<'a, M, A>,
    circuits: CircuitsOf<'a, M, A>,
    freedom: Freedom,
    wishes: Vec<Box<dyn CycleWish<M, A, N> + 'a>>,
    positions: usize,
    settings: Settings<'a>,
}

impl<'a, M, A, const N: usize> CycleDesign<'a, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Send + Sync,
{
    /// From a mechanism and three of its generated methods: `CycleDesign::new(Press::default(), Press::assemble, Press::assemble_from, Press::circuits)`.
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
            wishes: Vec::new(),
            positions: POSITIONS,
            settings: Settings::new(1, STEPS),
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
    pub fn want(mut self, wish: impl CycleWish<M, A, N> + 'a) -> Self {
        self.wishes.push(Box::new(wish));
        self
    }

    /// From how many evenly spaced positions of the range limits are searched, both ends among them; 121 without it.
    #[must_use]
    pub fn positions(mut self, positions: usize) -> Self {
        self.positions = positions;
        self
    }

    /// Calls `report` about ten times a second and at the end, on the thread that called `run`.
    #[must_use]
    pub fn progress(mut self, report: impl FnMut(Progress) + 'a) -> Self {
        self.settings.progress = Some(Box::new(report));
        self
    }

    /// Searches for the best mechanism.
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once; `OutOfReach` with the condition that cannot be held, by how much it is missed, and the bounds
    /// that are in the way; `NotWhole` if the optimum does not run through the whole range on one circuit.
    pub fn run(self) -> Result<BestCycle<M, A>, DesignError> {
        Ok(self.run_all()?.swap_remove(0))
    }

    /// Searches from all starts, with feature `rayon` on all threads, and lists the distinct optima that hold what must hold, the best first.
    ///
    /// Equal seeds give equal optima on any number of threads, unless time limit or cancellation end the search.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run); `NotFound`, with how many starts were refused by what, if several were begun and none leads to an optimum.
    pub fn run_all(mut self) -> Result<Vec<BestCycle<M, A>>, DesignError> {
        let end = self.settings.end();
        let Varied {
            indices,
            limits,
            catalogues,
            ..
        } = self.checked()?;
        let cycle = (self.circuits)(&self.nominal)
            .map_err(DesignError::Start)?
            .cycle;
        let assemble = |mechanism: &M| (self.assemble)(mechanism, &self.assembly).ok();
        let stopped = || end.reached();
        let descents = Descents {
            problem: Problem {
                nominal: self.nominal.values(),
                varied: indices,
                limits,
                catalogues,
                range: (cycle.low, cycle.high),
                closed: turn(&cycle).is_some(),
                positions: self.positions,
                wishes: &self.wishes,
                assemble: &assemble,
                circuits: &*self.circuits,
            },
            seed: self.settings.seed,
            steps: self.settings.steps,
            stopped: &stopped,
        };
        // The first start is always begun: the mechanism that is there may be all that is found in time.
        let from = |starts: Range<usize>| {
            (starts.start == 0 || !stopped()).then(|| descents.from(starts.start))
        };
        let least = |found: &Option<Result<Optimum<M, A>, _>>| match found {
            Some(Ok(optimum)) => optimum.least(),
            _ => f64::INFINITY,
        };
        let starts = (self.settings.starts.max(1), 1);
        let ended = |done: usize| done > 0 && stopped();
        let (found, _) = in_rounds(starts, &ended, &mut self.settings.progress, from, least);
        let (mut optima, mut refused) = (Vec::new(), Vec::new());
        for found in found.into_iter().flatten() {
            match found {
                Ok(optimum) => optima.push(optimum),
                Err(error) => refused.push(error),
            }
        }
        match optima.is_empty() {
            true => Err(descents.refusals(refused)),
            false => Ok(descents.distinct(optima)),
        }
    }

    /// What varies and within which limits; or all mistakes.
    fn checked(&self) -> Result<Varied, DesignError> {
        let mut varied = self.freedom.varied(M::PARAMETERS, &self.nominal.values());
        let mut errors = core::mem::take(&mut varied.errors);
        let goals: Vec<_> = self
            .wishes
            .iter()
            .filter(|wish| wish.is_goal())
            .map(|wish| wish.title())
            .collect();
        if goals.len() != 1 {
            errors.push(DesignError::Goals { goals });
        }
        if self.positions < 2 {
            let what = "less than two positions";
            errors.push(DesignError::Nothing {
                what,
                wish: "a design problem".to_string(),
            });
        }
        DesignError::all(errors)?;
        let names = varied.indices.iter().map(|&k| M::PARAMETERS[k].name);
        let names: Vec<_> = names.collect();
        self.freedom.consistent(&varied.limits, &names)?;
        Ok(varied)
    }
}

//! A design problem as it is written.

use alloc::boxed::Box;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::sync::atomic::AtomicBool;
use std::time::Duration;

use super::condition::Condition;
use super::{DesignError, Relation, Wish};
use crate::{AssemblyError, Circuits, Dimensions};

/// Starts, unless the design says otherwise.
const STARTS: usize = 1024;
/// Evaluations of a descent, unless the design says otherwise: ten times what most descents take.
const STEPS: usize = 300;
/// Designs that are listed, unless the design says otherwise.
const LISTED: usize = 100;
/// How `circuits()` of a mechanism is called.
pub(super) type CircuitsOf<'a, M, A> =
    Box<dyn Fn(&M) -> Result<Circuits<A>, AssemblyError> + Send + Sync + 'a>;

/// How far a search has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Starts that are done.
    pub done: usize,
    /// All starts.
    pub count: usize,
    /// The least sum so far, not yet certified; infinite before there is one.
    pub least: f64,
}

/// A design problem: what may vary, what is wanted, what must hold.
pub struct Design<'a, M, A, const N: usize> {
    pub(super) nominal: M,
    pub(super) assemblies: Vec<A>,
    pub(super) circuits: CircuitsOf<'a, M, A>,
    pub(super) varied: Vec<(String, f64, f64)>,
    pub(super) catalogues: Vec<(String, Vec<f64>)>,
    pub(super) relations: Vec<Relation>,
    pub(super) wishes: Vec<Box<dyn Wish<M, A> + 'a>>,
    pub(super) starts: usize,
    pub(super) seed: u64,
    pub(super) steps: usize,
    pub(super) listed: usize,
    pub(super) time: Option<Duration>,
    pub(super) cancel: Option<&'a AtomicBool>,
    pub(super) progress: Option<Box<dyn FnMut(Progress) + 'a>>,
}

impl<'a, M, A, const N: usize> Design<'a, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// A problem for a mechanism, whose parameters stay as they are unless they [vary](Self::vary); for example
    /// `Design::new(FourBar::default(), FourBar::assemble, FourBar::assemblies, FourBar::circuits)`.
    ///
    /// The search tries the modes of all `assemblies`; `circuits` certifies what it finds. Where there are none at all,
    /// `assemble` tells by how much they miss.
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
            varied: Vec::new(),
            catalogues: Vec::new(),
            relations: Vec::new(),
            wishes: Vec::new(),
            starts: STARTS,
            seed: 0,
            steps: STEPS,
            listed: LISTED,
            time: None,
            cancel: None,
            progress: None,
        })
    }

    /// A parameter may vary between these bounds, both included: named as in `PARAMETERS`, `pivot.x` for a component.
    #[must_use]
    pub fn vary(mut self, name: &str, low: f64, high: f64) -> Self {
        self.varied.push((name.to_string(), low, high));
        self
    }

    /// A parameter may vary by this part of its present size, 0.02 for two percent.
    #[must_use]
    pub fn vary_by(self, name: &str, part: f64) -> Self {
        let present = M::PARAMETERS
            .iter()
            .position(|parameter| parameter.name == name);
        let value = present.map_or(f64::NAN, |index| self.nominal.values()[index]);
        let room = part * value.abs();
        self.vary(name, value - room, value + room)
    }

    /// A parameter takes one of these values only, as lengths of a catalogue: instead of [`vary`](Self::vary).
    ///
    /// Each local optimum with the parameter anywhere between them is rounded by branch and bound: one such parameter after the
    /// other is set to the values below and above, and everything else is optimised anew.
    #[must_use]
    pub fn catalogue(mut self, name: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let [low, high] = [values.first(), values.last()].map(|x| x.copied().unwrap_or(f64::NAN));
        self.catalogues.push((name.to_string(), values));
        self.vary(name, low, high)
    }

    /// A relation, or several, between parameters must hold.
    #[must_use]
    pub fn hold(mut self, relations: impl Into<Vec<Relation>>) -> Self {
        self.relations.extend(relations.into());
        self
    }

    /// A number that follows from the dimensions must not be negative: `function` gives it with its derivatives by all parameters,
    /// in their order and units.
    #[must_use]
    pub fn hold_that(
        mut self,
        title: &str,
        function: impl Fn(&M) -> (f64, [f64; N]) + Send + Sync + 'a,
    ) -> Self {
        self.wishes.push(Box::new(Condition::new(title, function)));
        self
    }

    /// Something is wanted.
    #[must_use]
    pub fn want(mut self, wish: impl Wish<M, A> + 'a) -> Self {
        self.wishes.push(Box::new(wish));
        self
    }

    /// How many starts are tried, 1024 without it.
    #[must_use]
    pub fn starts(mut self, starts: usize) -> Self {
        self.starts = starts;
        self
    }

    /// Another seed gives other starts.
    #[must_use]
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// The most evaluations of a descent, 300 without it.
    #[must_use]
    pub fn steps(mut self, steps: usize) -> Self {
        self.steps = steps;
        self
    }

    /// The most designs that are listed, 100 without it.
    #[must_use]
    pub fn listed(mut self, designs: usize) -> Self {
        self.listed = designs;
        self
    }

    /// No starts are begun after this time; what is found then depends on the machine.
    #[must_use]
    pub fn time_limit(mut self, time: Duration) -> Self {
        self.time = Some(time);
        self
    }

    /// No starts are begun once this is true.
    #[must_use]
    pub fn cancel(mut self, flag: &'a AtomicBool) -> Self {
        self.cancel = Some(flag);
        self
    }

    /// Calls `report` about ten times a second and at the end, on the thread that called `run`.
    #[must_use]
    pub fn progress(mut self, report: impl FnMut(Progress) + 'a) -> Self {
        self.progress = Some(Box::new(report));
        self
    }
}

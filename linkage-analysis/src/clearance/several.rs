//! Several members on one shaft, whose phases are sought together.

use super::nearest::Nearest;
use super::phases::Phases;
use super::probe::{Limits, Probe};
use crate::components::Components;
use crate::cyclogram::Slot;
use crate::summary::SummaryError;
use alloc::boxed::Box;
use alloc::vec::Vec;

/// Pairs of members on one shaft, of which `N` can be turned ahead, each by a phase of its own.
///
/// The distance of two members depends on the difference of their phases alone. Each pair is a
/// [`Phases`], with the numbers of the phases that turn its members.
///
/// ```
/// use linkage_analysis::clearance::{PhaseSet, Phases};
/// use std::f64::consts::{PI, TAU};
///
/// // Three cranks of 60 mm beside each other, 100 mm apart; the one between turns against the
/// // others.
/// let crank = |centre: f64, turns: f64| {
///     move |x: f64| {
///         let (sin, cos) = (60.0 * x.sin(), 60.0 * x.cos());
///         [[[centre + cos, turns * sin], [-sin, turns * cos], [-cos, -turns * sin]]]
///     }
/// };
/// let (a, b, c) = (crank(0.0, 1.0), crank(100.0, -1.0), crank(200.0, 1.0));
/// let left = Phases::new((0.0, TAU), 90, a, b)?;
/// let right = Phases::new((0.0, TAU), 90, b, c)?;
/// // The first crank is on the shaft as it is; phase 0 turns the second one, phase 1 the third.
/// let set = PhaseSet::<2, 2>::new().pair(None, Some(0), &left).pair(Some(0), Some(1), &right);
/// let best = set.best([(-PI, PI); 2])?;
/// // They meet in the middle unless they all point to one side at once.
/// assert!((best.distance - 100.0).abs() < 1e-9);
/// assert!(best.phases.iter().all(|phase| phase.abs() < 1e-9));
/// // With gears of 7 and of 9 slots, one step or none.
/// let gears = set.best_step([(-PI, PI); 2], [TAU / 7.0, TAU / 9.0])?;
/// assert_eq!(gears.slots.map(|slot| slot.step), [0, 0]);
/// # Ok::<(), linkage_analysis::clearance::PhaseError>(())
/// ```
pub struct PhaseSet<'a, const K: usize, const N: usize> {
    pub(super) pairs: Vec<TurnedPair<'a, K>>,
}

type At<'a, const K: usize> = Box<dyn Fn(f64) -> Result<Probe<K>, SummaryError> + 'a>;

/// Two members, and the phases that turn them.
pub(super) struct TurnedPair<'a, const K: usize> {
    pub(super) first: Option<usize>,
    pub(super) second: Option<usize>,
    pub(super) limits: Limits,
    pub(super) cycle: f64,
    /// The clearance at a difference of their phases.
    pub(super) at: At<'a, K>,
}

/// The phases at which the least distance of all pairs is largest.
#[derive(Clone, Debug, PartialEq)]
pub struct BestPhases<const K: usize, const N: usize> {
    /// The lead of each member. A member without influence keeps its first phase.
    pub phases: [f64; N],
    /// The least distance over the cycle, of all pairs.
    pub distance: f64,
    /// The places with this distance: one, or several equal ones.
    pub contacts: Vec<PairContact<K, N>>,
    /// No phases of the ranges have a larger least distance than this: at most a thousandth more
    /// than `distance`, or, if that is more, a two-hundredth of the way of the fastest member over
    /// a radian; more than that where too many phases would have to be looked at.
    pub bound: f64,
    /// The number of differences of phases that were evaluated.
    pub probes: usize,
}

/// A place of the cycle where the members of a pair are nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairContact<const K: usize, const N: usize> {
    /// The number of the pair, in the order in which pairs were given.
    pub pair: usize,
    /// The place.
    pub nearest: Nearest<K>,
    /// The derivatives of its distance by the phases.
    pub slopes: [f64; N],
}

/// The best of the phases that gears can be set to.
#[derive(Clone, Debug, PartialEq)]
pub struct BestSteps<const K: usize, const N: usize> {
    /// For each phase the number of steps, their angle, and its excess over the best phase.
    pub slots: [Slot; N],
    /// The least distance over the cycle.
    pub distance: f64,
    /// The loss against the best phases.
    pub loss: f64,
    /// The best phases of all.
    pub best: BestPhases<K, N>,
}

impl<const K: usize, const N: usize> Default for PhaseSet<'_, K, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'a, const K: usize, const N: usize> PhaseSet<'a, K, N> {
    /// Without pairs, which [`pair`](Self::pair) adds.
    #[must_use]
    pub const fn new() -> Self {
        Self { pairs: Vec::new() }
    }

    /// Adds a pair of members, each turned by the phase of this number, or by none.
    ///
    /// # Panics
    ///
    /// If a number is not below `N`.
    #[must_use]
    pub fn pair<V, const A: usize, const B: usize, F, G>(
        mut self,
        first: Option<usize>,
        second: Option<usize>,
        phases: &'a Phases<V, K, A, B, F, G>,
    ) -> Self
    where
        V: Components<K>,
        F: Fn(f64) -> [[V; 3]; A],
        G: Fn(f64) -> [[V; 3]; B],
    {
        for phase in [first, second].into_iter().flatten() {
            assert!(phase < N, "phase {phase} of {N}");
        }
        self.pairs.push(TurnedPair {
            first,
            second,
            limits: phases.limits,
            cycle: phases.width(),
            at: Box::new(|phase| phases.probe(phase)),
        });
        self
    }
}

//! The search of a design problem of a whole cycle.

use linkage_core::Cycle;
use std::boxed::Box;
use std::string::ToString;
use std::vec::Vec;

use super::super::DesignError;
use super::builder::CycleDesign;
use super::found::BestCycle;
use super::part::CyclePart;
use super::searches::{Beginning, Checked, Objectives, Searches};
use linkage_runtime::Dimensions;

impl<M, A, const N: usize> CycleDesign<'_, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Send + Sync,
{
    /// Searches for the best mechanism.
    ///
    /// The result is verified by the assembled mechanism, and not worse than the first mechanism,
    /// if that holds all conditions.
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once; `StartNotWhole` or `NoStart` if the search has nowhere
    /// to begin; `OutOfReach` with the condition that cannot be held, by how much it is missed, and
    /// the bounds that are in the way; `NotWhole` if the optimum does not run through the whole
    /// range on one circuit.
    pub fn run(self) -> Result<BestCycle<M, A>, DesignError> {
        Ok(self.run_all()?.swap_remove(0))
    }

    /// Searches from all starts, with feature `rayon` on all threads, and lists the distinct optima
    /// that hold the conditions, the best first.
    ///
    /// Equal seeds give equal optima on any number of threads, unless time limit or cancellation
    /// end the search.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run); `NotFound`, with the number of starts for each reason of refusal, if
    /// several were begun and none leads to an optimum.
    pub fn run_all(mut self) -> Result<Vec<BestCycle<M, A>>, DesignError> {
        let end = self.settings.end();
        let mut report = self.settings.progress.take();
        let objectives: Vec<_> = self.objectives.iter().map(Box::as_ref).collect();
        let checked = self.checked(&objectives)?;
        let beginning = self.beginning();
        self.searches(&checked, &objectives)
            .searched(&beginning, &end, &mut report)
    }

    /// Makes the descents of a [`part`](Self::part) of the starts, for a search in several
    /// processes: each computes a part, and one of them takes all parts by [`known`](Self::known)
    /// and runs.
    ///
    /// ```
    /// use linkage_design::{BestCycle, CycleDesign, CyclePart, DesignError};
    /// # use linkage_runtime::Dimensions;
    ///
    /// // In each process: a part, as bytes.
    /// type Bytes = Vec<u8>;
    /// type Part = Result<Bytes, DesignError>;
    /// fn part<M, A, const N: usize>(problem: CycleDesign<'_, M, A, N>, k: usize, of: usize) -> Part
    /// # where M: Dimensions<N> + Copy + Send + Sync, A: Send + Sync
    /// {
    ///     Ok(problem.part(k, of).descend()?.to_bytes())
    /// }
    ///
    /// // In one of them: the optima, as of one search.
    /// type Found<M, A> = Result<Vec<BestCycle<M, A>>, DesignError>;
    /// fn whole<M, A, const N: usize>(problem: CycleDesign<'_, M, A, N>, parts: &[Bytes]) -> Found<M, A>
    /// # where M: Dimensions<N> + Copy + Send + Sync, A: Send + Sync
    /// {
    ///     let mut problem = problem;
    ///     for part in parts {
    ///         problem = problem.known(CyclePart::read(part)?);
    ///     }
    ///     problem.run_all()
    /// }
    /// ```
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once.
    pub fn descend(mut self) -> Result<CyclePart, DesignError> {
        let end = self.settings.end();
        let mut report = self.settings.progress.take();
        let objectives: Vec<_> = self.objectives.iter().map(Box::as_ref).collect();
        let checked = self.checked(&objectives)?;
        let beginning = self.beginning();
        self.searches(&checked, &objectives)
            .descended(&beginning, &end, &mut report)
    }

    /// The searches of a checked problem.
    pub(super) fn searches<'s>(
        &'s self,
        checked: &'s Checked<A>,
        objectives: &'s Objectives<'s, M, A, N>,
    ) -> Searches<'s, 's, M, A, N> {
        Searches {
            design: self,
            checked,
            objectives,
        }
    }

    fn beginning(&self) -> Beginning<'_, M> {
        Beginning {
            first: &self.nominal,
            starts: self.settings.starts.max(1),
            widening: true,
            part: self.part,
            known: &self.known,
        }
    }

    /// Returns the variables with their limits, and all assemblies of the first mechanism; or all
    /// mistakes.
    pub(super) fn checked(
        &self,
        objectives: &Objectives<'_, M, A, N>,
    ) -> Result<Checked<A>, DesignError> {
        let circuits = (self.circuits)(&self.nominal).map_err(DesignError::Start)?;
        let cycle: &Cycle = &circuits.cycle;
        let mut varied = self.freedom.varied(M::PARAMETERS, &self.nominal.values());
        let mut errors = core::mem::take(&mut varied.errors);
        let goals = objectives.iter().filter(|objective| objective.is_goal());
        let goals: Vec<_> = goals.map(|objective| objective.title()).collect();
        if goals.len() != 1 {
            errors.push(DesignError::Goals { goals });
        }
        let [part, of] = self.part;
        if part >= of {
            errors.push(DesignError::Part { part, of });
        }
        if self.positions < 2 {
            let what = "less than two positions";
            errors.push(DesignError::Nothing {
                what,
                objective: "a design problem".to_string(),
            });
        }
        for objective in objectives {
            errors.extend(objective.check(cycle, M::PARAMETERS, &varied.indices));
        }
        DesignError::all(errors)?;
        let names = varied.indices.iter().map(|&k| M::PARAMETERS[k].name);
        let names: Vec<_> = names.collect();
        self.freedom.consistent(&varied.limits, &names)?;
        Ok(Checked { varied, circuits })
    }
}

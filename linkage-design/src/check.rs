//! Checks of a design problem, all at once.

use std::string::ToString;
use std::vec::Vec;

use super::DesignError;
use super::builder::Design;
use super::problem::{Given, Problem};
use super::varied::Varied;
use linkage_runtime::DimensionSet;

impl<M, A, const N: usize> Design<'_, M, A, N>
where
    M: DimensionSet<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// The problem with names looked up, or all mistakes in it.
    pub(super) fn problem(&self) -> Result<Problem<'_, M, A, N>, DesignError> {
        let (values, parameters) = (self.nominal.numbers(), self.nominal.declared());
        let Varied {
            indices: varied,
            limits,
            catalogues,
            mut errors,
        } = self.freedom.varied(parameters, &values);
        let cycle = (self.circuits)(&self.nominal)
            .map_err(DesignError::Start)?
            .cycle;
        let nothing = |what| DesignError::Nothing {
            what,
            objective: "a design problem".to_string(),
        };
        if self.objectives.is_empty() {
            errors.push(nothing("nothing is wanted; call `want`"));
        }
        if self.settings.starts == 0 {
            errors.push(nothing("no starts"));
        }
        let [part, of] = self.part;
        if part >= of {
            errors.push(DesignError::Part { part, of });
        }
        for objective in &self.objectives {
            errors.extend(objective.check(&cycle, parameters, &varied));
        }
        DesignError::all(errors)?;
        let names = varied.iter().map(|&k| parameters[k].name);
        let names: Vec<_> = names.collect();
        self.freedom.consistent(&limits, &names)?;
        let free = self
            .objectives
            .iter()
            .map(|objective| objective.free(&cycle))
            .collect();
        let problem = Problem::new(
            Given {
                nominal: self.nominal,
                varied,
                limits,
                catalogues,
                cycle,
            },
            &self.objectives,
            free,
        );
        Ok(problem.measured(&self.assemblies, self.settings.seed))
    }
}

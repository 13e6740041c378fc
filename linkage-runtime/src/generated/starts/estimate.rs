//! Groups whose solutions cannot be listed: the one to which the estimates lead.

use super::group::CoupledGroup;
use super::solve::{CoupledPrograms, CoupledSolution};
use crate::error::{AssemblyError, CoupledCause};
use linkage_core::numeric::continuation::{Astray, from_estimate};
use linkage_core::numeric::roots::Unlisted;

impl CoupledGroup {
    /// Whether its assembly is followed from the estimates, since its solutions cannot be listed.
    pub(crate) fn is_followed(&self) -> bool {
        self.terms.is_empty()
    }

    /// What cannot be said of such a group.
    pub(crate) fn not_listed(&self) -> AssemblyError {
        self.error(CoupledCause::NotListed(Unlisted::Followed))
    }

    /// The solution to which the estimates lead.
    pub(super) fn followed(
        &self,
        programs: &mut dyn CoupledPrograms,
        x: &[f64],
    ) -> Result<CoupledSolution, AssemblyError> {
        let estimate = programs.estimate(x);
        match from_estimate(programs, self.variables, x, &estimate) {
            Ok(state) => Ok(self.solution(programs, x, state)),
            Err(Astray::DeadPoint { left, .. }) => {
                let reach = self.reach(programs, x, estimate);
                Err(self.error(CoupledCause::NotReached { left, reach }))
            }
            Err(Astray::Movable(_) | Astray::Singular(_)) => {
                Err(self.error(CoupledCause::Singular))
            }
            Err(Astray::NoValue) => Err(self.undefined()),
        }
    }
}

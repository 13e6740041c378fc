//! Groups whose solutions cannot be listed: the one to which the estimates lead.

use super::closest_approach::closest_approach;
use super::group::CoupledGroup;
use super::programs::CoupledPrograms;
use super::solution::{CoupledSolution, solution};
use crate::error::{AssemblyError, CoupledCause};
use linkage_core::numeric::continuation::{Astray, from_estimate};

/// The solution to which the estimates lead.
pub(super) fn followed(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
) -> Result<CoupledSolution, AssemblyError> {
    let estimate = programs.estimate(x);
    match from_estimate(programs, group.variables, x, &estimate) {
        Ok(state) => Ok(solution(group, programs, x, state)),
        Err(Astray::DeadPoint { left, .. }) => {
            let closest_approach = closest_approach(group, programs, x, estimate);
            Err(group.error(CoupledCause::NotReached {
                left,
                closest_approach,
            }))
        }
        Err(Astray::Movable(_) | Astray::Singular(_)) => Err(group.error(CoupledCause::Singular)),
        Err(Astray::NoValue) => Err(group.undefined()),
    }
}

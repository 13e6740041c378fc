//! The assembly of a group at the reference inputs: all solutions are listed, the one nearest to the start estimates is
//! taken.

use super::group::{CoupledGroup, CoupledInput, CoupledUnknown};
use crate::numeric::choose_assembly::{Ambiguity, choose_assembly, may_be_meant};
use crate::numeric::continuation::{LeftOut, Refusal, Residuals, meeting_states, states};
use crate::numeric::roots::{Listing, System, Unlisted, solve};
use crate::{AssemblyError, CoupledCause, CoupledError, Placed, Scalar, Value};
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use linkage_core::math;

/// The programs of a group.
pub trait CoupledPrograms: Residuals {
    /// The coefficients of the polynomial system at the inputs `x`, real and imaginary part.
    fn system(&mut self, x: &[f64]) -> Vec<[f64; 2]>;

    /// The unknowns with start estimates: cosine and sine of an angle; a length, and the factor that brings it to the size of the
    /// default mechanism, for which the estimates are.
    fn placed(&mut self, x: &[f64], state: &[f64]) -> Vec<[f64; 2]>;

    /// The state where the unknowns are estimated, of a group that is followed from there.
    fn estimate(&mut self, _x: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// The left sides of the loops without the right ones in a state, by component, of a group that is followed; then those of the loops that
    /// make its bodies rigid.
    fn missed(&mut self, _x: &[f64], _state: &[f64]) -> Vec<f64> {
        Vec::new()
    }
}

/// A real solution of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledSolution {
    /// Its state.
    pub state: Vec<f64>,
    /// The unknowns with start estimates: angles from -pi to pi, lengths.
    pub values: Vec<f64>,
    /// How far it is from the estimates.
    pub distance: f64,
}

impl CoupledInput {
    fn value(&self, value: f64) -> Value {
        Value {
            name: self.name,
            value,
            unit: self.unit,
            angle: self.range.turn,
        }
    }
}

impl CoupledGroup {
    pub(super) fn error(&self, cause: CoupledCause) -> AssemblyError {
        AssemblyError::Coupled(Box::new(CoupledError {
            mechanism: self.mechanism,
            group: self.group,
            kind: self.kind,
            loops: self.loops,
            unknowns: self.names,
            cause,
        }))
    }

    pub(super) fn undefined(&self) -> AssemblyError {
        AssemblyError::Undefined {
            mechanism: self.mechanism,
            group: self.group,
            kind: self.kind,
            loops: self.loops,
            unknowns: self.names,
        }
    }

    pub(super) fn leaves_out(&self, left_out: &LeftOut) -> AssemblyError {
        self.error(CoupledCause::LeavesOut {
            share: left_out.share,
            example: self.position(&left_out.at),
        })
    }

    pub(super) fn beside_dead_point(&self, x: &[f64]) -> AssemblyError {
        self.error(CoupledCause::BesideDeadPoint(self.position(x)))
    }

    fn position(&self, x: &[f64]) -> Placed {
        let pairs = self.inputs.iter().zip(x);
        Placed(pairs.map(|(input, &at)| input.value(at)).collect())
    }

    pub(super) fn refused(&self, refusal: Refusal) -> AssemblyError {
        let value = |at| match self.inputs {
            [first, ..] => first.value(at),
            [] => Value {
                name: "the input",
                value: at,
                unit: "",
                angle: false,
            },
        };
        match refusal {
            Refusal::TurningPoint { at } => self.error(CoupledCause::DeadPoint(value(at))),
            Refusal::NotConverging { at } => self.error(CoupledCause::NotFollowed(value(at))),
            Refusal::NotASolution => self.error(CoupledCause::Singular),
            Refusal::NotFinite => self.undefined(),
        }
    }

    fn listed(&self, coefficients: &[[f64; 2]]) -> Result<Listing, AssemblyError> {
        let system = System {
            variables: self.variables,
            terms: self.terms,
        };
        solve(&system, coefficients).map_err(|why| match why {
            Unlisted::NotFinite => self.undefined(),
            why => self.error(CoupledCause::NotListed(why)),
        })
    }

    /// The real solutions of a listing, the nearest to the estimates first.
    fn solutions(
        &self,
        listing: &Listing,
        programs: &mut dyn CoupledPrograms,
        x: &[f64],
    ) -> Result<Vec<CoupledSolution>, AssemblyError> {
        let mut solutions: Vec<CoupledSolution> = states(self.variables, listing, x, programs)
            .into_iter()
            .map(|state| self.solution(programs, x, state))
            .filter(|solution| solution.distance.is_finite())
            .collect();
        if solutions.is_empty() {
            let complex = listing.complex;
            return Err(self.error(CoupledCause::NoneReal { complex }));
        }
        solutions.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        Ok(solutions)
    }

    pub(super) fn solution(
        &self,
        programs: &mut dyn CoupledPrograms,
        x: &[f64],
        state: Vec<f64>,
    ) -> CoupledSolution {
        let placed = programs.placed(x, &state);
        let value = |(unknown, &[a, b]): (&CoupledUnknown, &[f64; 2])| {
            if unknown.angle {
                Scalar::atan2(b, a)
            } else {
                a
            }
        };
        let values: Vec<f64> = self.unknowns.iter().zip(&placed).map(value).collect();
        CoupledSolution {
            state,
            distance: self.distance(&values, &placed),
            values,
        }
    }

    fn distance(&self, values: &[f64], placed: &[[f64; 2]]) -> f64 {
        let square = |((unknown, value), [_, size]): ((&CoupledUnknown, &f64), &[f64; 2])| {
            let off = if unknown.angle {
                // Adding and subtracting 1.5 * 2^52 rounds to an integer.
                const ROUND: f64 = 6_755_399_441_055_744.0;
                let off = value - unknown.estimate;
                off - TAU * ((off / TAU + ROUND) - ROUND)
            } else {
                value * size - unknown.estimate
            };
            let off = off / unknown.scale;
            off * off
        };
        math::double::sqrt(
            self.unknowns
                .iter()
                .zip(values)
                .zip(placed)
                .map(square)
                .sum(),
        )
    }

    fn placed(&self, values: &[f64]) -> Placed {
        let value = |(unknown, &value): (&CoupledUnknown, &f64)| Value {
            name: unknown.name,
            value,
            unit: unknown.unit,
            angle: unknown.angle,
        };
        Placed(self.unknowns.iter().zip(values).map(value).collect())
    }
}

/// All real solutions at the inputs `x`, the nearest to the estimates first; of a group that is followed the one to which these lead.
///
/// # Errors
///
/// If the solutions cannot be listed, or none is real.
pub fn list(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
) -> Result<Vec<CoupledSolution>, AssemblyError> {
    if group.is_followed() {
        return group.followed(programs, x).map(|found| vec![found]);
    }
    let listing = group.listed(&programs.system(x))?;
    group.solutions(&listing, programs, x)
}

/// The solution at the inputs `x` that is nearest to the estimates, or to which they lead.
///
/// # Errors
///
/// If the solutions cannot be listed, none is real, two are equally near, or two meet at a turning point; if the estimates lead nowhere.
pub fn couple(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
) -> Result<CoupledSolution, AssemblyError> {
    if group.is_followed() {
        return group.followed(programs, x);
    }
    let listing = group.listed(&programs.system(x))?;
    let listed = group.solutions(&listing, programs, x);
    let nearest_one = listed.as_ref().map_or(f64::INFINITY, |all| all[0].distance);
    let meeting = meeting_states(group.variables, &listing).into_iter();
    let mut meeting = meeting.map(|state| group.solution(programs, x, state).distance);
    if meeting.any(|other| may_be_meant(other, nearest_one, Ambiguity::AT_RUN_TIME)) {
        return Err(group.error(CoupledCause::Singular));
    }
    let mut solutions = listed?;
    let distances = solutions.iter().map(|one| one.distance);
    let chosen = choose_assembly(distances, Ambiguity::AT_RUN_TIME);
    if chosen.is_some_and(|chosen| chosen.ambiguous) {
        let assemblies = solutions.iter().map(|one| group.placed(&one.values));
        return Err(group.error(CoupledCause::Ambiguous {
            assemblies: assemblies.collect(),
        }));
    }
    Ok(solutions.swap_remove(0))
}

//! Assembling in given modes from given initial states.

use super::close::{close, explained, finite};
use super::compiled::Compiled;
use super::preparation::{lane_inputs, prepared};
use super::winding::{at_estimates, by_lane, wind};
use crate::error::AssemblyError;
use crate::support::assembly_data::{AssemblyData, Core};

/// The assembly of a mechanism without coupled groups that the start estimates choose.
///
/// # Errors
///
/// As `assemble()` of generated code.
pub fn assemble<C: Compiled<States = (), Plain: Compiled<States = ()>>>(
    mechanism: &C,
) -> Result<C::Assembly, AssemblyError> {
    let at = mechanism.reference();
    finite(mechanism)?;
    with_states(mechanism, mechanism.default_modes(), &at, (), |_| ())
        .map_err(|error| explained(error, mechanism))
}

/// The assembly with these initial states of coupled groups; `lane_states` are those of one lane.
///
/// # Errors
///
/// Where a group does not close, or an angle cannot be followed.
pub(super) fn with_states<C: Compiled>(
    mechanism: &C,
    modes: C::Modes,
    at: &C::Inputs,
    states: C::States,
    lane_states: impl Fn(usize) -> <C::Plain as Compiled>::States,
) -> Result<C::Assembly, AssemblyError> {
    let angles = mechanism.description().angles.len();
    let found = by_lane(mechanism, |lane| {
        let (plain, states) = (mechanism.lane(lane), lane_states(lane));
        wind(&plain, &modes, &states, angles, &lane_inputs::<C>(at, lane))
    });
    let (revolutions, unknown) = match found {
        Ok(revolutions) => (revolutions, None),
        // If a loop does not close, the error is about that loop.
        Err(unknown) => (at_estimates(mechanism), Some(unknown)),
    };
    let prepared = prepared(mechanism, &modes, &revolutions);
    check_gaps(
        mechanism,
        &modes,
        &prepared,
        mechanism.arguments(&states, at),
    )?;
    match unknown {
        None => {
            let core = Core {
                dimensions: mechanism.clone(),
                modes,
                revolutions,
                prepared,
            };
            Ok(C::assembly(AssemblyData::new(core, states)))
        }
        Some(unknown) => Err(AssemblyError::NoWinding {
            mechanism: mechanism.description().name,
            unknown,
        }),
    }
}

/// Fails at the first group that does not close.
pub(super) fn check_gaps<C: Compiled>(
    mechanism: &C,
    modes: &C::Modes,
    prepared: &C::Prepared,
    x: C::Arguments,
) -> Result<(), AssemblyError> {
    let gaps = mechanism.gaps(modes, prepared, x);
    close(mechanism.description(), gaps.as_ref())
}

//! Reasons for which an assembly is refused: dimensions that are not finite numbers, groups that do
//! not close.

use linkage_core::Scalar;

use super::compiled::Compiled;
use super::description::Description;
use crate::error::{AssemblyError, GroupRef, LARGEST};

/// Fails at a dimension that is NaN or infinite, since closed forms without a root carry it into
/// the results without a trace. Only dimensions that groups need count.
pub(super) fn finite<C: Compiled>(mechanism: &C) -> Result<(), AssemblyError> {
    all_finite(mechanism.description(), mechanism.dimensions().as_ref())
}

/// One function for all mechanisms: their code is compiled often enough.
fn all_finite<T: Scalar>(description: &Description, values: &[T]) -> Result<(), AssemblyError> {
    let Description {
        name,
        parameters,
        needed,
        ..
    } = *description;
    for &parameter in needed {
        for lane in 0..T::LANES {
            let value = values[parameter].lane(lane);
            if !value.is_finite() {
                return Err(AssemblyError::NotFinite {
                    mechanism: name,
                    dimension: parameters[parameter].name,
                    value,
                });
            }
        }
    }
    Ok(())
}

/// Fails at the first group that does not close: in one lane its gap is positive or not a number.
pub(super) fn close<T: Scalar>(description: &Description, gaps: &[T]) -> Result<(), AssemblyError> {
    let group = |index| GroupRef::new(description.name, index, &description.groups[index]);
    for (index, gap) in gaps.iter().enumerate() {
        let mut miss = 0.0;
        for lane in 0..T::LANES {
            let gap = gap.lane(lane);
            if gap.is_nan() {
                let group = group(index);
                return Err(AssemblyError::Undefined { group });
            }
            miss = f64::max(miss, gap);
        }
        if miss > 0.0 {
            return Err(AssemblyError::CannotClose {
                group: group(index),
                miss,
                unit: description.gap_units[index],
            });
        }
    }
    Ok(())
}

/// The error of an assembly, which about no loop but about a dimension that is too large names the
/// dimension. Those that a loop needs are finite.
pub(super) fn explained<C: Compiled>(error: AssemblyError, mechanism: &C) -> AssemblyError {
    explained_by(
        mechanism.description(),
        mechanism.dimensions().as_ref(),
        error,
    )
}

/// One function for all mechanisms: their code is compiled often enough.
fn explained_by<T: Scalar>(
    description: &Description,
    values: &[T],
    error: AssemblyError,
) -> AssemblyError {
    match error {
        AssemblyError::Undefined { .. } => too_large(description, values).unwrap_or(error),
        _ => error,
    }
}

/// One function for all mechanisms: their code is compiled often enough.
fn too_large<T: Scalar>(description: &Description, values: &[T]) -> Option<AssemblyError> {
    let size = |value: f64| if value < 0.0 { -value } else { value };
    let mut largest = None;
    for (parameter, lanes) in description.parameters.iter().zip(values) {
        for lane in 0..T::LANES {
            let value = lanes.lane(lane);
            let larger = largest.is_none_or(|(_, known)| size(value) > size(known));
            if value.is_finite() && larger {
                largest = Some((parameter, value));
            }
        }
    }
    let (parameter, value) = largest?;
    (size(value) > LARGEST).then_some(AssemblyError::Overflow {
        mechanism: description.name,
        dimension: parameter.name,
        value,
        unit: parameter.unit,
    })
}

//! Reasons for which an assembly is refused: dimensions that are not finite numbers, groups that do
//! not close.

use linkage_core::Scalar;

use super::compiled::Compiled;
use super::description::Description;
use crate::data::Parameter;
use crate::error::{AssemblyError, GroupRef, LARGEST};

/// Fails at a dimension that is NaN or infinite, since closed forms without a root carry it into
/// the results without a trace. Only dimensions that groups need count.
pub(super) fn finite<C: Compiled>(mechanism: &C) -> Result<(), AssemblyError> {
    let Description {
        name,
        parameters,
        needed,
        ..
    } = *mechanism.description();
    let values = mechanism.dimensions();
    for &parameter in needed {
        let value = values.as_ref()[parameter];
        let mut lanes = (0..C::Scalar::LANES).map(|lane| value.lane(lane));
        if let Some(value) = lanes.find(|value| !value.is_finite()) {
            return Err(AssemblyError::NotFinite {
                mechanism: name,
                dimension: parameters[parameter].name,
                value,
            });
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

/// A result of assembling, in which an error about no loop but about a dimension, which is too
/// large, names the dimension. Those that a loop needs are finite.
pub(super) fn explained<A, C: Compiled>(
    result: Result<A, AssemblyError>,
    mechanism: &C,
) -> Result<A, AssemblyError> {
    let Err(AssemblyError::Undefined { group }) = result else {
        return result;
    };
    let (values, parameters) = (mechanism.dimensions(), mechanism.description().parameters);
    let values = values.as_ref();
    let mut lanes =
        (0..values.len()).flat_map(|k| (0..C::Scalar::LANES).map(move |lane| (k, lane)));
    let mut dimensions = core::iter::from_fn(|| {
        let (k, lane) = lanes.next()?;
        Some((&parameters[k], values[k].lane(lane)))
    });
    match too_large(group.mechanism, &mut dimensions) {
        Some(error) => Err(error),
        None => result,
    }
}

/// One function for all mechanisms: their code is compiled often enough.
fn too_large(
    mechanism: &'static str,
    dimensions: &mut dyn Iterator<Item = (&'static Parameter, f64)>,
) -> Option<AssemblyError> {
    let size = |value: f64| if value < 0.0 { -value } else { value };
    let finite = dimensions.filter(|(_, value)| value.is_finite());
    let largest = finite.reduce(|a, b| if size(b.1) > size(a.1) { b } else { a });
    let (parameter, value) = largest?;
    (size(value) > LARGEST).then_some(AssemblyError::Overflow {
        mechanism,
        dimension: parameter.name,
        value,
        unit: parameter.unit,
    })
}

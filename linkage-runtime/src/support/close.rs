//! Checks of the gaps of groups for `assemble()` and `assemblies()` of generated code.

#[cfg(feature = "alloc")]
use crate::data::AssemblyMode;
use crate::data::Parameter;
use crate::error::{AssemblyError, GroupRef, LARGEST};
use crate::structure::Group;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use linkage_core::Scalar;

/// Fails at a dimension that is NaN or infinite, since closed forms without a root carry it into
/// the results without a trace. `needed` are the parameters that the groups need, in the order of
/// the groups, as indices of `values`.
pub fn finite<T: Scalar>(
    mechanism: &'static str,
    parameters: &'static [Parameter],
    needed: &[usize],
    values: &[T],
) -> Result<(), AssemblyError> {
    for &parameter in needed {
        let mut lanes = (0..T::LANES).map(|lane| values[parameter].lane(lane));
        if let Some(value) = lanes.find(|value| !value.is_finite()) {
            return Err(AssemblyError::NotFinite {
                mechanism,
                dimension: parameters[parameter].name,
                value,
            });
        }
    }
    Ok(())
}

/// Fails at the first group that does not close: in one lane its gap is positive or not a number.
/// `units` are the units of the gaps.
pub fn close<T: Scalar>(
    mechanism: &'static str,
    groups: &'static [Group],
    units: &[&'static str],
    gaps: &[T],
) -> Result<(), AssemblyError> {
    for (index, gap) in gaps.iter().enumerate() {
        let mut miss = 0.0;
        for lane in 0..T::LANES {
            let gap = gap.lane(lane);
            if gap.is_nan() {
                let group = GroupRef::new(mechanism, index, &groups[index]);
                return Err(AssemblyError::Undefined { group });
            }
            miss = f64::max(miss, gap);
        }
        if miss > 0.0 {
            return Err(AssemblyError::CannotClose {
                group: GroupRef::new(mechanism, index, &groups[index]),
                miss,
                unit: units[index],
            });
        }
    }
    Ok(())
}

/// An error that is about no loop but about a dimension, which is too large. `values` gives the
/// dimensions in the order of `parameters`; those that a loop needs are finite.
pub fn explained<A, T: Scalar, const P: usize>(
    result: Result<A, AssemblyError>,
    parameters: &'static [Parameter],
    values: impl Fn() -> [T; P],
) -> Result<A, AssemblyError> {
    match result {
        Err(AssemblyError::Undefined { .. }) => explained_by(result, parameters, &values()),
        _ => result,
    }
}

/// As [`explained`], with the dimensions as a slice.
pub fn explained_by<A, T: Scalar>(
    result: Result<A, AssemblyError>,
    parameters: &'static [Parameter],
    values: &[T],
) -> Result<A, AssemblyError> {
    let Err(AssemblyError::Undefined { group }) = result else {
        return result;
    };
    let mut lanes = (0..values.len()).flat_map(|k| (0..T::LANES).map(move |lane| (k, lane)));
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

/// A list of one.
#[cfg(feature = "alloc")]
pub fn one<A>(only: A) -> Vec<A> {
    Vec::from([only])
}

/// More modes than this are not listed.
#[cfg(feature = "alloc")]
const MOST_MODES: usize = 16;

/// Every assembly that closes, the default modes first; `assemble` gives all with some modes. An
/// error that is not about a loop that cannot close is returned if nothing closes.
#[cfg(feature = "alloc")]
pub fn assemblies<A, M: AsRef<[AssemblyMode]> + AsMut<[AssemblyMode]> + Clone>(
    mechanism: &'static str,
    default: M,
    assemble: impl Fn(M) -> Result<Vec<A>, AssemblyError>,
) -> Result<Vec<A>, AssemblyError> {
    let count = default.as_ref().len();
    if count > MOST_MODES {
        return Err(AssemblyError::TooManyAssemblies {
            mechanism,
            modes: count,
        });
    }
    let mut found = Vec::new();
    let mut failure = None;
    for flips in 0..1_u32 << count {
        let mut modes = default.clone();
        for (number, mode) in modes.as_mut().iter_mut().enumerate() {
            if flips >> number & 1 == 1 {
                *mode = mode.flipped();
            }
        }
        match assemble(modes) {
            Ok(assemblies) => found.extend(assemblies),
            Err(error) if error.is_a_miss() => {}
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    match failure {
        Some(error) if found.is_empty() => Err(error),
        _ => Ok(found),
    }
}

//! What `assemble()` and `assemblies()` of generated code do with the gaps of the groups.

#[cfg(feature = "alloc")]
use crate::AssemblyMode;
use crate::{AssemblyError, Group, Parameter, Scalar};
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// Fails at the first group that needs a dimension that is NaN or infinite: closed forms without a root carry it into the results, where
/// nothing tells it apart. `needed` are the parameters that each group needs and none before it, by their places among `values`.
pub fn finite<T: Scalar>(
    mechanism: &'static str,
    groups: &'static [Group],
    parameters: &'static [Parameter],
    needed: &[&[usize]],
    values: &[T],
) -> Result<(), AssemblyError> {
    for (index, needed) in needed.iter().enumerate() {
        let is_finite = |place: usize| (0..T::LANES).all(|k| values[place].lane(k).is_finite());
        let Some(&place) = needed.iter().find(|&&place| !is_finite(place)) else {
            continue;
        };
        let Group {
            kind,
            loops,
            unknowns,
            ..
        } = groups[index];
        return Err(AssemblyError::NotFinite {
            mechanism,
            group: index,
            kind,
            loops,
            unknowns,
            field: Some(parameters[place].name),
        });
    }
    Ok(())
}

/// Fails at the first group that does not close: in one lane its gap is positive or not a number. `units` says what
/// each gap is measured in.
pub fn close<T: Scalar>(
    mechanism: &'static str,
    groups: &'static [Group],
    units: &[&'static str],
    gaps: &[T],
) -> Result<(), AssemblyError> {
    for (index, gap) in gaps.iter().enumerate() {
        let Group {
            kind,
            loops,
            unknowns,
            ..
        } = groups[index];
        let mut miss = 0.0;
        for lane in 0..T::LANES {
            let gap = gap.lane(lane);
            if gap.is_nan() {
                return Err(AssemblyError::NotFinite {
                    mechanism,
                    group: index,
                    kind,
                    loops,
                    unknowns,
                    field: None,
                });
            }
            miss = f64::max(miss, gap);
        }
        if miss > 0.0 {
            let unit = units[index];
            return Err(AssemblyError::CannotClose {
                mechanism,
                group: index,
                kind,
                loops,
                unknowns,
                miss,
                unit,
            });
        }
    }
    Ok(())
}

/// A list of one.
#[cfg(feature = "alloc")]
pub fn one<A>(only: A) -> Vec<A> {
    Vec::from([only])
}

/// More modes than this are not listed.
#[cfg(feature = "alloc")]
const MOST_MODES: usize = 16;

/// Every assembly that closes, the default modes first; `assemble` gives all with some modes. An error that is not about a loop that
/// cannot close is returned if nothing closes.
#[cfg(feature = "alloc")]
pub fn assemblies<A, const MODES: usize>(
    mechanism: &'static str,
    default: [AssemblyMode; MODES],
    assemble: impl Fn([AssemblyMode; MODES]) -> Result<Vec<A>, AssemblyError>,
) -> Result<Vec<A>, AssemblyError> {
    if MODES > MOST_MODES {
        return Err(AssemblyError::TooManyAssemblies {
            mechanism,
            modes: MODES,
        });
    }
    let mut found = Vec::new();
    let mut failure = None;
    for flips in 0..1_u32 << MODES {
        let modes = core::array::from_fn(|mode| match flips >> mode & 1 {
            0 => default[mode],
            _ => default[mode].flipped(),
        });
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

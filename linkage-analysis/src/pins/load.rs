//! The load of a pin from the reactions over a cycle.

use super::error::PinError;
use crate::components::{Components, norm};

/// The largest reaction of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Largest {
    /// Its size: the load of the pin.
    pub load: f64,
    /// The position at which it occurs, counted from 0; the first of several.
    pub position: usize,
}

/// The largest of the reactions: the load of the joint's pin.
///
/// Reactions are vectors, arrays of up to three components, or numbers (a normal force). The peak
/// between two positions is not seen: choose them densely enough.
///
/// # Errors
///
/// `NoReactions` for an empty cycle, `NotFinite` where a reaction is NaN or infinite.
///
/// ```
/// use linkage_analysis::pins::largest_load;
///
/// let largest = largest_load([[3.0, 0.0], [-3.0, 4.0], [1.0, 1.0]])?;
/// assert!(largest.load == 5.0 && largest.position == 1);
/// # Ok::<(), linkage_analysis::pins::PinError>(())
/// ```
pub fn largest_load<V, const K: usize>(
    reactions: impl IntoIterator<Item = V>,
) -> Result<Largest, PinError>
where
    V: Components<K>,
{
    let mut largest: Option<Largest> = None;
    for (position, reaction) in reactions.into_iter().enumerate() {
        let load = norm(&reaction.components());
        if !load.is_finite() {
            return Err(PinError::NotFinite { position });
        }
        if largest.is_none_or(|so_far| load > so_far.load) {
            largest = Some(Largest { load, position });
        }
    }
    largest.ok_or(PinError::NoReactions)
}

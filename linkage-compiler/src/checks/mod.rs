//! Checks of a mechanism by its declared dimensions, before any loop is solved.

mod directions;
mod follower_names;
mod motion_laws;
mod negative_lengths;
mod unused;
mod values;

use crate::algebra::{Names, Nominal};
use crate::diagnostic::Reporter;

pub(crate) use follower_names::check_names_of_follower;
pub(crate) use values::without_value;

/// Evaluates the dimensions as declared and reports directions, motion laws and values that
/// cannot be used, and dimensions that are not used.
///
/// Returns `None` if a direction has no length: everything computed with it would be reported as
/// not finite.
pub(crate) fn dimensions(names: &mut Names, reporter: &mut Reporter) -> Option<Nominal> {
    let mechanism = names.mechanism;
    let nominal = Nominal::from_mechanism(names);
    let before = reporter.errors();
    directions::check_directions(mechanism, &nominal, reporter);
    if reporter.errors() > before {
        return None;
    }
    nominal.check(mechanism, reporter);
    motion_laws::check_motion_laws(mechanism, &nominal, reporter);
    if reporter.errors() == before {
        values::check_values(mechanism, &nominal, reporter);
    }
    negative_lengths::warn_of_negative_lengths(mechanism, &nominal, reporter);
    unused::warn_of_unused(mechanism, &nominal, reporter);
    Some(nominal)
}

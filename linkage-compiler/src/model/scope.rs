//! Everything that is read when an expression is resolved.

use super::assumed_units::AssumedUnits;
use super::member_names::MemberNames;
use super::names::Names;
use super::part::Parts;
use super::values::Values;

/// Names and facts known so far. Expressions read it, items of the struct block change it.
pub(super) struct Scope {
    pub(super) names: Names,
    pub(super) parts: Parts,
    pub(super) members: MemberNames,
    pub(super) values: Values,
    pub(super) units: AssumedUnits,
}

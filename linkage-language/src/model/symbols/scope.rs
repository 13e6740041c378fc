//! Everything that is read when an expression is resolved.

use super::assumed_units::AssumedUnits;
use super::declared_names::Names;
use super::member_names::MemberNames;
use super::part_scopes::Parts;
use super::values::Values;

/// Names and facts known so far. Expressions read it, items of the struct block change it.
pub(in crate::model) struct Scope {
    pub(in crate::model) names: Names,
    pub(in crate::model) parts: Parts,
    pub(in crate::model) members: MemberNames,
    pub(in crate::model) values: Values,
    pub(in crate::model) units: AssumedUnits,
}

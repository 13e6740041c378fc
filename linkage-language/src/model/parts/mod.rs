//! Parts: content of a mechanism within another one, and the expressions that it is given.

pub(super) mod embed;
pub(super) mod embed_bodies;
pub(super) mod item;
pub(super) mod leaves;
pub(super) mod lets;
pub(super) mod location;
pub(super) mod rates;
pub(super) mod slopes;

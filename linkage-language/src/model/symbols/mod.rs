//! Names and facts that expressions are resolved with, and the sink for messages.

pub(super) mod assumed_units;
pub(super) mod declared_names;
pub(super) mod frame_kind;
pub(super) mod member_names;
pub(super) mod operands;
pub(super) mod part_frame;
pub(super) mod part_scopes;
pub(super) mod scope;
pub(super) mod sink;
pub(super) mod site;
pub(super) mod values;
pub(super) mod zeros;

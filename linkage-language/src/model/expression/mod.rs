//! Expressions: names, types, units.

pub(super) mod agreement;
pub(super) mod argument_types;
pub(super) mod argument_use;
pub(super) mod bare_numbers;
pub(super) mod call_messages;
pub(super) mod clause_values;
pub(super) mod composite;
pub(super) mod fitting;
pub(super) mod frame_functions;
pub(super) mod frame_items;
pub(super) mod frame_parts;
pub(super) mod function_types;
pub(super) mod hidden_unit;
pub(super) mod link_messages;
pub(super) mod literal;
pub(super) mod look_up;
pub(super) mod members;
pub(super) mod missing_units;
pub(super) mod nodes;
pub(super) mod operators;
pub(super) mod part_member;
pub(super) mod part_messages;
pub(super) mod plane_and_space;
pub(super) mod products;
pub(super) mod refused_names;

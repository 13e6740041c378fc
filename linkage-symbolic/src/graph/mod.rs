//! The graph: a flat arena of operations.
//!
//! From the ground up: `binding` and `node` are the data, `marks` and `node_numbers` are tables of
//! nodes, `vectors` remembers facts about vectors, `store` is the arena, `terms` recognises forms of
//! operands, `shared` is the arena behind a shared reference, and `definitions` leads from symbols
//! to their definitions. Constructors that simplify are in [`rules`](crate::rules).

mod binding;
mod definitions;
mod marks;
mod node;
mod node_numbers;
mod shared;
mod store;
mod terms;
mod vectors;

pub use binding::{Binding, Source};
pub(crate) use definitions::meaning;
pub use node::{Node, NodeId, Symbol, SymbolId};
pub(crate) use node_numbers::NodeNumbers;
pub use shared::{Graph, Snapshot};
pub(crate) use store::Store;
pub(crate) use vectors::Vectors;

//! Known facts about vectors: lengths, scalar products with their factors, directions.

use super::node::NodeId;
use crate::lookup::{Map, Set};

/// Facts about vectors that the graph remembers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    /// Vectors behind nodes that are their lengths: a loop `distance(a, b) = l` is solved by these.
    pub(crate) norms: Map<NodeId, Vec<NodeId>>,
    /// The same behind squares of lengths.
    pub(crate) squares: Map<NodeId, Vec<NodeId>>,
    /// The factors of scalar products in space, one behind the other.
    pub(crate) products: Map<NodeId, Vec<NodeId>>,
    /// Vectors of length 1.
    pub(crate) units: Set<Vec<NodeId>>,
}

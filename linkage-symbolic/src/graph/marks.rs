//! Marks on nodes, for walks through a graph.

use super::node::NodeId;

/// The nodes that a walk has seen. All walks use one array: a new one makes no array and clears
/// none, so that it costs no more than the nodes that it sees.
#[derive(Clone, Debug, Default)]
pub(crate) struct Marks {
    /// The number of the last walk that has seen each node.
    walks: Box<[u32]>,
    /// The number of the present walk.
    walk: u32,
}

impl Marks {
    /// Begins a walk through a graph of `count` nodes.
    pub(crate) fn begin(&mut self, count: usize) {
        if self.walks.len() < count || self.walk == u32::MAX {
            let count = count.max(2 * self.walks.len());
            self.walks = vec![0; count].into_boxed_slice();
            self.walk = 0;
        }
        self.walk += 1;
    }

    /// Marks a node. Returns true if it had no mark.
    pub(crate) fn mark(&mut self, id: NodeId) -> bool {
        let walk = &mut self.walks[id.0 as usize];
        let is_new = *walk != self.walk;
        *walk = self.walk;
        is_new
    }

    /// Returns true if the walk has seen a node.
    pub(crate) fn has(&self, id: NodeId) -> bool {
        self.walks[id.0 as usize] == self.walk
    }
}

//! Numbers of nodes: a table with one entry for each node of a graph.

use super::node::NodeId;

/// A number for each of some nodes of a graph.
///
/// For walks through most of a graph. One through a small part of it takes a
/// [`Map`](crate::lookup::Map).
#[derive(Clone, Debug, Default)]
pub(crate) struct NodeNumbers {
    /// The numbers plus 1; 0 where there is none.
    numbers: Box<[u32]>,
}

impl NodeNumbers {
    /// No numbers yet for the nodes of a graph with `count` of them.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            numbers: vec![0; count].into_boxed_slice(),
        }
    }

    /// Returns the number of a node.
    pub(crate) fn get(&self, id: NodeId) -> Option<usize> {
        match self.numbers[id.0 as usize] {
            0 => None,
            number => Some(number as usize - 1),
        }
    }

    /// Returns true if a node has a number.
    pub(crate) fn has(&self, id: NodeId) -> bool {
        self.numbers[id.0 as usize] != 0
    }

    /// Makes room for the nodes of a graph that has `count` of them by now.
    pub(crate) fn cover(&mut self, count: usize) {
        if self.numbers.len() < count {
            let mut numbers = vec![0; count.max(2 * self.numbers.len())];
            numbers[..self.numbers.len()].copy_from_slice(&self.numbers);
            self.numbers = numbers.into_boxed_slice();
        }
    }

    /// Gives a node a number.
    pub(crate) fn set(&mut self, id: NodeId, number: usize) {
        self.numbers[id.0 as usize] = number as u32 + 1;
    }

    /// Returns the node that stands for another one, by its number.
    ///
    /// # Panics
    ///
    /// Panics if the node has no number.
    pub(crate) fn node(&self, id: NodeId) -> NodeId {
        NodeId(self.numbers[id.0 as usize] - 1)
    }
}

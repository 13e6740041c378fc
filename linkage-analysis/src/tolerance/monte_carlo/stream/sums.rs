//! Sums that are the same to the last bit however the blocks are divided among threads and parts.

use alloc::vec::Vec;
use core::ops::{Add, Range};

/// The number of values of a column that are not NaN, and sums of powers of their distances from
/// the column's centre, from the first to the fourth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sums {
    pub(super) count: u64,
    pub(super) powers: [f64; 4],
}

impl Add for Sums {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            powers: core::array::from_fn(|i| self.powers[i] + other.powers[i]),
        }
    }
}

/// Sums of blocks as nodes of a binary tree over all blocks: a node is the sum of its two halves
/// as soon as both are there. So the rounding does not depend on the order in which they come.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tree<const K: usize> {
    /// Nodes in the order of their blocks.
    nodes: Vec<Node<K>>,
}

/// The sums of all columns over some blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node<const K: usize> {
    /// The first block, a multiple of the length.
    pub(super) first: u64,
    /// The binary logarithm of the number of blocks.
    pub(super) level: u32,
    pub(super) sums: [Sums; K],
}

impl<const K: usize> Node<K> {
    /// The end of its blocks.
    pub(super) fn end(&self) -> u64 {
        self.first + (1 << self.level)
    }

    /// Both halves of a node as one.
    fn joined(&self, other: &Self) -> Option<Self> {
        let halves = self.level == other.level
            && self.end() == other.first
            && (self.first >> self.level).is_multiple_of(2);
        halves.then(|| Self {
            first: self.first,
            level: self.level + 1,
            sums: core::array::from_fn(|k| self.sums[k] + other.sums[k]),
        })
    }
}

impl<const K: usize> Tree<K> {
    /// Nodes in the order of their blocks.
    pub(super) fn nodes(&self) -> &[Node<K>] {
        &self.nodes
    }

    /// Adds the sums of a block behind all others.
    pub(super) fn push(&mut self, block: u64, sums: [Sums; K]) {
        self.append(Node {
            first: block,
            level: 0,
            sums,
        });
    }

    /// Adds a node behind all others.
    fn append(&mut self, mut node: Node<K>) {
        while let Some(joined) = self.nodes.last().and_then(|last| last.joined(&node)) {
            self.nodes.pop();
            node = joined;
        }
        self.nodes.push(node);
    }

    /// The nodes of two trees; `None` and no change if both have a block.
    ///
    /// The nodes need not be neighbours: those between them may come later.
    pub(super) fn merged(&self, other: &Self) -> Option<Self> {
        let mut nodes: Vec<_> = self.nodes.iter().chain(&other.nodes).copied().collect();
        nodes.sort_unstable_by_key(|node| node.first);
        Self::from_nodes(nodes)
    }

    /// The tree with these nodes, if they are in order and apart.
    pub(super) fn from_nodes(nodes: Vec<Node<K>>) -> Option<Self> {
        let apart = nodes.windows(2).all(|pair| pair[0].end() <= pair[1].first);
        let mut tree = Self::default();
        nodes.into_iter().for_each(|node| tree.append(node));
        apart.then_some(tree)
    }

    /// The sums of a column.
    pub(super) fn total(&self, k: usize) -> Sums {
        let sums = self.nodes.iter().map(|node| node.sums[k]);
        sums.fold(Sums::default(), Sums::add)
    }

    /// The blocks of a range that are not there.
    pub(super) fn gaps(&self, blocks: Range<u64>) -> Vec<Range<u64>> {
        let mut gaps = Vec::new();
        let mut begin = blocks.start;
        for node in &self.nodes {
            gaps.push(begin..node.first.min(blocks.end));
            begin = begin.max(node.end());
        }
        gaps.push(begin..blocks.end);
        gaps.retain(|gap| !gap.is_empty());
        gaps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sums(block: u64) -> [Sums; 1] {
        let x = 1.0 / (1.0 + block as f64);
        [Sums {
            count: 1,
            powers: [x, x * x, -x, x / 3.0],
        }]
    }

    fn tree(blocks: impl IntoIterator<Item = u64>) -> Tree<1> {
        let mut tree = Tree::default();
        blocks
            .into_iter()
            .for_each(|block| tree.push(block, sums(block)));
        tree
    }

    /// 1000 blocks in parts of some lengths, in another order, and one by one.
    #[test]
    fn sums_do_not_depend_on_the_division() {
        let whole = tree(0..1000);
        assert_eq!(whole.total(0).count, 1000);
        assert_eq!(whole.nodes().len(), 6, "the bits of 1000");
        for length in [1, 3, 64, 333, 999] {
            let mut parts: Vec<_> = (0..1000_u64.div_ceil(length))
                .map(|part| tree(part * length..1000.min((part + 1) * length)))
                .collect();
            parts.reverse();
            parts.rotate_left(2 % length as usize);
            let merge = |all: Tree<1>, part: &Tree<1>| all.merged(part).expect("they are apart");
            assert_eq!(parts.iter().fold(Tree::default(), merge), whole, "{length}");
        }
        let even = tree((0..1000).step_by(2));
        let odd = tree((1..1000).step_by(2));
        assert_eq!(odd.merged(&even), Some(whole));
    }

    #[test]
    fn no_block_is_counted_twice() {
        assert_eq!(tree(0..8).merged(&tree(7..9)), None);
        assert_eq!(tree(7..9).merged(&tree(0..8)), None);
        assert_eq!(tree(3..4).merged(&tree(0..8)), None);
    }

    #[test]
    fn what_is_not_there() {
        let tree = tree((2..7).chain(9..12));
        assert_eq!(tree.gaps(0..14), [0..2, 7..9, 12..14]);
        assert_eq!(tree.gaps(3..13), [7..9, 12..13]);
        assert_eq!(tree.gaps(9..11), []);
        let all = Tree::<1>::default().gaps(5..6);
        assert_eq!((all.len(), all[0].clone()), (1, 5..6));
    }
}

//! A rule, its changes and its assumptions.

use crate::graph::{Graph, NodeId, Store};

/// The difference of a result from that of the plain operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Changes {
    /// No difference: bit for bit the same (a NaN is a NaN).
    Nothing,
    /// The sign of a zero.
    SignOfZero,
    /// It is rounded so many times more often on its way from the operands (less often, if
    /// negative), each time by at most half a unit in the last place of all its terms taken
    /// together.
    Roundings(i32),
}

/// The condition on the numbers; each one includes those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Assumes {
    /// Nothing: the rule holds for all numbers, NaN and infinities among them.
    Nothing,
    /// Terms that drop out are not NaN.
    Number,
    /// Terms that drop out are finite.
    Finite,
    /// All values are finite, and no result in between overflows or loses digits next to zero. A
    /// quotient by zero is infinite or NaN as before.
    Range,
    /// Factors that drop out are not zero.
    Nonzero,
}

type Rewrite<Operation, const ARITY: usize> =
    fn(&mut Store, Operation, [NodeId; ARITY]) -> Option<NodeId>;

/// A rewriting that a constructor tries.
#[derive(Clone, Copy, Debug)]
pub struct RewriteRule<Operation, const ARITY: usize> {
    /// The rule as a formula.
    pub name: &'static str,
    /// Other ways of writing that it finds.
    pub also: &'static [&'static str],
    /// Its effect on the result.
    pub changes: Changes,
    /// The condition for that.
    pub assumes: Assumes,
    rewrite: Rewrite<Operation, ARITY>,
}

/// A rule that changes and assumes nothing.
pub(super) const fn rule<Operation, const ARITY: usize>(
    name: &'static str,
    rewrite: Rewrite<Operation, ARITY>,
) -> RewriteRule<Operation, ARITY> {
    RewriteRule {
        name,
        also: &[],
        changes: Changes::Nothing,
        assumes: Assumes::Nothing,
        rewrite,
    }
}

impl<Operation, const ARITY: usize> RewriteRule<Operation, ARITY> {
    pub(super) const fn changes(self, changes: Changes) -> Self {
        Self { changes, ..self }
    }

    pub(super) const fn assumes(self, assumes: Assumes) -> Self {
        Self { assumes, ..self }
    }

    pub(super) const fn also(self, also: &'static [&'static str]) -> Self {
        Self { also, ..self }
    }

    /// The node that stands for an operation of these operands, if the rule fits.
    pub fn rewrite(
        &self,
        graph: &Graph,
        op: Operation,
        operands: [NodeId; ARITY],
    ) -> Option<NodeId> {
        (self.rewrite)(&mut graph.store_mut(), op, operands)
    }
}

/// Applies the first rule that fits to an operation.
pub(super) fn first<Operation: Copy, const ARITY: usize>(
    rules: &[RewriteRule<Operation, ARITY>],
    store: &mut Store,
    op: Operation,
    operands: [NodeId; ARITY],
) -> Option<NodeId> {
    for rule in rules {
        let found = (rule.rewrite)(store, op, operands);
        if found.is_some() {
            return found;
        }
    }
    None
}

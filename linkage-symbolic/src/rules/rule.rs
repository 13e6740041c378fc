//! A rule, and what it may change and assume.

use crate::graph::{Graph, NodeId, Store};

/// By what a result may differ from that of the plain operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Changes {
    /// By nothing: bit for bit the same (a NaN is a NaN).
    Nothing,
    /// By the sign of a zero.
    SignOfZero,
    /// It is rounded so many times more often on its way from the operands (less often, if negative), each time by at most half a unit
    /// in the last place of all its terms taken together.
    Roundings(i32),
}

/// What must hold of the numbers; each one demands what stands before it, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Assumes {
    /// Nothing: the rule holds for all numbers, NaN and infinities among them.
    Nothing,
    /// What drops out is not NaN.
    Number,
    /// What drops out is finite.
    Finite,
    /// All values are finite, and no result in between overflows or loses digits next to zero. What is divided by zero is infinite or NaN
    /// as before.
    Range,
    /// What drops out is not zero.
    Nonzero,
}

type Rewrite<Operation, const ARITY: usize> =
    fn(&mut Store, Operation, [NodeId; ARITY]) -> Option<NodeId>;

/// A rewriting that a constructor tries.
#[derive(Clone, Copy, Debug)]
pub struct Rule<Operation, const ARITY: usize> {
    /// What it does, as a formula.
    pub name: &'static str,
    /// Other ways of writing that it finds.
    pub also: &'static [&'static str],
    /// What it does to the result.
    pub changes: Changes,
    /// Where that holds.
    pub assumes: Assumes,
    rewrite: Rewrite<Operation, ARITY>,
}

/// A rule that changes and assumes nothing.
pub(super) const fn rule<Operation, const ARITY: usize>(
    name: &'static str,
    rewrite: Rewrite<Operation, ARITY>,
) -> Rule<Operation, ARITY> {
    Rule {
        name,
        also: &[],
        changes: Changes::Nothing,
        assumes: Assumes::Nothing,
        rewrite,
    }
}

impl<Operation, const ARITY: usize> Rule<Operation, ARITY> {
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

/// What the first rule that fits makes of an operation.
pub(super) fn first<Operation: Copy, const ARITY: usize>(
    rules: &[Rule<Operation, ARITY>],
    store: &mut Store,
    op: Operation,
    operands: [NodeId; ARITY],
) -> Option<NodeId> {
    let mut rules = rules.iter();
    rules.find_map(|rule| (rule.rewrite)(store, op, operands))
}

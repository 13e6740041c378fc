//! The rules of simplification: each has a name and says what it does to a number.
//!
//! A constructor tries the rules of its operation in order. The first that fits its operands gives the node; if none does, the
//! operation is stored as it is. A rule that does not fit makes no node, since the order in which nodes are made decides which operand of a
//! sum stands first.
//!
//! # What constructors may do to a number
//!
//! - Most rules change nothing: the result is the same bit for bit, for NaN and infinities, too.
//! - The sign of zero carries no meaning in a mechanism. There is no constant `-0`, and [`Changes::SignOfZero`] rules may turn it.
//! - What cancels is taken for a number of a mechanism that closes: finite where a term drops out, not zero either where a factor does. A NaN
//!   in what drops out is lost. One in what stays is kept, always: a result that hangs on a failed position is NaN.
//! - What drops out takes its roundings with it, so that such results are more exact ([`Changes::Roundings`] below 0).
//! - Factors move in front of what is known later, which rounds elsewhere, but not more often.
//! - Divisors that are known in `assemble()` are inverted there. That adds one rounding to what a call computes, and no other rule adds any.
//!
//! The names are formulas: `x`, `y`, `z` depend on an input, `p`, `q`, `r` on parameters alone, `k` and `m` are numbers; `f` is any
//! operation that has the rule. The tests read them: they build the left side, expect the right side, and compare values.

mod functions;
mod guards;
mod products;
mod quotients;
mod rates;
mod signs;
mod sums;

use crate::graph::{Graph, NodeId, Store};
use crate::operation::{Binary, Ternary, Unary};

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
const fn rule<Operation, const ARITY: usize>(
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
    const fn changes(self, changes: Changes) -> Self {
        Self { changes, ..self }
    }

    const fn assumes(self, assumes: Assumes) -> Self {
        Self { assumes, ..self }
    }

    const fn also(self, also: &'static [&'static str]) -> Self {
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
pub(crate) fn first<Operation: Copy, const ARITY: usize>(
    rules: &[Rule<Operation, ARITY>],
    store: &mut Store,
    op: Operation,
    operands: [NodeId; ARITY],
) -> Option<NodeId> {
    let mut rules = rules.iter();
    rules.find_map(|rule| (rule.rewrite)(store, op, operands))
}

/// The rules of an operation of one operand, in order.
pub fn of_unary(op: Unary) -> &'static [Rule<Unary, 1>] {
    match op {
        Unary::Neg => signs::NEGATIVE,
        Unary::Abs => signs::ABSOLUTE,
        Unary::Sqrt => functions::ROOT,
        Unary::Sin | Unary::Tan | Unary::Asin | Unary::Atan => functions::ODD,
        Unary::Cos => functions::EVEN,
        Unary::Acos | Unary::Sign | Unary::Whole | Unary::InverseScale => functions::OF_ONE,
        Unary::Slack => guards::SLACK,
    }
}

/// The rules of an operation of two operands, in order. The factor of a product that is known earlier is the first.
pub fn of_binary(op: Binary) -> &'static [Rule<Binary, 2>] {
    match op {
        Binary::Add => sums::SUM,
        Binary::Sub => sums::DIFFERENCE,
        Binary::Mul => products::PRODUCT,
        Binary::Div => quotients::QUOTIENT,
        Binary::Hypot => functions::HYPOT,
        Binary::Quotient | Binary::Atan2 | Binary::Min | Binary::Max => functions::OF_TWO,
    }
}

/// The rules of an operation of three operands, in order.
pub fn of_ternary(op: Ternary) -> &'static [Rule<Ternary, 3>] {
    match op {
        Ternary::Select => functions::SELECT,
        Ternary::AngleNear => functions::OF_THREE,
        Ternary::Root => guards::ROOT,
    }
}

/// The rules that sums and products of rates follow before those of all: rates share factors, the turning of a link.
pub fn of_rates(op: Binary) -> &'static [Rule<Binary, 2>] {
    match op {
        Binary::Add => rates::SUM,
        Binary::Sub => rates::DIFFERENCE,
        Binary::Mul => rates::PRODUCT,
        Binary::Div
        | Binary::Quotient
        | Binary::Hypot
        | Binary::Atan2
        | Binary::Min
        | Binary::Max => &[],
    }
}

/// The rules that choices follow, before those of all, once definitions are known.
pub fn of_inlined(op: Ternary) -> &'static [Rule<Ternary, 3>] {
    match op {
        Ternary::Select => guards::GUARD,
        Ternary::AngleNear | Ternary::Root => &[],
    }
}

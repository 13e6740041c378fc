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

mod construct;
mod functions;
mod guards;
mod products;
mod quotients;
mod rates;
mod rule;
mod signs;
mod sums;
mod table;

pub use rule::{Assumes, Changes, Rule};
pub use table::{of_binary, of_inlined, of_rates, of_ternary, of_unary};

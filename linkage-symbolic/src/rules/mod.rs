//! The rules of simplification: each has a name and states its effect on a number.
//!
//! A constructor tries the rules of its operation in order. The first that fits its operands gives
//! the node; if none does, the operation is stored as it is. A rule that does not fit makes no
//! node, since the order in which nodes are made decides which operand of a sum stands first.
//!
//! # Effects of constructors on a number
//!
//! - Most rules change nothing: the result is the same bit for bit, for NaN and infinities, too.
//! - The sign of zero carries no meaning in a mechanism. There is no constant `-0`, and
//!   [`Changes::SignOfZero`] rules may turn it.
//! - A term that cancels is taken for a number of a mechanism that closes: finite, and a factor that
//!   cancels is not zero either. A NaN in them is lost. A NaN in the other terms is kept, so that a
//!   result of a failed position is NaN.
//! - Roundings drop out with their terms, so that such results are more exact
//!   ([`Changes::Roundings`] below 0).
//! - Factors move in front of values that are known later, which rounds elsewhere, but not more often.
//! - Divisors that are known in `assemble()` are inverted there. That adds one rounding to a call. No
//!   other rule adds any.
//!
//! The names are formulas: `x`, `y`, `z` depend on an input, `p`, `q`, `r` on parameters alone, `k`
//! and `m` are numbers; `f` is any operation that has the rule. The tests read them: they build the
//! left side, expect the right side, and compare values.

mod by_operation;
mod construct;
mod functions;
mod guards;
mod products;
mod quotients;
mod rates;
mod rule;
mod signs;
mod sums;

pub use by_operation::{of_binary, of_inlined, of_rates, of_ternary, of_unary};
pub use rule::{Assumes, Changes, RewriteRule};

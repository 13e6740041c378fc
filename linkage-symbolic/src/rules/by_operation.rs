//! The rules of each operation.

use super::rule::RewriteRule;
use super::{functions, guards, products, quotients, rates, signs, sums};
use crate::operation::{Binary, Symmetry, Ternary, Unary};

/// Returns the rules of an operation of one operand, in order. Operations without rules of their
/// own follow those of their symmetry.
pub fn of_unary(op: Unary) -> &'static [RewriteRule<Unary, 1>] {
    match op {
        Unary::Neg => signs::NEGATIVE,
        Unary::Abs => signs::ABSOLUTE,
        Unary::Sqrt => functions::ROOT,
        Unary::Slack => guards::SLACK,
        _ => match op.row().symmetry {
            Symmetry::Odd => functions::ODD,
            Symmetry::Even => functions::EVEN,
            Symmetry::Neither => functions::OF_ONE,
        },
    }
}

/// Returns the rules of an operation of two operands, in order. The factor of a product that is
/// known earlier is the first.
pub fn of_binary(op: Binary) -> &'static [RewriteRule<Binary, 2>] {
    match op {
        Binary::Add => sums::SUM,
        Binary::Sub => sums::DIFFERENCE,
        Binary::Mul => products::PRODUCT,
        Binary::Div => quotients::QUOTIENT,
        Binary::Hypot => functions::HYPOT,
        _ => functions::OF_TWO,
    }
}

/// Returns the rules of an operation of three operands, in order.
pub fn of_ternary(op: Ternary) -> &'static [RewriteRule<Ternary, 3>] {
    match op {
        Ternary::Select => functions::SELECT,
        Ternary::GuardedSqrt => guards::ROOT,
        _ => functions::OF_THREE,
    }
}

/// Returns the rules that sums and products of rates follow before those of all: rates share
/// factors, the turning of a link.
pub fn of_rates(op: Binary) -> &'static [RewriteRule<Binary, 2>] {
    match op {
        Binary::Add => rates::SUM,
        Binary::Sub => rates::DIFFERENCE,
        Binary::Mul => rates::PRODUCT,
        _ => &[],
    }
}

/// Returns the rules that choices follow, before those of all, once definitions are known.
pub fn of_inlined(op: Ternary) -> &'static [RewriteRule<Ternary, 3>] {
    match op {
        Ternary::Select => guards::GUARD,
        _ => &[],
    }
}

//! The rules of each operation.

use super::rule::Rule;
use super::{functions, guards, products, quotients, rates, signs, sums};
use crate::operation::{Binary, Ternary, Unary};

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

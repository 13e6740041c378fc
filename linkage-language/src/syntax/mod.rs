//! Tokens to syntax tree. Never fails: a bad item becomes a diagnostic and is left out.

mod ast;
mod attributes;
mod clauses;
mod dump;
mod expression;
mod expression_tree;
mod function;
mod input;
mod items;
mod joints;
mod keyword;
mod literal;
mod loads;
mod mechanics_tree;
mod mechanism_blocks;
mod operands;
mod parser;
mod part;
mod power;
mod recovery;
mod spelling;
mod stream;
#[cfg(test)]
mod tests;
mod tolerance;
mod unexpected;
mod units;
mod vocabulary;

pub use ast::*;
pub use dump::dump;
pub use expression_tree::*;
pub use keyword::JointKind;
pub use mechanics_tree::*;
pub use mechanism_blocks::parse;
pub use spelling::units_within;
pub use units::{Scale, UnitOfMeasure, find_unit, first_spelling, is_meant_as_unit, is_unit};
pub use vocabulary::Word;
pub(crate) use vocabulary::vocabulary;

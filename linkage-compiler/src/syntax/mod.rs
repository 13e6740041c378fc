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

pub(crate) use ast::*;
pub(crate) use dump::dump;
pub(crate) use expression_tree::*;
pub(crate) use keyword::JointKind;
pub(crate) use mechanics_tree::*;
pub(crate) use mechanism_blocks::parse;
pub(crate) use spelling::units_within;
pub(crate) use units::{Scale, UnitOfMeasure, find_unit, first_spelling, is_unit};
pub(crate) use vocabulary::{Word, vocabulary};

//! Tokens to syntax tree. Never fails: a bad item becomes a diagnostic and is left out.

mod arc;
mod ast;
mod attributes;
mod clauses;
mod dump;
mod expression;
mod expression_tree;
mod function;
mod input;
mod item_name;
mod items;
mod joints;
mod keyword;
mod link_elements;
mod link_inventory;
mod linked;
mod linked_tree;
mod linked_words;
mod literal;
mod loads;
mod mechanics_tree;
mod mechanism_blocks;
mod mechanism_text;
mod operands;
mod parser;
mod part;
mod power;
mod recovery;
mod sliders;
mod spelling;
mod stream;
#[cfg(test)]
mod tests;
mod tolerance;
mod unexpected;
mod units;
mod vocabulary;
mod wheels;

pub use ast::*;
pub use dump::dump;
pub use expression_tree::*;
pub use item_name::ItemName;
pub use keyword::{
    ClauseWord, DeclarationWord, ItemWord, JointKind, LinkedWord, LoadWord, MarkWord,
    is_clause_word, is_keyword,
};
pub use link_elements::*;
pub use link_inventory::*;
pub use linked_tree::*;
pub use linked_words::{LinkClause, LinkQuantity, SliderWord, WheelsWord};
pub use mechanics_tree::*;
pub use mechanism_blocks::parse;
pub use mechanism_text::{item_text, mechanism_text};
pub use spelling::units_within;
pub use units::{
    Scale, UnitOfMeasure, find_unit, first_spelling, is_meant_as_unit, is_unit, unit_description,
    unit_names,
};
pub(crate) use vocabulary::vocabulary;
pub use vocabulary::{Vocabulary, Word};

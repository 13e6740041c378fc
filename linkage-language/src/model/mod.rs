//! Syntax tree to model: names become ids, dimensions are checked, numbers get one unit.

mod attempt;
mod best_attempt;
mod declare;
mod dispatch;
mod dump;
mod expression;
mod function_call;
mod generated;
mod items;
mod library;
mod links;
mod mechanics;
mod motion_law;
mod parts;
mod quantity;
mod resolve;
mod symbols;
#[cfg(test)]
mod tests;
mod types;
mod units;
pub mod unknown_frames;
mod word_list;

pub use dump::model::dump;
pub use generated::{ASSEMBLY, COLUMNS, FOLLOWER, METHODS_OF_FOLLOWER, Sweep, TYPE_PARAMETER};
pub use library::{Library, Model};
pub use links::{expand, read};
pub use resolve::resolve;
pub use types::*;
pub use types::{COMPONENTS, Shape};
pub use word_list::{WordClass, WordRow, clauses_of, plain_word, words_of_class};

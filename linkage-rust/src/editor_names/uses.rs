//! Words of the macro's input, each where it is written.

use linkage_language::syntax::Vocabulary;
use proc_macro2::Ident;

/// A word where it is written, or a place where one can be written.
pub(super) enum Use {
    /// A name, and the names after its dots.
    Name { path: Vec<Ident>, declares: bool },
    /// The word in front of a parenthesis.
    Call(Ident),
    /// The word that an item begins with, or the kind of a joint.
    Item(Ident),
    /// A word within an item that is no name.
    Clause(Ident, Clauses),
    /// A unit, alone or after a number.
    Unit(Ident),
    /// The end of an item: a name can follow, or a clause.
    EndOfItem(Clauses),
    /// The end of a block: an item can follow.
    EndOfBlock,
}

/// The vocabulary of the words within an item; `None` for marks and courses, which every item has.
pub(super) type Clauses = Option<Vocabulary>;

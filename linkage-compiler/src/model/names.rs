//! Declared names and their types.

use std::collections::BTreeMap;

use super::types::{Name, Type};
use crate::diagnostic::SourceSpan;

/// One declared name.
pub(super) struct Symbol {
    pub(super) name: Name,
    pub(super) text: String,
    /// An error until the item has been resolved.
    pub(super) ty: Type,
    /// Position of its item in the struct block.
    pub(super) item: usize,
    /// Declared with a `0` that has no unit.
    pub(super) bare_zero: bool,
    /// A derived quantity that the user declares as an unknown.
    pub(super) is_unknown_frame: bool,
    pub(super) span: SourceSpan,
}

impl Symbol {
    /// The sort of its name in words.
    pub(super) fn kind(&self) -> &'static str {
        match self.is_unknown_frame {
            true => "an unknown",
            false => kind(self.name),
        }
    }
}

/// All declared names.
#[derive(Default)]
pub(super) struct Names {
    pub(super) symbols: Vec<Symbol>,
    by_name: BTreeMap<String, usize>,
}

impl Names {
    /// Adds a name; of two names with the same text, the first counts.
    pub(super) fn add_symbol(&mut self, symbol: Symbol) {
        let index = self.symbols.len();
        self.by_name.entry(symbol.text.clone()).or_insert(index);
        self.symbols.push(symbol);
    }

    /// Returns the name with this text.
    pub(super) fn find(&self, text: &str) -> Option<&Symbol> {
        self.by_name.get(text).map(|index| &self.symbols[*index])
    }

    /// Returns the declaration of a name.
    pub(super) fn symbol(&self, name: Name) -> Option<&Symbol> {
        self.symbols.iter().find(|symbol| symbol.name == name)
    }

    /// Stores the type of a name, and whether it was declared with a `0` that has no unit.
    pub(super) fn set_type(&mut self, name: Name, ty: Type, bare_zero: bool) {
        let mut symbols = self.symbols.iter_mut();
        if let Some(symbol) = symbols.find(|symbol| symbol.name == name) {
            symbol.ty = ty;
            symbol.bare_zero = bare_zero;
        }
    }

    /// Returns the texts of all names of one sort, for help texts.
    pub(super) fn names_of(&self, wanted: fn(Name) -> bool) -> Vec<&str> {
        let symbols = self.symbols.iter().filter(|symbol| wanted(symbol.name));
        symbols.map(|symbol| symbol.text.as_str()).collect()
    }
}

/// The sort of a name in words.
pub(super) fn kind(name: Name) -> &'static str {
    match name {
        Name::Const(_) | Name::Pi => "a constant",
        Name::Parameter(_) => "a parameter",
        Name::Input(_) => "an input",
        Name::Unknown(_) => "an unknown",
        Name::Let(_) => "a derived quantity",
        Name::Argument(_) => "an argument",
    }
}

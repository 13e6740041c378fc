//! Declared names and their types.

use std::collections::BTreeMap;

use crate::diagnostic::SourceSpan;
use crate::model::types::{Name, Type};

/// One declared name.
pub(in crate::model) struct Symbol {
    pub(in crate::model) name: Name,
    pub(in crate::model) text: String,
    /// An error until the item has been resolved.
    pub(in crate::model) ty: Type,
    /// Position of its item in the struct block.
    pub(in crate::model) item: usize,
    /// Declared with a `0` that has no unit.
    pub(in crate::model) bare_zero: bool,
    /// A derived quantity that the user declares as an unknown.
    pub(in crate::model) is_unknown_frame: bool,
    pub(in crate::model) span: SourceSpan,
}

impl Symbol {
    /// Returns the kind of its name as text.
    pub(in crate::model) fn kind(&self) -> &'static str {
        if self.is_unknown_frame {
            "an unknown"
        } else {
            kind(self.name)
        }
    }
}

/// All declared names.
#[derive(Default)]
pub(in crate::model) struct Names {
    pub(in crate::model) symbols: Vec<Symbol>,
    by_name: BTreeMap<String, usize>,
}

impl Names {
    /// Adds a name; of two names with the same text, the first counts.
    pub(in crate::model) fn add_symbol(&mut self, symbol: Symbol) {
        let index = self.symbols.len();
        self.by_name.entry(symbol.text.clone()).or_insert(index);
        self.symbols.push(symbol);
    }

    /// Returns the name with this text.
    pub(in crate::model) fn find(&self, text: &str) -> Option<&Symbol> {
        self.by_name.get(text).map(|index| &self.symbols[*index])
    }

    /// Returns the declaration of a name.
    pub(in crate::model) fn symbol(&self, name: Name) -> Option<&Symbol> {
        self.symbols.iter().find(|symbol| symbol.name == name)
    }

    /// Stores the type of a name, and whether it was declared with a `0` that has no unit.
    pub(in crate::model) fn set_type(&mut self, name: Name, ty: Type, bare_zero: bool) {
        let mut symbols = self.symbols.iter_mut();
        if let Some(symbol) = symbols.find(|symbol| symbol.name == name) {
            symbol.ty = ty;
            symbol.bare_zero = bare_zero;
        }
    }

    /// Returns the texts of all names of one sort, for help texts.
    pub(in crate::model) fn names_of(&self, wanted: fn(Name) -> bool) -> Vec<&str> {
        let symbols = self.symbols.iter().filter(|symbol| wanted(symbol.name));
        symbols.map(|symbol| symbol.text.as_str()).collect()
    }
}

/// Returns the kind of a name as text.
pub(in crate::model) fn kind(name: Name) -> &'static str {
    match name {
        Name::Const(_) | Name::Pi => "a constant",
        Name::Parameter(_) => "a parameter",
        Name::Input(_) => "an input",
        Name::Unknown(_) => "an unknown",
        Name::Let(_) => "a derived quantity",
        Name::Argument(_) => "an argument",
    }
}

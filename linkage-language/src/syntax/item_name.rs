//! Names that items declare.

use std::fmt::{self, Display, Formatter};

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;

/// The name of a value: `crank`, or `crank.length` for a quantity of a link.
#[derive(Clone, Debug)]
pub struct ItemName {
    /// The link that the value belongs to.
    link: Option<Ident>,
    name: Ident,
}

impl ItemName {
    /// Returns the name of a quantity of a link.
    pub fn of_link(link: Ident, name: Ident) -> Self {
        let link = Some(link);
        Self { link, name }
    }

    /// Returns the link that it is a quantity of.
    pub fn link(&self) -> Option<&Ident> {
        self.link.as_ref()
    }

    /// Returns the name after the dot of a quantity of a link, and any other name.
    pub fn last(&self) -> &Ident {
        &self.name
    }

    /// Returns true for a quantity of a link.
    pub fn is_of_link(&self) -> bool {
        self.link.is_some()
    }

    /// Returns the name of the field: `crank_length` for `crank.length`.
    pub fn field(&self) -> Ident {
        match &self.link {
            Some(link) => Ident::new(&format!("{link}_{}", self.name), self.name.span()),
            None => self.name.clone(),
        }
    }
}

impl From<Ident> for ItemName {
    fn from(name: Ident) -> Self {
        Self { link: None, name }
    }
}

impl Display for ItemName {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match &self.link {
            Some(link) => write!(f, "{link}.{}", self.name),
            None => write!(f, "{}", self.name),
        }
    }
}

impl From<&ItemName> for SourceSpan {
    fn from(name: &ItemName) -> Self {
        (&name.name).into()
    }
}

//! Parts: mechanisms within a mechanism, their names there and the expressions that they are given.

use std::collections::BTreeSet;
use std::rc::Rc;

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::model::library::Model;
use crate::model::types::{Expr, Mechanism, Name, Placed};
use crate::syntax;

/// One part: its names in the mechanism around it.
pub(in crate::model) struct PartScope {
    pub(in crate::model) name: String,
    pub(in crate::model) span: SourceSpan,
    /// Position of its item in the struct block.
    pub(in crate::model) item: usize,
    /// `None` after a mistake: its content is unknown.
    pub(in crate::model) body: Option<PartBody>,
}

/// A part of which all is known.
#[derive(Clone)]
pub(in crate::model) struct PartBody {
    pub(in crate::model) model: Rc<Model>,
    /// The offset of numbers of origins.
    pub(in crate::model) first_origin: u32,
    pub(in crate::model) first_constant: usize,
    pub(in crate::model) first_unknown: usize,
    /// The first of the derived quantities that come with the part: inputs, arguments, parameters
    /// that are given, its location, its own ones.
    pub(in crate::model) first_let: usize,
    /// Its parameters in the mechanism around it. Parameters that are given are derived quantities.
    /// `None` until parameters are counted.
    pub(in crate::model) parameters: Vec<Option<Name>>,
    /// The arguments that are given, as derived quantities.
    pub(in crate::model) arguments: Vec<Option<Name>>,
    /// Speeds and accelerations that follow from the inputs of the mechanism around it, by
    /// argument; or the reason why one does not follow.
    pub(in crate::model) rates: Vec<Option<Result<Expr, Unfollowed>>>,
    pub(in crate::model) is_placed: bool,
    pub(in crate::model) is_turned: bool,
}

impl PartBody {
    pub(in crate::model) fn mechanism(&self) -> &Mechanism {
        &self.model.mechanism
    }

    /// The derived quantity that an input is.
    pub(in crate::model) fn input(&self, input: usize) -> usize {
        self.first_let + input
    }

    /// Returns the first of its own derived quantities, after those that are made for it.
    pub(in crate::model) fn own_lets(&self) -> usize {
        let given = self.parameters.iter().chain(&self.arguments);
        let given = given
            .filter(|name| matches!(name, Some(Name::Let(_))))
            .count();
        let placing = usize::from(self.is_placed) + usize::from(self.is_turned);
        self.input(self.mechanism().inputs.len()) + given + placing
    }
}

/// All parts of a mechanism.
#[derive(Default)]
pub(in crate::model) struct Parts {
    pub(in crate::model) scopes: Vec<PartScope>,
    /// Locations of parts, as far as they have been read.
    pub(in crate::model) placed: Vec<Placed>,
    /// Names of quantities of links: `crank.length`, `hook.crank.length`.
    pub(in crate::model) quantities: BTreeSet<String>,
}

impl Parts {
    /// Returns the name that an expression is, after the names of its parts: `phi`, `hook.tip`,
    /// `machine.hook.tip`, or after that of its link: `crank.length`.
    pub(in crate::model) fn dotted(&self, expr: &syntax::Expr) -> Option<String> {
        match &expr.kind {
            syntax::ExprKind::Name(ident) => Some(ident.to_string()),
            syntax::ExprKind::Field(value, field) => {
                let path = self.dotted(value)?;
                self.has_members(&path, field)
                    .then(|| format!("{path}.{field}"))
            }
            _ => None,
        }
    }

    /// Returns the part, or the link with such a quantity, that an expression is.
    pub(in crate::model) fn owner_of(&self, expr: &syntax::Expr, member: &Ident) -> Option<String> {
        self.dotted(expr)
            .filter(|path| self.has_members(path, member))
    }

    /// Returns true for a part, and for a link that has this quantity.
    fn has_members(&self, path: &str, member: &Ident) -> bool {
        let quantity = format!("{path}.{member}");
        let mut quantities = self.quantities.iter();
        self.is_part(path)
            || quantities.any(|name| {
                let rest = name.strip_prefix(&quantity);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            })
    }

    /// Returns the quantities of a link or slider: `coupler.length`. Empty for another name.
    pub(in crate::model) fn quantities_of(&self, link: &str) -> Vec<&str> {
        let quantities = self.quantities.iter().map(String::as_str);
        let of_link = quantities.filter(|name| {
            let rest = name.strip_prefix(link);
            rest.is_some_and(|rest| rest.starts_with('.'))
        });
        of_link.collect()
    }

    /// Returns true for the name of a part, or of a part of one.
    pub(in crate::model) fn is_part(&self, path: &str) -> bool {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let Some(part) = self.find(first) else {
            return false;
        };
        match &part.body {
            _ if rest.is_empty() => true,
            None => false,
            Some(body) => {
                let inner = body.mechanism().paths_of_parts();
                inner.iter().any(|(path, _)| path == rest)
            }
        }
    }

    /// Returns true if nothing is known about a part because of a mistake that has been reported.
    pub(in crate::model) fn is_broken_part(&self, path: &str) -> bool {
        let first = path.split('.').next().unwrap_or_default();
        self.find(first).is_some_and(|part| part.body.is_none())
    }

    /// Returns the part with this name.
    pub(in crate::model) fn find(&self, name: &str) -> Option<&PartScope> {
        self.scopes.iter().find(|part| part.name == name)
    }
}

/// Why a speed or an acceleration is not known.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::model) enum Unfollowed {
    /// This input has none.
    OfInput(usize),
    /// It depends on an unknown, or on a function that is not differentiated here. This is a
    /// limitation.
    Other,
}

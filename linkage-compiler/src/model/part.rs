//! Parts: mechanisms within a mechanism, their names there and the expressions that are given to them.

use std::rc::Rc;

use super::library::Model;
use super::types::{Expr, Mechanism, Name, Placed};
use crate::diagnostic::SourceSpan;
use crate::syntax;

/// One part: what its names are in the mechanism around it.
pub(super) struct PartScope {
    pub(super) name: String,
    pub(super) span: SourceSpan,
    /// Position of its item in the struct block.
    pub(super) item: usize,
    /// `None` after a mistake: nothing is said about what it consists of.
    pub(super) body: Option<PartBody>,
}

/// A part of which all is known.
#[derive(Clone)]
pub(super) struct PartBody {
    pub(super) model: Rc<Model>,
    /// What is added to numbers of origins.
    pub(super) first_origin: u32,
    pub(super) first_constant: usize,
    pub(super) first_unknown: usize,
    /// The first of the derived quantities that come with the part: inputs, arguments, parameters that are given, its place, its own ones.
    pub(super) first_let: usize,
    /// What its parameters are: given ones are derived quantities. `None` until parameters are counted.
    pub(super) parameters: Vec<Option<Name>>,
    /// The arguments that are given, as derived quantities.
    pub(super) arguments: Vec<Option<Name>>,
    /// Speeds and accelerations that follow from those around, by argument; why not, where one does not follow.
    pub(super) rates: Vec<Option<Result<Expr, Unfollowed>>>,
    pub(super) is_placed: bool,
    pub(super) is_turned: bool,
}

impl PartBody {
    pub(super) fn mechanism(&self) -> &Mechanism {
        &self.model.mechanism
    }

    /// The derived quantity that an input is.
    pub(super) fn input(&self, input: usize) -> usize {
        self.first_let + input
    }

    /// The first of its own derived quantities, behind those that are made for it.
    pub(super) fn own_lets(&self) -> usize {
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
pub(super) struct Parts {
    pub(super) scopes: Vec<PartScope>,
    /// Locations of parts, as far as they have been read.
    pub(super) placed: Vec<Placed>,
}

impl Parts {
    /// Returns the name that an expression is, with the names of the parts in front: `phi`, `hook.tip`, `machine.hook.tip`.
    pub(super) fn dotted(&self, expr: &syntax::Expr) -> Option<String> {
        match &expr.kind {
            syntax::ExprKind::Name(ident) => Some(ident.to_string()),
            syntax::ExprKind::Field(value, field) => {
                let path = self.dotted(value)?;
                self.is_part(&path).then(|| format!("{path}.{field}"))
            }
            _ => None,
        }
    }

    /// Returns the part that an expression is.
    pub(super) fn part_named(&self, expr: &syntax::Expr) -> Option<String> {
        self.dotted(expr).filter(|path| self.is_part(path))
    }

    /// Returns true for the name of a part, or of a part of one.
    pub(super) fn is_part(&self, path: &str) -> bool {
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
    pub(super) fn is_broken_part(&self, path: &str) -> bool {
        let first = path.split('.').next().unwrap_or_default();
        self.find(first).is_some_and(|part| part.body.is_none())
    }

    /// Returns the part with this name.
    pub(super) fn find(&self, name: &str) -> Option<&PartScope> {
        self.scopes.iter().find(|part| part.name == name)
    }
}

/// Why a speed or an acceleration is not known.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Unfollowed {
    /// This input has none.
    OfInput(usize),
    /// By an unknown, or a function that is not differentiated here. A limit of ours.
    Other,
}

//! Parts: what of a mechanism within another has a name there, and what is given to it.

use std::rc::Rc;

use super::library::{Found, Model};
use super::names::{Counts, Resolver, Symbol, next};
use super::rate::Unfollowed;
use super::types::{Expr, Mechanism, Name, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, PartItem};

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

impl Resolver<'_> {
    /// A part's name, and room for what is given to it among the derived quantities.
    pub(super) fn declare_part(
        &mut self,
        item: &PartItem,
        position: usize,
        found: &Found,
        counts: &mut Counts,
    ) {
        self.check_reserved(&item.name);
        let new = self.check_new(&item.name);
        let name = item.name.to_string();
        let body = match found {
            // Its names would be those of another part.
            _ if !new => None,
            Found::Sound(model) => Some(self.part_body(item, model, counts)),
            Found::Broken => None,
            Found::Unknown(names) => {
                self.unknown_mechanism(&item.mechanism, names);
                None
            }
        };
        self.parts.push(PartScope {
            name,
            span: (&item.name).into(),
            item: position,
            body,
        });
    }

    fn part_body(&mut self, item: &PartItem, model: &Rc<Model>, counts: &mut Counts) -> PartBody {
        let mechanism = &model.mechanism;
        let is_given = |name: &str| item.given.iter().any(|given| given.name == name);
        let first_let = counts.lets;
        counts.lets += mechanism.inputs.len();
        let mut next_let = |is_given: bool| {
            counts.lets += usize::from(is_given);
            is_given.then(|| Name::Let(counts.lets - 1))
        };
        let arguments = mechanism.arguments.iter();
        let arguments = arguments.map(|own| next_let(is_given(&own.name))).collect();
        let parameters = mechanism.parameters.iter();
        let parameters = parameters
            .map(|own| next_let(is_given(&own.name)))
            .collect();
        let body = PartBody {
            first_origin: self
                .origins
                .add_part(&item.name.to_string(), &model.origins),
            first_constant: 0,
            first_unknown: 0,
            first_let,
            parameters,
            rates: vec![None; mechanism.arguments.len()],
            arguments,
            is_placed: item.at.is_some(),
            is_turned: item.turned.is_some(),
            model: model.clone(),
        };
        let placing = usize::from(body.is_placed) + usize::from(body.is_turned);
        counts.lets += placing + mechanism.lets.len();
        body
    }

    /// All names of parts, once it is known how many names there are beside them.
    pub(super) fn declare_members_of_parts(&mut self, counts: &mut Counts) {
        for part in 0..self.parts.len() {
            let Some(mut body) = self.parts[part].body.take() else {
                continue;
            };
            let mechanism = &body.model.mechanism;
            body.first_constant = counts.constants;
            counts.constants += mechanism.constants.len();
            body.first_unknown = counts.unknowns;
            counts.unknowns += mechanism.unknowns.len();
            for own in &mut body.parameters {
                own.get_or_insert_with(|| Name::Parameter(next(&mut counts.parameters)));
            }
            for (name, text, ty) in members(&body) {
                let PartScope {
                    name: part,
                    span,
                    item,
                    ..
                } = &self.parts[part];
                let symbol = Symbol {
                    name,
                    text: format!("{part}.{text}"),
                    ty,
                    item: *item,
                    bare_zero: false,
                    is_unknown_frame: false,
                    span: *span,
                };
                self.add_symbol(symbol);
            }
            self.parts[part].body = Some(body);
        }
    }

    /// The name that an expression is, with the names of the parts in front: `phi`, `hook.tip`, `machine.hook.tip`.
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

    /// The part that an expression is.
    pub(super) fn part_named(&self, expr: &syntax::Expr) -> Option<String> {
        self.dotted(expr).filter(|path| self.is_part(path))
    }

    /// Whether a name is that of a part, or of a part of one.
    pub(super) fn is_part(&self, path: &str) -> bool {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let mut parts = self.parts.iter();
        let Some(part) = parts.find(|part| part.name == first) else {
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

    /// Whether nothing is known about a part because of a mistake that has been reported.
    pub(super) fn is_broken_part(&self, path: &str) -> bool {
        let first = path.split('.').next().unwrap_or_default();
        let part = self.parts.iter().find(|part| part.name == first);
        part.is_some_and(|part| part.body.is_none())
    }
}

/// The names of a part: what they are in the mechanism around it, as they are written in its own, and their types.
fn members(body: &PartBody) -> Vec<(Name, String, Type)> {
    let mechanism = body.mechanism();
    let mut all = Vec::new();
    let mut add = |name, text: &str, ty: &Type| all.push((name, text.to_owned(), ty.clone()));
    for (index, own) in mechanism.constants.iter().enumerate() {
        add(
            Name::Const(body.first_constant + index),
            &own.name,
            &own.value.ty,
        );
    }
    for (own, name) in mechanism.parameters.iter().zip(&body.parameters) {
        if let Some(name) = name {
            add(*name, &own.name, &own.ty);
        }
    }
    for (index, own) in mechanism.inputs.iter().enumerate() {
        add(
            Name::Let(body.input(index)),
            &own.name,
            &Type::Scalar(own.dimension),
        );
    }
    for (own, name) in mechanism.arguments.iter().zip(&body.arguments) {
        if let Some(name) = name {
            add(*name, &own.name, &Type::Scalar(own.dimension));
        }
    }
    for (index, own) in mechanism.unknowns.iter().enumerate() {
        add(
            Name::Unknown(body.first_unknown + index),
            &own.name,
            &own.ty,
        );
    }
    let first = body.own_lets();
    for (index, own) in mechanism.lets.iter().enumerate() {
        add(Name::Let(first + index), &own.name, &own.value.ty);
    }
    all
}

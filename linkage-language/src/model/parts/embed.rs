//! Content of a part, with the names and the frame of the mechanism around it.

use crate::diagnostic::OriginId;
use crate::model::symbols::part_frame::PartFrame;
use crate::model::symbols::part_scopes::{PartBody, PartScope};
use crate::model::types::{
    Constant, Expr, ExprKind, Let, Loop, MechanismPart, Name, Parameter, Placed, Unknown,
};

/// Translates expressions of a part for the mechanism around it.
pub(in crate::model) struct Embedding<'p> {
    name: &'p str,
    pub(super) body: &'p PartBody,
    /// Its inputs here. An input that is given a plain name becomes that name.
    inputs: Vec<Name>,
    pub(super) frame: PartFrame,
}

impl<'p> Embedding<'p> {
    /// `lets` has all derived quantities that come before the part's own.
    pub(in crate::model) fn new(
        part: &'p PartScope,
        lets: &[Let],
        placed: &[Placed],
    ) -> Option<Self> {
        let body = part.body.as_ref()?;
        let inputs = (0..body.mechanism().inputs.len()).map(|input| {
            let quantity = body.input(input);
            let value = lets
                .get(quantity)
                .and_then(|quantity| quantity.value.as_name());
            value.unwrap_or(Name::Let(quantity))
        });
        let mut placed = placed.iter().filter(|placed| placed.path == part.name);
        let frame = placed.next().map_or_else(PartFrame::default, Placed::frame);
        Some(Self {
            name: &part.name,
            inputs: inputs.collect(),
            body,
            frame,
        })
    }

    /// A name of the part, with the part in front.
    pub(super) fn text(&self, name: &str) -> String {
        format!("{}.{name}", self.name)
    }

    pub(super) fn origin(&self, origin: OriginId) -> OriginId {
        origin.in_part(self.body.first_origin)
    }

    /// Returns the meaning of a name of the part here. An argument that is not given is a mistake,
    /// which has been reported.
    fn meant(&self, name: Name) -> ExprKind {
        let body = self.body;
        let meaning = match name {
            Name::Const(index) => Some(Name::Const(body.first_constant + index)),
            Name::Parameter(index) => body.parameters[index],
            Name::Input(index) => Some(self.inputs[index]),
            Name::Unknown(index) => Some(Name::Unknown(body.first_unknown + index)),
            Name::Let(index) => Some(Name::Let(body.own_lets() + index)),
            Name::Argument(index) => match (body.arguments[index], &body.rates[index]) {
                (None, Some(Ok(rate))) => return rate.kind.clone(),
                (given, _) => given,
            },
            Name::Pi => Some(Name::Pi),
        };
        meaning.map_or(ExprKind::Error, ExprKind::Name)
    }

    /// An expression of the part in its own frame.
    pub(in crate::model) fn expr(&self, expr: &Expr) -> Expr {
        let boxed = |expr: &Expr| Box::new(self.expr(expr));
        let translated = |list: &[Expr]| list.iter().map(|expr| self.expr(expr)).collect();
        let kind = match &expr.kind {
            ExprKind::Name(name) => self.meant(*name),
            ExprKind::Vector(components) => ExprKind::Vector(translated(components)),
            ExprKind::Component(expr, index) => ExprKind::Component(boxed(expr), *index),
            ExprKind::Index(expr, index) => ExprKind::Index(boxed(expr), *index),
            ExprKind::Negate(expr) => ExprKind::Negate(boxed(expr)),
            ExprKind::Binary(operator, a, b) => ExprKind::Binary(*operator, boxed(a), boxed(b)),
            ExprKind::Call(function, arguments) => ExprKind::Call(*function, translated(arguments)),
            ExprKind::MotionLaw(course) => ExprKind::MotionLaw(course.map(|expr| self.expr(expr), |expr| self.origin(expr))),
            ExprKind::Number(_)
            | ExprKind::Error
            // Functions do not come along with a part.
            | ExprKind::Derivative(..)
            | ExprKind::InputDerivative(..)
            | ExprKind::Sensitivity(..)
            | ExprKind::Margin
            | ExprKind::Picture(_)
            | ExprKind::Mechanics(_) => expr.kind.clone(),
        };
        Expr {
            kind,
            ty: expr.ty.clone(),
            origin: self.origin(expr.origin),
        }
    }

    pub(in crate::model) fn constants(&self) -> impl Iterator<Item = Constant> {
        let constants = self.body.mechanism().constants.iter();
        constants.map(|constant| Constant {
            name: self.text(&constant.name),
            value: self.expr(&constant.value),
        })
    }

    /// Those that are not given.
    pub(in crate::model) fn parameters(&self) -> Vec<Parameter> {
        let parameters = self.body.mechanism().parameters.iter();
        let open = parameters.zip(&self.body.parameters);
        let open = open.filter(|(_, name)| matches!(name, Some(Name::Parameter(_))));
        let parameters = open.map(|(parameter, _)| Parameter {
            name: self.text(&parameter.name),
            origin: self.origin(parameter.origin),
            // The part's own struct reports it.
            may_be_unused: true,
            nominal: self.expr(&parameter.nominal),
            tolerances: parameter
                .tolerances
                .iter()
                .map(|tolerance| tolerance.as_ref().map(|value| self.expr(value)))
                .collect(),
            ..parameter.clone()
        });
        parameters.collect()
    }

    pub(in crate::model) fn unknowns(&self) -> impl Iterator<Item = Unknown> {
        let unknowns = self.body.mechanism().unknowns.iter();
        unknowns.map(|unknown| Unknown {
            name: self.text(&unknown.name),
            ty: unknown.ty.clone(),
            estimate: unknown
                .estimate
                .as_ref()
                .map(|estimate| self.expr(estimate)),
            of_part: true,
            origin: self.origin(unknown.origin),
        })
    }

    pub(in crate::model) fn lets(&self) -> impl Iterator<Item = Let> {
        let lets = self.body.mechanism().lets.iter();
        lets.map(|item| Let {
            name: self.text(&item.name),
            value: self.expr(&item.value),
            is_unknown_frame: item.is_unknown_frame,
        })
    }

    pub(in crate::model) fn loops(&self) -> impl Iterator<Item = Loop> {
        let equations = self.body.mechanism().loops.iter();
        equations.map(|equation| Loop {
            left: self.expr(&equation.left),
            right: self.expr(&equation.right),
            origin: self.origin(equation.origin),
            of: equation
                .of
                .as_ref()
                .map(|of| of.renamed(|name| self.text(name))),
        })
    }

    /// Returns the facts about the part for later phases.
    pub(in crate::model) fn as_part(&self) -> MechanismPart {
        let mechanism = self.body.mechanism();
        MechanismPart {
            name: self.name.to_owned(),
            mechanism: mechanism.name.clone(),
            inputs: (0..mechanism.inputs.len())
                .map(|input| self.body.input(input))
                .collect(),
            parameters: self.body.parameters.iter().copied().flatten().collect(),
            unknowns: self.body.first_unknown..self.body.first_unknown + mechanism.unknowns.len(),
            inner: mechanism.paths_of_parts(),
        }
    }

    /// Returns the parts within it that have frames. Its loops come after `loops` others.
    pub(in crate::model) fn placed(&self, loops: usize) -> impl Iterator<Item = Placed> {
        let placed = self.body.mechanism().placed.iter();
        placed.map(move |part| Placed {
            path: self.text(&part.path),
            at: part.at.as_ref().map(|at| self.expr(at)),
            turned: part.turned.as_ref().map(|angle| self.expr(angle)),
            loops: loops + part.loops.start..loops + part.loops.end,
        })
    }
}

//! Parts: what a mechanism within another consists of, under other names and in another frame.

use crate::diagnostic::OriginId;
use crate::model::symbols::part_frame::PartFrame;
use crate::model::symbols::part_scopes::{PartBody, PartScope};
use crate::model::types::{
    Constant, Expr, ExprKind, Let, Loop, MechanismPart, Name, Parameter, Placed, Unknown,
};

/// How a part's expressions are read in the mechanism around it.
pub(in crate::model) struct Embedding<'p> {
    name: &'p str,
    pub(super) body: &'p PartBody,
    /// What its inputs are: other names, where they are nothing else.
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
            let own = body.input(input);
            let value = lets.get(own).and_then(|own| own.value.as_name());
            value.unwrap_or(Name::Let(own))
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
    pub(super) fn text(&self, own: &str) -> String {
        format!("{}.{own}", self.name)
    }

    pub(super) fn origin(&self, own: OriginId) -> OriginId {
        own.in_part(self.body.first_origin)
    }

    /// What a name of the part is; a mistake for an argument that is not given, which has been reported.
    fn meant(&self, name: Name) -> ExprKind {
        let body = self.body;
        let own = match name {
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
        own.map_or(ExprKind::Error, ExprKind::Name)
    }

    /// An expression of the part in its own frame.
    pub(in crate::model) fn expr(&self, own: &Expr) -> Expr {
        let boxed = |own: &Expr| Box::new(self.expr(own));
        let all = |own: &[Expr]| own.iter().map(|own| self.expr(own)).collect();
        let kind = match &own.kind {
            ExprKind::Name(name) => self.meant(*name),
            ExprKind::Vector(components) => ExprKind::Vector(all(components)),
            ExprKind::Component(own, index) => ExprKind::Component(boxed(own), *index),
            ExprKind::Index(own, index) => ExprKind::Index(boxed(own), *index),
            ExprKind::Negate(own) => ExprKind::Negate(boxed(own)),
            ExprKind::Binary(operator, a, b) => ExprKind::Binary(*operator, boxed(a), boxed(b)),
            ExprKind::Call(function, arguments) => ExprKind::Call(*function, all(arguments)),
            ExprKind::MotionLaw(course) => ExprKind::MotionLaw(course.map(|own| self.expr(own), |own| self.origin(own))),
            ExprKind::Number(_)
            | ExprKind::Error
            // Functions do not come along with a part.
            | ExprKind::Derivative(..)
            | ExprKind::InputDerivative(..)
            | ExprKind::Sensitivity(..)
            | ExprKind::Margin
            | ExprKind::Picture(_)
            | ExprKind::Mechanics(_) => own.kind.clone(),
        };
        Expr {
            kind,
            ty: own.ty.clone(),
            origin: self.origin(own.origin),
        }
    }

    pub(in crate::model) fn constants(&self) -> impl Iterator<Item = Constant> {
        let own = self.body.mechanism().constants.iter();
        own.map(|own| Constant {
            name: self.text(&own.name),
            value: self.expr(&own.value),
        })
    }

    /// Those that are not given.
    pub(in crate::model) fn parameters(&self) -> Vec<Parameter> {
        let all = self.body.mechanism().parameters.iter();
        let open = all.zip(&self.body.parameters);
        let open = open.filter(|(_, name)| matches!(name, Some(Name::Parameter(_))));
        let parameters = open.map(|(own, _)| Parameter {
            name: self.text(&own.name),
            origin: self.origin(own.origin),
            // The part's own struct tells.
            may_be_unused: true,
            nominal: self.expr(&own.nominal),
            tolerances: own
                .tolerances
                .iter()
                .map(|own| own.as_ref().map(|own| self.expr(own)))
                .collect(),
            ..own.clone()
        });
        parameters.collect()
    }

    pub(in crate::model) fn unknowns(&self) -> impl Iterator<Item = Unknown> {
        let own = self.body.mechanism().unknowns.iter();
        own.map(|own| Unknown {
            name: self.text(&own.name),
            ty: own.ty.clone(),
            estimate: own.estimate.as_ref().map(|own| self.expr(own)),
            of_part: true,
            origin: self.origin(own.origin),
        })
    }

    pub(in crate::model) fn lets(&self) -> impl Iterator<Item = Let> {
        let own = self.body.mechanism().lets.iter();
        own.map(|own| Let {
            name: self.text(&own.name),
            value: self.expr(&own.value),
            is_unknown_frame: own.is_unknown_frame,
        })
    }

    pub(in crate::model) fn loops(&self) -> impl Iterator<Item = Loop> {
        let own = self.body.mechanism().loops.iter();
        own.map(|own| Loop {
            left: self.expr(&own.left),
            right: self.expr(&own.right),
            origin: self.origin(own.origin),
        })
    }

    /// What is known of it as a part.
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

    /// The parts within it that have frames of their own; its loops stand behind so many others.
    pub(in crate::model) fn placed(&self, loops: usize) -> impl Iterator<Item = Placed> {
        let own = self.body.mechanism().placed.iter();
        own.map(move |own| Placed {
            path: self.text(&own.path),
            at: own.at.as_ref().map(|own| self.expr(own)),
            turned: own.turned.as_ref().map(|own| self.expr(own)),
            loops: loops + own.loops.start..loops + own.loops.end,
        })
    }
}

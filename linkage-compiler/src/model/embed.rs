//! Parts: what a mechanism within another consists of, under other names and in another frame.

use super::part::{PartBody, PartScope};
use super::part_frame::PartFrame;
use super::types::{
    Between, Body, Constant, Element, Expr, ExprKind, Inertia, Joint, Let, Load, Loop, Name,
    Parameter, Part, Placed, Unknown,
};
use crate::diagnostic::OriginId;

/// How a part's expressions are read in the mechanism around it.
pub(super) struct Embedding<'p> {
    name: &'p str,
    body: &'p PartBody,
    /// What its inputs are: other names, where they are nothing else.
    inputs: Vec<Name>,
    frame: PartFrame,
}

/// What numbers of bodies and joints of a part are in the mechanism around it.
#[derive(Clone, Copy)]
pub(super) struct MemberNumbers {
    pub(super) first_body: usize,
    pub(super) bodies: usize,
    pub(super) first_closing: usize,
    /// The body that the part's fixed link is.
    pub(super) on: Option<usize>,
}

impl<'p> Embedding<'p> {
    /// `lets` has all derived quantities that come before the part's own.
    pub(super) fn new(part: &'p PartScope, lets: &[Let], placed: &[Placed]) -> Option<Self> {
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
    fn text(&self, own: &str) -> String {
        format!("{}.{own}", self.name)
    }

    fn origin(&self, own: OriginId) -> OriginId {
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
    pub(super) fn expr(&self, own: &Expr) -> Expr {
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
            ExprKind::Course(course) => ExprKind::Course(course.map(|own| self.expr(own), |own| self.origin(own))),
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

    pub(super) fn constants(&self) -> impl Iterator<Item = Constant> {
        let own = self.body.mechanism().constants.iter();
        own.map(|own| Constant {
            name: self.text(&own.name),
            value: self.expr(&own.value),
        })
    }

    /// Those that are not given.
    pub(super) fn parameters(&self) -> Vec<Parameter> {
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

    pub(super) fn unknowns(&self) -> impl Iterator<Item = Unknown> {
        let own = self.body.mechanism().unknowns.iter();
        own.map(|own| Unknown {
            name: self.text(&own.name),
            ty: own.ty.clone(),
            estimate: own.estimate.as_ref().map(|own| self.expr(own)),
            of_part: true,
            origin: self.origin(own.origin),
        })
    }

    pub(super) fn lets(&self) -> impl Iterator<Item = Let> {
        let own = self.body.mechanism().lets.iter();
        own.map(|own| Let {
            name: self.text(&own.name),
            value: self.expr(&own.value),
            is_unknown_frame: own.is_unknown_frame,
        })
    }

    pub(super) fn loops(&self) -> impl Iterator<Item = Loop> {
        let own = self.body.mechanism().loops.iter();
        own.map(|own| Loop {
            left: self.expr(&own.left),
            right: self.expr(&own.right),
            origin: self.origin(own.origin),
        })
    }

    /// What is known of it as a part.
    pub(super) fn part(&self) -> Part {
        let mechanism = self.body.mechanism();
        Part {
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
    pub(super) fn placed(&self, loops: usize) -> impl Iterator<Item = Placed> {
        let own = self.body.mechanism().placed.iter();
        own.map(move |own| Placed {
            path: self.text(&own.path),
            at: own.at.as_ref().map(|own| self.expr(own)),
            turned: own.turned.as_ref().map(|own| self.expr(own)),
            loops: loops + own.loops.start..loops + own.loops.end,
        })
    }
}

/// Bodies and what acts on them, where the part stands.
impl Embedding<'_> {
    fn vector(&self, own: &Expr) -> Expr {
        self.frame.seen(self.expr(own))
    }

    /// A point at which something is; zero is the part's origin.
    fn point(&self, own: &Expr) -> Expr {
        self.frame.seen_point(self.expr(own))
    }

    pub(super) fn gravity(&self) -> Option<Expr> {
        let own = self.body.mechanism().gravity.as_ref();
        own.map(|own| self.expr(own))
    }

    pub(super) fn bodies(&self, members: MemberNumbers) -> impl Iterator<Item = Body> {
        let own = self.body.mechanism().bodies.iter();
        own.map(move |own| Body {
            name: self.text(&own.name),
            joint: members.joint(own.joint),
            turns: own
                .turns
                .as_ref()
                .map(|own| self.frame.turning(self.expr(own))),
            masses: own
                .masses
                .iter()
                .map(|(mass, at)| (self.expr(mass), self.point(at)))
                .collect(),
            inertias: own
                .inertias
                .iter()
                .map(|(inertia, at)| {
                    let at = at.as_ref().map(|at| self.point(at));
                    (self.inertia(inertia), at)
                })
                .collect(),
            origin: self.origin(own.origin),
        })
    }

    /// In the axes of the body, wherever the part stands.
    fn inertia(&self, own: &Inertia) -> Inertia {
        match own {
            Inertia::Scalar(own) => Inertia::Scalar(self.expr(own)),
            Inertia::Tensor(rows) => {
                let rows = rows
                    .each_ref()
                    .map(|row| row.each_ref().map(|own| self.expr(own)));
                Inertia::Tensor(Box::new(rows))
            }
        }
    }

    /// Those that its bodies hang on, or those that close loops.
    pub(super) fn joints(
        &self,
        members: MemberNumbers,
        hanging: bool,
    ) -> impl Iterator<Item = Joint> {
        let all = self.body.mechanism().joints.iter().enumerate();
        let own = all.filter(move |(index, _)| (*index < members.bodies) == hanging);
        own.map(move |(_, own)| Joint {
            name: own.name.as_ref().map(|own| self.text(own)),
            kind: own.kind,
            body: members.first_body + own.body,
            on: members.body(own.on),
            at: self.point(&own.at),
            direction: own.direction.as_ref().map(|own| self.vector(own)),
            origin: self.origin(own.origin),
        })
    }

    pub(super) fn loads(&self, members: MemberNumbers) -> impl Iterator<Item = Load> {
        let own = self.body.mechanism().loads.iter();
        own.map(move |own| Load {
            value: self.vector(&own.value),
            on: members.body(own.on),
            from: members.body(own.from),
            at: own.at.as_ref().map(|own| self.point(own)),
        })
    }

    pub(super) fn elements(&self, members: MemberNumbers) -> impl Iterator<Item = Element> {
        let own = self.body.mechanism().elements.iter();
        own.map(move |own| Element {
            kind: own.kind,
            value: self.expr(&own.value),
            between: match &own.between {
                Between::Points(ends) => Between::Points(
                    ends.each_ref()
                        .map(|(body, at)| (members.body(*body), self.point(at))),
                ),
                Between::Joint(joint) => Between::Joint(members.joint(*joint)),
            },
            free: own.free.as_ref().map(|own| self.expr(own)),
            origin: self.origin(own.origin),
        })
    }
}

impl MemberNumbers {
    fn body(self, own: Option<usize>) -> Option<usize> {
        own.map_or(self.on, |own| Some(self.first_body + own))
    }

    fn joint(self, own: usize) -> usize {
        match own.checked_sub(self.bodies) {
            None => self.first_body + own,
            Some(closing) => self.first_closing + closing,
        }
    }
}

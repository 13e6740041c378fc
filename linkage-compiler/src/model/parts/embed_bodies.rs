//! Bodies, joints and loads of a part, in the frame and with the numbers of the mechanism around it.

use super::embed::Embedding;
use crate::model::types::{Between, Body, Element, Expr, Inertia, Joint, Load};

/// What numbers of bodies and joints of a part are in the mechanism around it.
#[derive(Clone, Copy)]
pub(in crate::model) struct MemberNumbers {
    pub(in crate::model) first_body: usize,
    pub(in crate::model) bodies: usize,
    pub(in crate::model) first_closing: usize,
    /// The body that the part's fixed link is.
    pub(in crate::model) on: Option<usize>,
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

    pub(in crate::model) fn gravity(&self) -> Option<Expr> {
        let own = self.body.mechanism().gravity.as_ref();
        own.map(|own| self.expr(own))
    }

    pub(in crate::model) fn bodies(&self, members: MemberNumbers) -> impl Iterator<Item = Body> {
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
    pub(in crate::model) fn joints(
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

    pub(in crate::model) fn loads(&self, members: MemberNumbers) -> impl Iterator<Item = Load> {
        let own = self.body.mechanism().loads.iter();
        own.map(move |own| Load {
            value: self.vector(&own.value),
            on: members.body(own.on),
            from: members.body(own.from),
            at: own.at.as_ref().map(|own| self.point(own)),
        })
    }

    pub(in crate::model) fn elements(
        &self,
        members: MemberNumbers,
    ) -> impl Iterator<Item = Element> {
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

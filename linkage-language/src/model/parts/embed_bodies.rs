//! Bodies, joints, loads, arcs and links of a part, in the frame and with the numbers of the mechanism around.

use super::embed::Embedding;
use crate::model::types::{
    Arc, Between, Body, Contact, Element, Expr, Friction, Inertia, Joint, LinkElements, Load,
    PairOfWheels, PairedWheel, RigidLink, StraightSlot,
};

/// Numbers of bodies and joints of a part in the mechanism around it.
#[derive(Clone, Copy)]
pub(in crate::model) struct MemberNumbers {
    pub(in crate::model) first_body: usize,
    pub(in crate::model) bodies: usize,
    pub(in crate::model) first_closing: usize,
    /// The body that the part's fixed link is.
    pub(in crate::model) on: Option<usize>,
}

/// Bodies and loads, at the location of the part.
impl Embedding<'_> {
    fn vector(&self, value: &Expr) -> Expr {
        self.frame.seen(self.expr(value))
    }

    /// A point at which something is; zero is the part's origin.
    fn point(&self, value: &Expr) -> Expr {
        self.frame.seen_point(self.expr(value))
    }

    pub(in crate::model) fn gravity(&self) -> Option<Expr> {
        let gravity = self.body.mechanism().gravity.as_ref();
        gravity.map(|gravity| self.expr(gravity))
    }

    pub(in crate::model) fn bodies(&self, members: MemberNumbers) -> impl Iterator<Item = Body> {
        let bodies = self.body.mechanism().bodies.iter();
        bodies.map(move |body| Body {
            name: self.text(&body.name),
            joint: members.joint(body.joint),
            turns: body
                .turns
                .as_ref()
                .map(|turns| self.frame.turning(self.expr(turns))),
            masses: body
                .masses
                .iter()
                .map(|(mass, at)| (self.expr(mass), self.point(at)))
                .collect(),
            inertias: body
                .inertias
                .iter()
                .map(|(inertia, at)| {
                    let at = at.as_ref().map(|at| self.point(at));
                    (self.inertia(inertia), at)
                })
                .collect(),
            origin: self.origin(body.origin),
        })
    }

    /// Returns an inertia in the axes of the body. It does not depend on the location of the part.
    fn inertia(&self, inertia: &Inertia) -> Inertia {
        match inertia {
            Inertia::Scalar(inertia) => Inertia::Scalar(self.expr(inertia)),
            Inertia::Tensor(rows) => {
                let rows = rows
                    .each_ref()
                    .map(|row| row.each_ref().map(|entry| self.expr(entry)));
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
        let joints = self.body.mechanism().joints.iter().enumerate();
        let joints = joints.filter(move |(index, _)| (*index < members.bodies) == hanging);
        joints.map(move |(_, joint)| Joint {
            name: joint.name.as_ref().map(|name| self.text(name)),
            kind: joint.kind,
            body: members.first_body + joint.body,
            on: members.body(joint.on),
            at: self.point(&joint.at),
            direction: joint.direction.as_ref().map(|vector| self.vector(vector)),
            origin: self.origin(joint.origin),
        })
    }

    pub(in crate::model) fn arcs(&self) -> impl Iterator<Item = Arc> {
        let arcs = self.body.mechanism().arcs.iter();
        arcs.map(|arc| Arc {
            name: self.text(&arc.name),
            slider: self.point(&arc.slider),
            centre: self.point(&arc.centre),
            direction: self.vector(&arc.direction),
        })
    }

    pub(in crate::model) fn link_elements(&self) -> LinkElements {
        let elements = &self.body.mechanism().link_elements;
        let links = elements.links.iter().map(|link| RigidLink {
            name: self.text(&link.name),
            joints: link.joints.iter().map(|joint| self.point(joint)).collect(),
        });
        let slots = elements.slots.iter().map(|slot| StraightSlot {
            name: self.text(&slot.name),
            slider: self.point(&slot.slider),
            start: self.point(&slot.start),
            direction: self.vector(&slot.direction),
        });
        let wheel = |wheel: &PairedWheel| PairedWheel {
            centre: self.point(&wheel.centre),
            direction: wheel.direction.as_ref().map(|vector| self.vector(vector)),
        };
        let pairs = elements.pairs.iter().map(|pair| PairOfWheels {
            wheels: pair.wheels.each_ref().map(wheel),
            touch: pair.touch,
        });
        LinkElements {
            links: links.collect(),
            slots: slots.collect(),
            pairs: pairs.collect(),
        }
    }

    pub(in crate::model) fn loads(&self, members: MemberNumbers) -> impl Iterator<Item = Load> {
        let loads = self.body.mechanism().loads.iter();
        loads.map(move |load| Load {
            value: self.vector(&load.value),
            on: members.body(load.on),
            from: members.body(load.from),
            at: load.at.as_ref().map(|point| self.point(point)),
        })
    }

    pub(in crate::model) fn elements(
        &self,
        members: MemberNumbers,
    ) -> impl Iterator<Item = Element> {
        let elements = self.body.mechanism().elements.iter();
        elements.map(move |element| Element {
            kind: element.kind,
            value: self.expr(&element.value),
            between: match &element.between {
                Between::Points(ends) => Between::Points(
                    ends.each_ref()
                        .map(|(body, at)| (members.body(*body), self.point(at))),
                ),
                Between::Joint(joint) => Between::Joint(members.joint(*joint)),
            },
            free: element.free.as_ref().map(|free| self.expr(free)),
            origin: self.origin(element.origin),
        })
    }
}

/// Friction, which does not depend on the location of the part.
impl Embedding<'_> {
    pub(in crate::model) fn frictions(
        &self,
        members: MemberNumbers,
    ) -> impl Iterator<Item = Friction> {
        let frictions = self.body.mechanism().frictions.iter();
        frictions.map(move |friction| Friction {
            coefficient: self.expr(&friction.coefficient),
            joint: members.joint(friction.joint),
            contact: match &friction.contact {
                Contact::Pin(radius) => Contact::Pin(self.expr(radius)),
                Contact::Guide(length) => {
                    Contact::Guide(length.as_ref().map(|length| self.expr(length)))
                }
            },
            origin: self.origin(friction.origin),
        })
    }
}

impl MemberNumbers {
    fn body(self, body: Option<usize>) -> Option<usize> {
        body.map_or(self.on, |body| Some(self.first_body + body))
    }

    fn joint(self, joint: usize) -> usize {
        match joint.checked_sub(self.bodies) {
            None => self.first_body + joint,
            Some(closing) => self.first_closing + closing,
        }
    }
}

//! Forces, torques, springs, dampers.

use super::super::names::Resolver;
use super::super::types::{Between, Body, Dimension, Element, ElementKind, Expr, Load, Type};
use super::CONTEXT;
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, ElementItem, JointKind, LoadItem, Member, Word};

/// What a value must be, and how one is written.
#[derive(Clone, Copy)]
struct Measure {
    dimension: Dimension,
    example: &'static str,
}

impl Measure {
    fn new(dimension: Dimension, example: &'static str) -> Self {
        Self { dimension, example }
    }
}

impl Resolver<'_> {
    /// `force vector on BODY [from BODY] at point;`
    pub(super) fn force_item(&mut self, item: &LoadItem) -> Load {
        let [on, from] = self.two_bodies(item);
        let at = item.at.as_ref().map(|at| self.point_clause(at));
        if at.is_none() {
            let help = "name the point where it acts: `at p`";
            self.diagnostics
                .error_with_help(item.span, "a `force` without `at`", help);
        }
        let value = self.vector_clause(&item.value, Some(Dimension::FORCE), "force", "(0, -500N)");
        self.load(value, [on, from], at)
    }

    /// `torque moment on BODY [from BODY];`
    pub(super) fn torque_item(&mut self, item: &LoadItem) -> Load {
        let bodies = self.two_bodies(item);
        if let Some(at) = &item.at {
            let fact = "a `torque` acts on a body, wherever";
            self.diagnostics
                .error_with_help(at.span, fact, "leave out `at`");
        }
        let value = match self.mechanics.components {
            Some(3) => self.vector_clause(
                &item.value,
                Some(Dimension::MOMENT),
                "torque",
                "(0, 0, 3N*mm)",
            ),
            _ => self.scalar_clause(&item.value, Dimension::MOMENT, "torque", "3N*mm"),
        };
        self.load(value, bodies, None)
    }

    fn load(&mut self, value: Expr, [on, from]: [Option<usize>; 2], at: Option<Expr>) -> Load {
        Load {
            value,
            on,
            from,
            at,
        }
    }

    fn two_bodies(&mut self, item: &LoadItem) -> [Option<usize>; 2] {
        let on = self.body_named(&item.on);
        let from = match &item.from {
            Some(from) => self.body_named(from),
            None => Some(None),
        };
        self.different(on, from, &item.on, item.span);
        [on.flatten(), from.flatten()]
    }

    /// Reports what would act between a body and itself.
    fn different(
        &mut self,
        first: Option<Option<usize>>,
        second: Option<Option<usize>>,
        name: &Member,
        span: SourceSpan,
    ) {
        if first.is_none() || first != second {
            return;
        }
        let fact = match first.flatten() {
            Some(_) => format!("this acts between `{name}` and itself, which has no effect"),
            None => "this acts on `frame` alone, which has no effect".to_owned(),
        };
        let help = "name a body that moves, and another or none";
        self.diagnostics.error_with_help(span, fact, help);
    }

    /// `spring stiffness BETWEEN [, free length];`
    pub(super) fn spring_item(&mut self, item: &ElementItem, bodies: &[Body]) -> Element {
        let before = self.diagnostics.len();
        let (between, turning) = self.between(item);
        if turning == Some(true) && self.diagnostics.len() == before {
            self.refuse_without_angle(&between, bodies, item.span);
        }
        let (stiffness, free_of) = match turning.unwrap_or_default() {
            true => (
                Measure::new(Dimension::MOMENT, "300N*mm"),
                Measure::new(Dimension::ANGLE, "20deg"),
            ),
            false => (
                Measure::new(Dimension::of(-1, 1, 0), "2.5N/mm"),
                Measure::new(Dimension::LENGTH, "40mm"),
            ),
        };
        let known = turning.is_some();
        let value = self.element_clause(&item.value, known, stiffness, "spring");
        let free = item.free.as_ref();
        let free = free.map(|length| self.element_clause(length, known, free_of, "free"));
        Element {
            kind: ElementKind::Spring,
            value,
            between,
            free,
            origin: self.origins.add(item.span),
        }
    }

    /// In space the angle of a pin is known if a body hangs by it that turns with an angle; in the plane all angles are.
    fn refuse_without_angle(&mut self, between: &Between, bodies: &[Body], span: SourceSpan) {
        let (Between::Joint(joint), Some(3)) = (between, self.mechanics.components) else {
            return;
        };
        // Joints that bodies hang by have the numbers of the bodies.
        let help = match bodies.get(*joint).map(|body| &body.turns) {
            Some(Some(turns)) if matches!(turns.ty, Type::Scalar(_) | Type::Error) => return,
            Some(_) => "let the body turn with that angle: `turns phi`",
            None => "let one of its bodies hang by this pin and turn with that angle: `turns phi`",
        };
        let fact = "a spring in a pin of space needs the angle about its axis";
        self.diagnostics.error_with_help(span, fact, help);
    }

    /// `damper damping BETWEEN;`
    pub(super) fn damper_item(&mut self, item: &ElementItem) -> Element {
        let (between, turning) = self.between(item);
        let damping = match turning.unwrap_or_default() {
            true => Measure::new(Dimension::of(1, 1, 1), "5N*mm*s"),
            false => Measure::new(Dimension::of(-1, 1, 1), "0.2N*s/mm"),
        };
        let value = self.element_clause(&item.value, turning.is_some(), damping, "damper");
        if let Some(free) = &item.free {
            let fact = "a `damper` has no length without force";
            self.diagnostics
                .error_with_help(free.span, fact, "leave out `free`");
        }
        Element {
            kind: ElementKind::Damper,
            value,
            between,
            free: None,
            origin: self.origins.add(item.span),
        }
    }

    /// A value of a spring or damper. Where its joint is not known, nothing is said of the dimension.
    fn element_clause(
        &mut self,
        value: &syntax::Expr,
        joint_is_known: bool,
        measure: Measure,
        word: &str,
    ) -> Expr {
        match joint_is_known {
            true => self.scalar_clause(value, measure.dimension, word, measure.example),
            false => self.expression(value, CONTEXT),
        }
    }

    /// Where a spring or damper is, and whether it acts on an angle, if that is known.
    fn between(&mut self, item: &ElementItem) -> (Between, Option<bool>) {
        match &item.between {
            syntax::Between::Points(ends) => {
                let [(from, start), (to, end)] = &**ends;
                let (first, second) = (self.body_named(from), self.body_named(to));
                self.different(first, second, from, item.span);
                let ends = [
                    (first.flatten(), self.point_clause(start)),
                    (second.flatten(), self.point_clause(end)),
                ];
                (Between::Points(ends), Some(false))
            }
            syntax::Between::Joint(name) => {
                let joint = self.joint_named(name);
                let kind = joint.map(|joint| self.mechanics.joints[joint]);
                let turning = kind.map(|kind| match kind {
                    JointKind::Pin => true,
                    JointKind::Slide => false,
                    JointKind::Ball | JointKind::Cylinder | JointKind::Fixed => {
                        let fact = format!("`{name}` is a `{}`", kind.word());
                        let help = "springs and dampers act on a `pin`, on a `slide`, or between two points";
                        self.diagnostics.error_with_help(name.span, fact, help);
                        true
                    }
                });
                (Between::Joint(joint.unwrap_or_default()), turning)
            }
        }
    }
}

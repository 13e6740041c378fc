//! Forces, torques, springs, dampers and friction.

use super::ast::GravityItem;
use super::clauses::{Clause, ClauseRule, Clauses, Owner};
use super::expression::PlusMinus;
use super::expression_tree::{Expr, ExprKind};
use super::keyword::{ClauseWord, LoadWord};
use super::mechanics_tree::{Between, ElementItem, FrictionItem, LoadItem, Member};
use super::parser::{Parsed, Parser, Reported};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;

const BODY: &str = "the name of a body";

const FORCE: [ClauseRule; 3] = [
    ClauseRule::name(ClauseWord::On, BODY),
    ClauseRule::name(ClauseWord::From, BODY),
    ClauseRule::value(ClauseWord::At),
];

const TORQUE: [ClauseRule; 2] = [
    ClauseRule::name(ClauseWord::On, BODY),
    ClauseRule::name(ClauseWord::From, BODY),
];

const DAMPER: [ClauseRule; 3] = [
    ClauseRule::name(ClauseWord::From, BODY).with_point(),
    ClauseRule::name(ClauseWord::To, BODY).with_point(),
    ClauseRule::name(ClauseWord::On, "the name of a joint"),
];

const SPRING: [ClauseRule; 4] = [
    DAMPER[0],
    DAMPER[1],
    DAMPER[2],
    ClauseRule::value(ClauseWord::Free),
];

const FRICTION: [ClauseRule; 3] = [
    DAMPER[2],
    ClauseRule::value(ClauseWord::Radius),
    ClauseRule::value(ClauseWord::Length),
];

impl Parser<'_> {
    /// `= expr` after `gravity`.
    pub(super) fn gravity_item(&mut self, start: SourceSpan) -> Parsed<GravityItem> {
        self.equals("write `gravity = VECTOR;`")?;
        let value = self.sum(PlusMinus::JointIsMistake)?;
        let span = start.to(value.span);
        Ok(GravityItem { value, span })
    }

    /// `expr on BODY [from BODY] at expr` after `force`.
    pub(super) fn force_item(&mut self, span: SourceSpan) -> Parsed<LoadItem> {
        let owner = Owner {
            what: LoadWord::Force.word(),
            form: "force VECTOR on BODY at POINT",
            span,
        };
        let item = self.load(owner, &FORCE, &[ClauseWord::On, ClauseWord::At])?;
        // The missing clause has been reported.
        item.at.is_some().then_some(item).ok_or(Reported)
    }

    /// `expr on BODY [from BODY]` after `torque`.
    pub(super) fn torque_item(&mut self, span: SourceSpan) -> Parsed<LoadItem> {
        let owner = Owner {
            what: LoadWord::Torque.word(),
            form: "torque VALUE on BODY",
            span,
        };
        self.load(owner, &TORQUE, &[ClauseWord::On])
    }

    fn load(
        &mut self,
        owner: Owner,
        rules: &[ClauseRule],
        needed: &[ClauseWord],
    ) -> Parsed<LoadItem> {
        let value = self.load_value(owner)?;
        let mut clauses = self.clauses(owner, rules);
        self.require(&clauses, owner, needed);
        let on = clauses.take_name(ClauseWord::On).ok_or(Reported)?;
        Ok(LoadItem {
            value,
            on,
            from: clauses.take_name(ClauseWord::From),
            at: clauses.take_value(ClauseWord::At),
            span: owner.span.to(self.stream.previous_span()),
        })
    }

    /// Reads `expr from BODY at expr to BODY at expr [, free expr]` or `expr on JOINT [, free
    /// expr]` after `spring`.
    pub(super) fn spring_item(&mut self, span: SourceSpan) -> Parsed<ElementItem> {
        self.element(LoadWord::Spring, &SPRING, span)
    }

    /// `expr from BODY at expr to BODY at expr` or `expr on JOINT` after `damper`.
    pub(super) fn damper_item(&mut self, span: SourceSpan) -> Parsed<ElementItem> {
        self.element(LoadWord::Damper, &DAMPER, span)
    }

    /// `expr on JOINT [, radius expr] [, length expr]` after `friction`.
    pub(super) fn friction_item(&mut self, span: SourceSpan) -> Parsed<FrictionItem> {
        let owner = Owner {
            what: LoadWord::Friction.word(),
            form: "friction VALUE on PIN, radius VALUE` or `friction VALUE on SLIDE",
            span,
        };
        let coefficient = self.load_value(owner)?;
        let mut clauses = self.clauses(owner, &FRICTION);
        self.require(&clauses, owner, &[ClauseWord::On]);
        let joint = clauses.take_name(ClauseWord::On).ok_or(Reported)?;
        Ok(FrictionItem {
            coefficient,
            joint,
            radius: clauses.take_value(ClauseWord::Radius),
            length: clauses.take_value(ClauseWord::Length),
            span: span.to(self.stream.previous_span()),
        })
    }

    fn element(
        &mut self,
        word: LoadWord,
        rules: &[ClauseRule],
        span: SourceSpan,
    ) -> Parsed<ElementItem> {
        let what = word.word();
        let form =
            format!("{what} VALUE from BODY at POINT to BODY at POINT` or `{what} VALUE on JOINT");
        let form = form.as_str();
        let owner = Owner { what, form, span };
        let value = self.load_value(owner)?;
        let mut clauses = self.clauses(owner, rules);
        let between = self.between(owner, &mut clauses)?;
        Ok(ElementItem {
            value,
            between,
            free: clauses.take_value(ClauseWord::Free),
            span: span.to(self.stream.previous_span()),
        })
    }

    /// The value after the item's word; an error if nothing else is left of the item.
    fn load_value(&mut self, owner: Owner) -> Parsed<Expr> {
        let named = self.stream.ident(0).is_some() && self.stream.is_punct(1, '=');
        if named || self.stream.is_punct(0, '=') {
            self.lacks(owner, &format!("a {} has no name and no `=`", owner.what));
            self.stream.skip(1 + usize::from(named));
        }
        let value = self.clause_value(owner.what);
        match value.kind {
            ExprKind::Error if self.at_end_of_clauses() => Err(Reported),
            _ => Ok(value),
        }
    }

    fn between(&mut self, owner: Owner, clauses: &mut Clauses) -> Parsed<Between> {
        let what = owner.what;
        let words = [ClauseWord::On, ClauseWord::From, ClauseWord::To];
        let fact = match words.map(|word| clauses.take(word)) {
            _ if clauses.broken => return Err(Reported),
            [Some(on), None, None] => return on.name.map(Between::Joint).ok_or(Reported),
            [None, Some(from), Some(to)] => {
                let ends = end(from).zip(end(to));
                return ends
                    .map(|(from, to)| Between::Points(Box::new([from, to])))
                    .ok_or(Reported);
            }
            [None, None, None] => format!("the {what} lacks its ends"),
            [None, None, Some(_)] => format!("the {what} lacks `from`"),
            [None, Some(_), None] => format!("the {what} lacks `to`"),
            [Some(_), ..] => format!("a {what} has either `on`, or `from` and `to`"),
        };
        self.lacks(owner, &fact);
        Err(Reported)
    }
}

fn end(clause: Clause) -> Option<(Member, Expr)> {
    clause.name.zip(clause.point)
}

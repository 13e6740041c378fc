//! Forces, torques, springs and dampers.

use proc_macro2::Ident;

use super::ast::{Between, ElementItem, Expr, ExprKind, GravityItem, LoadItem, SourceSpan};
use super::clauses::{Clause, Clauses, Owner, Rule};
use super::expression::PlusMinus;
use super::parser::{Parsed, Parser, Reported};

const BODY: &str = "the name of a body";

const FORCE: [Rule; 3] = [
    Rule::name("on", BODY),
    Rule::name("from", BODY),
    Rule::value("at"),
];

const TORQUE: [Rule; 2] = [Rule::name("on", BODY), Rule::name("from", BODY)];

const DAMPER: [Rule; 3] = [
    Rule::name("from", BODY).with_point(),
    Rule::name("to", BODY).with_point(),
    Rule::name("on", "the name of a joint"),
];

const SPRING: [Rule; 4] = [DAMPER[0], DAMPER[1], DAMPER[2], Rule::value("free")];

impl Parser<'_> {
    /// `= expr` after `gravity`.
    pub(super) fn gravity(&mut self, start: SourceSpan) -> Parsed<GravityItem> {
        self.equals("write `gravity = VECTOR;`")?;
        let value = self.sum(PlusMinus::JointIsMistake)?;
        let span = start.to(value.span);
        Ok(GravityItem { value, span })
    }

    /// `expr on BODY [from BODY] at expr` after `force`; no `at` after `torque`.
    pub(super) fn load(&mut self, word: &str, span: SourceSpan) -> Parsed<LoadItem> {
        let is_force = word == "force";
        let (what, form, rules, needed): (_, _, &[Rule], &[&str]) = match is_force {
            true => (
                "force",
                "force VECTOR on BODY at POINT",
                &FORCE,
                &["on", "at"],
            ),
            false => ("torque", "torque VALUE on BODY", &TORQUE, &["on"]),
        };
        let owner = Owner { what, form, span };
        let value = self.load_value(word, owner)?;
        let mut clauses = self.clauses(owner, rules);
        self.require(&clauses, owner, needed);
        let at = clauses.take_value("at");
        let on = clauses.take_name("on");
        match on.filter(|_| at.is_some() == is_force) {
            Some(on) => Ok(LoadItem {
                value,
                on,
                from: clauses.take_name("from"),
                at,
                span: span.to(self.stream.previous_span()),
            }),
            None => Err(Reported),
        }
    }

    /// `expr from BODY at expr to BODY at expr` or `expr on JOINT` after `spring` or `damper`.
    pub(super) fn element(&mut self, word: &str, span: SourceSpan) -> Parsed<ElementItem> {
        let (what, rules): (_, &[Rule]) = match word {
            "spring" => ("spring", &SPRING),
            _ => ("damper", &DAMPER),
        };
        let form =
            format!("{word} VALUE from BODY at POINT to BODY at POINT` or `{word} VALUE on JOINT");
        let form = form.as_str();
        let owner = Owner { what, form, span };
        let value = self.load_value(word, owner)?;
        let mut clauses = self.clauses(owner, rules);
        let between = self.between(owner, &mut clauses)?;
        Ok(ElementItem {
            value,
            between,
            free: clauses.take_value("free"),
            span: span.to(self.stream.previous_span()),
        })
    }

    /// The value after the item's word; an error if nothing else is left of the item.
    fn load_value(&mut self, word: &str, owner: Owner) -> Parsed<Expr> {
        let named = self.stream.ident(0).is_some() && self.stream.is_punct(1, '=');
        if named || self.stream.is_punct(0, '=') {
            self.lacks(owner, &format!("a {} has no name and no `=`", owner.what));
            self.stream.skip(1 + usize::from(named));
        }
        let value = self.clause_value(word);
        match value.kind {
            ExprKind::Error if self.at_end_of_clauses() => Err(Reported),
            _ => Ok(value),
        }
    }

    fn between(&mut self, owner: Owner, clauses: &mut Clauses) -> Parsed<Between> {
        let what = owner.what;
        let fact = match ["on", "from", "to"].map(|word| clauses.take(word)) {
            _ if clauses.broken => return Err(Reported),
            [Some(on), None, None] => return on.name.map(Between::Joint).ok_or(Reported),
            [None, Some(from), Some(to)] => {
                let ends = end(from).zip(end(to));
                return ends
                    .map(|(from, to)| Between::Points([from, to]))
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

fn end(clause: Clause) -> Option<(Ident, Expr)> {
    clause.name.zip(clause.point)
}

//! Forces, torques, springs and dampers.

use proc_macro2::Ident;

use super::ast::{Between, ElementItem, Expr, GravityItem, LoadItem, SourceSpan};
use super::clauses::{Clause, Clauses, Rule};
use super::expression::PlusMinus;
use super::parser::{Parsed, Parser, Reported};

const BODY: &str = "the name of a body";

const ENDS: &str = "write `from BODY at POINT to BODY at POINT`, or `on JOINT`";

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
        self.equals()?;
        let value = self.sum(PlusMinus::JointIsMistake)?;
        let span = start.to(value.span);
        Ok(GravityItem { value, span })
    }

    /// `expr on BODY [from BODY] at expr` after `force`; no `at` after `torque`.
    pub(super) fn load(&mut self, word: &str, start: SourceSpan) -> Parsed<LoadItem> {
        let is_force = word == "force";
        let value = self.clause_value(word);
        let rules: &[Rule] = if is_force { &FORCE } else { &TORQUE };
        let mut clauses = self.clauses(word, rules);
        self.require(&clauses, word, start, ("on", "on BODY"));
        if is_force {
            self.require(&clauses, word, start, ("at", "at POINT"));
        }
        let at = clauses.take_value("at");
        let Some(on) = clauses.take_name("on") else {
            return Err(Reported);
        };
        if is_force && at.is_none() {
            return Err(Reported);
        }
        Ok(LoadItem {
            value,
            on,
            from: clauses.take_name("from"),
            at,
            span: start.to(self.stream.previous_span()),
        })
    }

    /// `expr from BODY at expr to BODY at expr` or `expr on JOINT` after `spring` or `damper`.
    pub(super) fn element(&mut self, word: &str, start: SourceSpan) -> Parsed<ElementItem> {
        let value = self.clause_value(word);
        let rules: &[Rule] = if word == "spring" { &SPRING } else { &DAMPER };
        let mut clauses = self.clauses(word, rules);
        let between = self.between(&mut clauses, word, start)?;
        Ok(ElementItem {
            value,
            between,
            free: clauses.take_value("free"),
            span: start.to(self.stream.previous_span()),
        })
    }

    fn between(&mut self, clauses: &mut Clauses, word: &str, start: SourceSpan) -> Parsed<Between> {
        let [on, from, to] = ["on", "from", "to"].map(|word| clauses.take(word));
        let fact = match (&on, &from, &to) {
            _ if clauses.broken => return Err(Reported),
            (Some(on), Some(_), _) | (Some(on), _, Some(_)) => {
                let fact = format!("`on` and points in one `{word}`");
                return self.fail_at(on.span, fact, ENDS);
            }
            (None, None, None) => format!("the `{word}` has no ends"),
            (None, None, Some(_)) => format!("the `{word}` lacks `from`"),
            (None, Some(_), None) => format!("the `{word}` lacks `to`"),
            _ => String::new(),
        };
        match (on, from.and_then(end), to.and_then(end)) {
            (
                Some(Clause {
                    name: Some(joint), ..
                }),
                None,
                None,
            ) => Ok(Between::Joint(joint)),
            (None, Some(from), Some(to)) => Ok(Between::Points([from, to])),
            _ => self.fail_at(start, fact, ENDS),
        }
    }
}

fn end(clause: Clause) -> Option<(Ident, Expr)> {
    clause.name.zip(clause.point)
}

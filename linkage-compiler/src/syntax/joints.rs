//! Bodies, and the joints that they hang on or that close loops.

use proc_macro2::{Ident, Span};

use super::ast::{
    Attribute, BodyItem, Expr, InertiaPart, Item, JointItem, JointKind, JointPart, MassPart,
    SourceSpan,
};
use super::clauses::{Clause, Clauses, Rule};
use super::parser::{Parsed, Parser};
use crate::diagnostic::text::nearest;

const KINDS: [(&str, JointKind); 5] = [
    ("pin", JointKind::Pin),
    ("slide", JointKind::Slide),
    ("ball", JointKind::Ball),
    ("cylinder", JointKind::Cylinder),
    ("fixed", JointKind::Fixed),
];

const ON: Rule = Rule::name("on", "the name of a body");
const AT: Rule = Rule::value("at");
const ALONG: Rule = Rule::value("along");
const ABOUT: Rule = Rule::value("about");

/// What a body has besides its joint.
const BODY: [Rule; 3] = [
    Rule::value("turns"),
    Rule::value("mass").with_point().repeated(),
    Rule::value("inertia").with_optional_point().repeated(),
];

fn joint_rules(kind: JointKind) -> &'static [Rule] {
    match kind {
        JointKind::Pin => &[ON, AT, ABOUT],
        JointKind::Slide => &[ON, AT, ALONG],
        JointKind::Ball | JointKind::Fixed => &[ON, AT],
        JointKind::Cylinder => &[ON, AT, ALONG, ABOUT],
    }
}

/// The joint's kind, its word and its place.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    kind: JointKind,
    word: &'static str,
    span: SourceSpan,
}

impl Kind {
    pub(super) fn find(word: &str, span: SourceSpan) -> Option<Self> {
        let found = KINDS.into_iter().find(|(known, _)| *known == word);
        found.map(|(word, kind)| Kind { kind, word, span })
    }
}

impl Parser<'_> {
    /// `NAME = JOINT, CLAUSES ;` after `body`, and whether its end has been reached.
    pub(super) fn body_item(&mut self, attributes: Vec<Attribute>) -> Parsed<(Item, bool)> {
        let name = self.name("a name after `body`")?;
        let mut body = BodyItem {
            attributes,
            joint: lost_joint((&name).into()),
            turns: Some(Expr::error((&name).into())),
            masses: Vec::new(),
            inertias: Vec::new(),
            name,
        };
        let complete = self.body_parts(&mut body).is_ok();
        Ok((Item::Body(body), complete))
    }

    fn body_parts(&mut self, body: &mut BodyItem) -> Parsed<()> {
        self.equals()?;
        let kind = self.kind()?;
        let named = self.stream.ident(0).is_some() && !self.at_clause_word();
        let name = match named {
            true => Some(self.name("the name of the joint")?),
            false => None,
        };
        let rules = [joint_rules(kind.kind), &BODY].concat();
        let mut clauses = self.clauses(kind.word, &rules);
        body.turns = clauses
            .take_value("turns")
            .or_else(|| clauses.broken.then(|| Expr::error(kind.span)));
        let mass = |clause: Clause| MassPart {
            at: clause.point.unwrap_or_else(|| Expr::error(clause.span)),
            mass: clause.value,
        };
        body.masses = clauses.take_all("mass").into_iter().map(mass).collect();
        let inertia = |clause: Clause| InertiaPart {
            inertia: clause.value,
            at: clause.point,
        };
        body.inertias = clauses
            .take_all("inertia")
            .into_iter()
            .map(inertia)
            .collect();
        body.joint = self.joint_part(kind, name, clauses);
        self.end_of_item()
    }

    /// `NAME = BODY on BODY at POINT ;` after the joint's word, and whether its end has been reached.
    pub(super) fn joint_item(
        &mut self,
        kind: Kind,
        attributes: Vec<Attribute>,
    ) -> Parsed<(Item, bool)> {
        let name = self.name(&format!("a name after `{}`", kind.word))?;
        self.equals()?;
        let body = self.name("the name of a body")?;
        let clauses = self.clauses(kind.word, joint_rules(kind.kind));
        let joint = self.joint_part(kind, Some(name), clauses);
        let item = JointItem {
            attributes,
            body,
            joint,
        };
        Ok((Item::Joint(item), self.end_of_item().is_ok()))
    }

    fn kind(&mut self) -> Parsed<Kind> {
        let span = self.stream.span();
        let word = self.stream.ident(0).map(ToString::to_string);
        let word = word.unwrap_or_default();
        if let Some(kind) = Kind::find(&word, span) {
            self.stream.skip(1);
            return Ok(kind);
        }
        let words = KINDS.map(|(word, _)| word);
        let help = match nearest(&word, words) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!("joints are {}", words.join(" ")),
        };
        self.expected("a joint", &help)
    }

    /// What the clauses say of the joint. A clause that is missing is reported.
    fn joint_part(&mut self, kind: Kind, name: Option<Ident>, mut clauses: Clauses) -> JointPart {
        let span = match &name {
            Some(name) => kind.span.to(name.into()),
            None => kind.span,
        };
        let lost = lost_joint(span);
        let word = kind.word;
        for (clause, wanted) in [("on", "on BODY"), ("at", "at POINT")] {
            self.require(&clauses, word, span, (clause, wanted));
        }
        let on = clauses.take_name("on").unwrap_or(lost.on);
        let at = clauses.take_value("at").unwrap_or(lost.at);
        let along = clauses.take("along");
        let about = clauses.take("about");
        if let (Some(_), Some(about)) = (&along, &about) {
            let help = "both words name its axis: write one of them";
            let fact = format!("`along` and `about` in one `{word}`");
            self.diagnostics.error_with_help(about.span, &fact, help);
        }
        let direction = along.or(about).map(|clause| clause.value);
        JointPart {
            kind: kind.kind,
            name,
            on,
            at,
            direction,
            span,
        }
    }
}

/// What a mistake leaves behind: a joint that gives no reason for further messages.
fn lost_joint(span: SourceSpan) -> JointPart {
    JointPart {
        kind: JointKind::Fixed,
        name: None,
        on: Ident::new("frame", Span::call_site()),
        at: Expr::error(span),
        direction: None,
        span,
    }
}

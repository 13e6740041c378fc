//! Bodies, and the joints that they hang on or that close loops.

use proc_macro2::{Ident, Span};

use super::ast::Item;
use super::clauses::{Clause, ClauseRule, Clauses, Owner};
use super::expression_tree::Expr;
use super::keyword::{ClauseWord, JointKind};
use super::mechanics_tree::{BodyItem, InertiaPart, JointItem, JointPart, MassPart, Member};
use super::parser::{Parsed, Parser, Reported};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::nearest;

const ON: ClauseRule = ClauseRule::name(ClauseWord::On, "the name of a body");
const AT: ClauseRule = ClauseRule::value(ClauseWord::At);
const ALONG: ClauseRule = ClauseRule::value(ClauseWord::Along);
const ABOUT: ClauseRule = ClauseRule::value(ClauseWord::About);

/// The clauses of a body besides those of its joint.
const BODY: [ClauseRule; 3] = [
    ClauseRule::value(ClauseWord::Turns),
    ClauseRule::value(ClauseWord::Mass).with_point().repeated(),
    ClauseRule::value(ClauseWord::Inertia)
        .with_optional_point()
        .repeated(),
];

fn joint_rules(kind: JointKind) -> &'static [ClauseRule] {
    match kind {
        JointKind::Pin => &[ON, AT, ABOUT],
        JointKind::Slide | JointKind::Roller => &[ON, AT, ALONG],
        JointKind::Ball | JointKind::Fixed => &[ON, AT],
        JointKind::Cylinder => &[ON, AT, ALONG, ABOUT],
    }
}

/// The joint's kind and its place.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    pub(super) kind: JointKind,
    pub(super) span: SourceSpan,
}

impl Parser<'_> {
    /// `NAME = JOINT, CLAUSES ;` after `body`, and whether its end has been reached.
    pub(super) fn body_item(&mut self) -> Parsed<(Item, bool)> {
        let name = self.name("a name after `body`")?;
        let mut body = BodyItem {
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
        let equals = self.equals("write `body NAME = pin on BODY at POINT, ...`");
        if equals.is_err() && self.kind_ahead().is_none() {
            return equals;
        }
        let kind = self.kind()?;
        let named = self.stream.ident(0).is_some() && !self.at_clause_word();
        let name = if named { self.joint_name(kind) } else { None };
        let word = kind.kind.word();
        let span = kind.span.to(self.stream.previous_span());
        let rules = [joint_rules(kind.kind), &BODY].concat();
        let of_body = Owner {
            what: &format!("body on a `{word}` joint"),
            form: &format!("{word} on BODY at POINT"),
            span,
        };
        let mut clauses = self.clauses(of_body, &rules);
        body.turns = clauses
            .take_value(ClauseWord::Turns)
            .or_else(|| clauses.broken.then(|| Expr::error(span)));
        body.masses = clauses.take_all(ClauseWord::Mass).map(mass).collect();
        body.inertias = clauses.take_all(ClauseWord::Inertia).map(inertia).collect();
        body.joint = self.joint_part(kind, name, of_body, clauses);
        self.end_of_item()
    }

    /// Reads `NAME = BODY on BODY at POINT ;` after the joint's word. The flag is true if its end
    /// has been reached.
    pub(super) fn joint_item(&mut self, kind: Kind) -> Parsed<(Item, bool)> {
        let word = kind.kind.word();
        let form = format!("{word} NAME = BODY on BODY at POINT");
        let help = format!("write `{form}`");
        let name = if self.stream.is_punct(0, '=') {
            self.expected(&format!("a name after `{word}`"), &help).ok()
        } else {
            self.joint_name(kind)
        };
        self.equals(&help)?;
        let body = if self.lacks_operand() {
            self.expected("the name of a body after `=`", &help).ok()
        } else {
            Some(self.member("the name of a body after `=`")?)
        };
        let owner = Owner {
            what: &format!("`{word}` joint"),
            form: &form,
            span: kind
                .span
                .to(name.as_ref().map_or(kind.span, SourceSpan::from)),
        };
        let clauses = self.clauses(owner, joint_rules(kind.kind));
        let (Some(name), Some(body)) = (name, body) else {
            return Err(Reported);
        };
        let joint = self.joint_part(kind, Some(name), owner, clauses);
        let item = JointItem { body, joint };
        Ok((Item::Joint(item), self.end_of_item().is_ok()))
    }

    /// The name of a joint; one that is none has been read over.
    fn joint_name(&mut self, kind: Kind) -> Option<Ident> {
        let name = self.name(&format!("a name after `{}`", kind.kind.word()));
        self.stream.skip(usize::from(name.is_err()));
        name.ok()
    }

    fn kind_ahead(&self) -> Option<Kind> {
        let kind = JointKind::from_word(&self.stream.ident(0)?.to_string())?;
        let span = self.stream.span();
        Some(Kind { kind, span })
    }

    /// The joint's word. One that is near is taken for it.
    fn kind(&mut self) -> Parsed<Kind> {
        if let Some(kind) = self.kind_ahead() {
            self.stream.skip(1);
            return Ok(kind);
        }
        let words: Vec<&str> = JointKind::all().map(JointKind::word).collect();
        let word = self.stream.ident(0).map(ToString::to_string);
        let word = word.unwrap_or_default();
        let near = || JointKind::from_word(nearest(&word, words.iter().copied())?);
        let Some(kind) = other_word(&word).or_else(near) else {
            return self.expected("a joint", &format!("joints are {}", words.join(" ")));
        };
        let _ = self.expected::<()>("a joint", &format!("did you mean `{}`?", kind.word()));
        let span = self.stream.span();
        self.stream.skip(1);
        Ok(Kind { kind, span })
    }

    /// Makes a joint of its clauses. Missing clauses are reported.
    fn joint_part(
        &mut self,
        kind: Kind,
        name: Option<Ident>,
        owner: Owner,
        mut clauses: Clauses,
    ) -> JointPart {
        self.require(&clauses, owner, &[ClauseWord::On, ClauseWord::At]);
        let lost = lost_joint(owner.span);
        let on = clauses.take_name(ClauseWord::On).unwrap_or(lost.on);
        let at = clauses
            .take_value(ClauseWord::At)
            .unwrap_or_else(|| lost.at.clone());
        let along = clauses.take(ClauseWord::Along);
        let about = clauses.take(ClauseWord::About);
        if let (Some(_), Some(about)) = (&along, &about) {
            let help = "both words name its axis: write one of them";
            let fact = format!("`along` and `about` in one `{}` joint", kind.kind.word());
            self.diagnostics.error_with_help(about.span, &fact, help);
        }
        let rules = joint_rules(kind.kind).iter();
        let needs_direction = rules
            .map(|rule| rule.word)
            .any(|word| word == ClauseWord::Along);
        let direction = match along.or(about) {
            None if needs_direction && clauses.broken => Some(lost.at.clone()),
            clause => clause.map(|clause| clause.value),
        };
        JointPart {
            kind: kind.kind,
            name,
            on,
            at,
            direction,
            span: owner.span,
        }
    }
}

/// Other names of a joint in texts on mechanisms.
fn other_names(kind: JointKind) -> &'static [&'static str] {
    match kind {
        JointKind::Pin => &["hinge", "revolute", "pivot"],
        JointKind::Slide => &["slider", "prismatic", "guide"],
        JointKind::Roller => &["slot"],
        JointKind::Ball => &["sphere", "spherical", "socket"],
        JointKind::Cylinder => &["cylindrical"],
        JointKind::Fixed => &["weld", "rigid"],
    }
}

/// Returns the joint with another name.
pub(super) fn other_word(word: &str) -> Option<JointKind> {
    JointKind::all().find(|kind| other_names(*kind).contains(&word))
}

fn mass(clause: Clause) -> MassPart {
    MassPart {
        at: clause.point.unwrap_or_else(|| Expr::error(clause.span)),
        mass: clause.value,
    }
}

fn inertia(clause: Clause) -> InertiaPart {
    InertiaPart {
        inertia: clause.value,
        at: clause.point,
    }
}

/// Returns a replacement after a mistake: a joint that causes no further messages.
fn lost_joint(span: SourceSpan) -> JointPart {
    JointPart {
        kind: JointKind::Fixed,
        name: None,
        on: Member::from(&Ident::new("frame", Span::call_site())),
        at: Expr::error(span),
        direction: None,
        span,
    }
}

//! Joints and links, and what joins them.

use proc_macro2::Ident;

use super::expression::PlusMinus;
use super::expression_tree::{Expr, ExprKind, Toleranced};
use super::keyword::{LinkedWord, is_keyword};
use super::linked_tree::{DrawnJoint, LinkItem, LinkJoint, LinkedItem, LostItem};
use super::linked_words::{LinkClause, SliderWord, WheelsWord, is_word_of_links};
use super::mechanics_tree::{InertiaPart, MassPart};
use super::parser::{Parsed, Parser, Reported};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{list, nearest};

impl Parser<'_> {
    /// Reads an item after its word, which `start` is the place of. The flag is true if its end has
    /// been reached. After a mistake, the names of the item are kept.
    pub(super) fn linked_item(
        &mut self,
        word: LinkedWord,
        start: SourceSpan,
    ) -> Parsed<(LinkedItem, bool)> {
        let names = self.declared_ahead(word);
        match self.sound_item(word, start) {
            Ok(item) => Ok((item, self.end_of_item().is_ok())),
            Err(reported) if names.is_empty() && !has_name(word) => Err(reported),
            Err(_) => Ok((LinkedItem::Lost(LostItem { word, names }), false)),
        }
    }

    fn sound_item(&mut self, word: LinkedWord, start: SourceSpan) -> Parsed<LinkedItem> {
        Ok(match word {
            LinkedWord::Joint => LinkedItem::Joints(self.drawn_joints()?),
            LinkedWord::Link => LinkedItem::Link(self.link()?),
            LinkedWord::Slider => LinkedItem::Slider(self.slider()?),
            LinkedWord::Gears => LinkedItem::Gears(self.wheels(word, start)?),
            LinkedWord::Belt => LinkedItem::Belt(self.wheels(word, start)?),
            LinkedWord::Weld => LinkedItem::Weld(self.weld()?),
        })
    }

    /// Returns the names that an item declares, whatever is wrong with the rest of it.
    fn declared_ahead(&self, word: LinkedWord) -> Vec<Ident> {
        let mut names: Vec<Ident> = match word {
            // `link c, d` has joints only.
            LinkedWord::Link | LinkedWord::Slider if self.stream.is_punct(1, ',') => Vec::new(),
            LinkedWord::Link | LinkedWord::Slider => {
                self.stream.ident(0).cloned().into_iter().collect()
            }
            LinkedWord::Joint => {
                let tokens = (0..).take_while(|ahead| {
                    self.stream.peek(*ahead).is_some() && !self.stream.is_punct(*ahead, ';')
                });
                let begins = |ahead: &usize| *ahead == 0 || self.stream.is_punct(*ahead - 1, ',');
                let names = tokens.filter(begins).filter_map(|ahead| {
                    let named = ahead == 0 || self.stream.is_punct(ahead + 1, '=');
                    self.stream.ident(ahead).filter(|_| named).cloned()
                });
                names.collect()
            }
            LinkedWord::Gears | LinkedWord::Belt | LinkedWord::Weld => Vec::new(),
        };
        // The mistake can be a name that is none.
        let is_name = |name: &Ident| {
            let text = name.to_string();
            !is_keyword(&text) && !text.starts_with("r#")
        };
        names.retain(is_name);
        names
    }

    /// `NAME = (x, y), NAME = (x, y), ...`
    fn drawn_joints(&mut self) -> Parsed<Vec<DrawnJoint>> {
        let mut joints = Vec::new();
        loop {
            let name = self.name("a name after `joint`")?;
            if is_word_of_links(&name.to_string()) {
                let fact = format!("a joint cannot be called `{name}`, which is a word of links");
                self.diagnostics
                    .error_with_help((&name).into(), fact, "choose another name");
            }
            let form = format!("joint {name} = (x, y);");
            if self.stream.is_punct(0, ':') {
                return self.expected_mark("=", &name, &form);
            }
            self.equals(&format!("write where it is drawn: `{form}`"))?;
            let position = self.toleranced()?;
            self.expect_point(&name, &position)?;
            joints.push(DrawnJoint { name, position });
            if self.stream.eat_punct(',') {
                continue;
            }
            if self.stream.is_punct(1, '=') && !self.at_item() {
                return self.expected("`,` or `;`", "write `,` between joints");
            }
            return Ok(joints);
        }
    }

    /// Refuses a position that can be no point.
    fn expect_point(&mut self, name: &Ident, position: &Toleranced) -> Parsed<()> {
        let Toleranced::Single { nominal, .. } = position else {
            return Ok(());
        };
        match &nominal.kind {
            ExprKind::Number { .. } => {
                let help = format!("write its coordinates: `joint {name} = (x, y);`");
                self.fail_at(nominal.span, "a joint is drawn at a point", &help)
            }
            ExprKind::List(components) => {
                let written: Vec<String> = components.iter().map(Expr::to_string).collect();
                let point = format!("({})", written.join(", "));
                let fact = "a joint is drawn at a point, found a list in brackets";
                let help = format!("write `{point}`");
                let message = self.diagnostics.error_with_help(nominal.span, fact, &help);
                message.suggest(help, nominal.span, point);
                Err(Reported)
            }
            _ => Ok(()),
        }
    }

    fn link(&mut self) -> Parsed<LinkItem> {
        let name = self.name_of(LinkedWord::Link.word(), "link NAME: joint, joint")?;
        if self.stream.is_punct(0, ',') {
            let help = format!("a link has a name before its joints: `link NAME: {name}, ...;`");
            return self.expected(&format!("`:` after `{name}`"), &help);
        }
        self.colon(&name, &format!("link {name}: joint, joint;"))?;
        let mut link = LinkItem {
            name,
            joints: vec![self.link_joint()?],
            at: None,
            length: None,
            about: None,
            masses: Vec::new(),
            inertias: Vec::new(),
        };
        loop {
            self.refuse_decimal_comma()?;
            let comma = self.stream.eat_punct(',');
            if self.at_end_of_clauses() {
                return Ok(link);
            }
            match self.link_clause() {
                Some(clause) => self.clause_of_link(&mut link, clause)?,
                None if comma => link.joints.push(self.link_joint()?),
                None => return self.not_a_clause(),
            }
        }
    }

    /// `joint`, `joint = (x, y)`
    fn link_joint(&mut self) -> Parsed<LinkJoint> {
        let name = self.name("the name of a joint")?;
        let given = self.stream.eat_punct('=');
        let coordinates = if given {
            Some(self.toleranced()?)
        } else {
            None
        };
        Ok(LinkJoint { name, coordinates })
    }

    fn link_clause(&self) -> Option<LinkClause> {
        LinkClause::from_word(&self.stream.ident(0)?.to_string())
    }

    fn clause_of_link(&mut self, link: &mut LinkItem, clause: LinkClause) -> Parsed<()> {
        let second = match clause {
            LinkClause::At => link.at.is_some(),
            LinkClause::Length => link.length.is_some(),
            LinkClause::About => link.about.is_some(),
            LinkClause::Mass | LinkClause::Inertia => false,
        };
        if second {
            let fact = format!("a second `{}`", clause.word());
            return self.fail(fact, "a link has one");
        }
        self.stream.skip(1);
        self.no_equals(clause.word())?;
        match clause {
            LinkClause::At => link.at = Some(self.sum(PlusMinus::JointIsMistake)?),
            LinkClause::Length => link.length = Some(self.toleranced()?),
            LinkClause::About => link.about = Some(self.sum(PlusMinus::JointIsMistake)?),
            LinkClause::Mass => {
                let mass = self.sum(PlusMinus::JointIsMistake)?;
                self.refuse_decimal_comma()?;
                let help = "write `mass M at POINT`";
                let Some(at) = self.point_of_clause()? else {
                    return self.expected("`at` and the centre of the mass", help);
                };
                link.masses.push(MassPart { mass, at });
            }
            LinkClause::Inertia => {
                let inertia = self.sum(PlusMinus::JointIsMistake)?;
                self.refuse_decimal_comma()?;
                let at = self.point_of_clause()?;
                link.inertias.push(InertiaPart { inertia, at });
            }
        }
        Ok(())
    }

    fn point_of_clause(&mut self) -> Parsed<Option<Expr>> {
        let found = self.stream.eat_word(LinkClause::At.word());
        Ok(if found {
            Some(self.sum(PlusMinus::JointIsMistake)?)
        } else {
            None
        })
    }

    fn not_a_clause<T>(&mut self) -> Parsed<T> {
        let words: Vec<&str> = LinkClause::all().map(LinkClause::word).collect();
        let word = self.stream.ident(0).map(ToString::to_string);
        let word = word.unwrap_or_default();
        let before = self.stream.previous().map(ToString::to_string);
        if let Some(number) = self.number_with_near_unit() {
            let help = format!("did you mean `{number}`?");
            return self.expected("`,` and a joint, a clause or `;`", &help);
        }
        let follows_joint = !is_word_of_links(&word)
            && self.stream.ident(0).is_some()
            && (self.stream.is_punct(1, ',')
                || self.stream.is_punct(1, ';')
                || self.stream.ident(1).is_some());
        let help = match nearest(&word, words.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None if SliderWord::from_word(&word).is_some() => format!(
                "`{word}` is a word of sliders: `{}`; clauses of a link are {}",
                super::sliders::FORM,
                list(&words)
            ),
            None if WheelsWord::from_word(&word).is_some() => {
                format!(
                    "`{word}` is a word of `gears` and `belt`: `gears LINK, LINK teeth 20, 40;`"
                )
            }
            None if follows_joint => format!(
                "write `,` between joints: `{}, {word}`",
                before.unwrap_or_default()
            ),
            None => format!("clauses of a link are {}", list(&words)),
        };
        self.expected("`,` and a joint, a clause or `;`", &help)
    }
}

/// Returns true for an item that has a name. After a mistake in the name, other items may use it.
fn has_name(word: LinkedWord) -> bool {
    match word {
        LinkedWord::Joint | LinkedWord::Link | LinkedWord::Slider => true,
        LinkedWord::Gears | LinkedWord::Belt | LinkedWord::Weld => false,
    }
}

//! Joints and links, and what joins them.

use proc_macro2::Ident;

use super::expression::PlusMinus;
use super::expression_tree::{Expr, ExprKind, Toleranced};
use super::keyword::LinkedWord;
use super::linked_tree::{
    DrawnJoint, LinkItem, LinkJoint, LinkedItem, SlidePath, SliderItem, WeldItem, WheelsItem,
};
use super::mechanics_tree::{InertiaPart, MassPart};
use super::parser::{Parsed, Parser};
use super::vocabulary::{Word, vocabulary};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{list, nearest};

vocabulary! {
    /// The word that a clause of a link begins with.
    pub enum LinkClause {
        /// The direction from the first joint to the second.
        At = "at",
        /// The distance of the first two joints.
        Length = "length",
        /// The axis of a hinge in space.
        About = "about",
        /// A mass at a point.
        Mass = "mass",
        /// A moment of inertia.
        Inertia = "inertia",
    }
}

/// Names of clauses and quantities of links.
const LINK_WORDS: [&str; 8] = [
    "about", "angle", "at", "inertia", "length", "mass", "radius", "start",
];

const LINK: &str = "link NAME: joint, joint";
const SLIDER: &str = "slider NAME: joint on LINK along joint, joint";

impl Parser<'_> {
    /// An item after its word, which `start` is the place of.
    pub(super) fn linked_item(
        &mut self,
        word: LinkedWord,
        start: SourceSpan,
    ) -> Parsed<LinkedItem> {
        Ok(match word {
            LinkedWord::Joint => LinkedItem::Joints(self.drawn_joints()?),
            LinkedWord::Link => LinkedItem::Link(self.link()?),
            LinkedWord::Slider => LinkedItem::Slider(self.slider()?),
            LinkedWord::Gears => LinkedItem::Gears(self.wheels(word, start)?),
            LinkedWord::Belt => LinkedItem::Belt(self.wheels(word, start)?),
            LinkedWord::Weld => LinkedItem::Weld(self.weld()?),
        })
    }

    /// `NAME = (x, y), NAME = (x, y), ...`
    fn drawn_joints(&mut self) -> Parsed<Vec<DrawnJoint>> {
        let mut joints = Vec::new();
        loop {
            let name = self.name("a name after `joint`")?;
            if LINK_WORDS.contains(&name.to_string().as_str()) {
                let fact = format!("a joint cannot be called `{name}`, which is a word of links");
                self.diagnostics
                    .error_with_help((&name).into(), fact, "choose another name");
            }
            self.equals("write where it is drawn: `joint NAME = (x, y);`")?;
            let position = self.toleranced()?;
            if let Toleranced::Single { nominal, .. } = &position
                && matches!(nominal.kind, ExprKind::Number { .. })
            {
                let help = format!("write its coordinates: `joint {name} = (x, y);`");
                return self.fail_at(nominal.span, "a joint is drawn at a point", &help);
            }
            joints.push(DrawnJoint { name, position });
            if !self.stream.eat_punct(',') {
                return Ok(joints);
            }
        }
    }

    fn link(&mut self) -> Parsed<LinkItem> {
        let name = self.name("a name after `link`")?;
        self.colon(&name, LINK)?;
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
        match clause {
            LinkClause::At => link.at = Some(self.sum(PlusMinus::JointIsMistake)?),
            LinkClause::Length => link.length = Some(self.toleranced()?),
            LinkClause::About => link.about = Some(self.sum(PlusMinus::JointIsMistake)?),
            LinkClause::Mass => {
                let mass = self.sum(PlusMinus::JointIsMistake)?;
                let help = "write `mass M at POINT`";
                let Some(at) = self.point_of_clause()? else {
                    return self.expected("`at` and the centre of the mass", help);
                };
                link.masses.push(MassPart { mass, at });
            }
            LinkClause::Inertia => {
                let inertia = self.sum(PlusMinus::JointIsMistake)?;
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
        let near = word.and_then(|word| nearest(&word, words.iter().copied()));
        let help = match near {
            Some(word) => format!("did you mean `{word}`?"),
            None => format!("clauses of a link are {}", list(&words)),
        };
        self.expected("`,` and a joint, a clause or `;`", &help)
    }

    fn slider(&mut self) -> Parsed<SliderItem> {
        let name = self.name("a name after `slider`")?;
        self.colon(&name, SLIDER)?;
        let pin = self.name("the name of the joint that slides")?;
        self.word("on", SLIDER)?;
        let guide = self.name("the link that the joint slides on")?;
        let path = self.slide_path()?;
        let mut slider = SliderItem {
            name,
            pin,
            guide,
            path,
            block: None,
            at: None,
        };
        loop {
            self.stream.eat_punct(',');
            if self.at_end_of_clauses() {
                return Ok(slider);
            }
            if slider.block.is_none() && self.stream.eat_word("block") {
                slider.block = Some(self.name("the link that does not turn in the guide")?);
            } else if slider.at.is_none() && self.stream.eat_word("at") {
                slider.at = Some(self.sum(PlusMinus::JointIsMistake)?);
            } else {
                let help = "clauses of a slider are `block LINK` and `at POSITION`";
                return self.expected("a clause or `;`", help);
            }
        }
    }

    fn slide_path(&mut self) -> Parsed<SlidePath> {
        if self.stream.eat_word("around") {
            let centre = self.name("the joint in the middle of the arc")?;
            self.stream.eat_punct(',');
            let given = self.stream.eat_word("radius");
            let radius = if given {
                Some(self.toleranced()?)
            } else {
                None
            };
            return Ok(SlidePath::Arc { centre, radius });
        }
        if !self.stream.eat_word("along") {
            let help = format!("write `{SLIDER}`, `... along ANGLE` or `... around joint`");
            return self.expected("`along` or `around`", &help);
        }
        if self.stream.ident(0).is_some() && self.stream.is_punct(1, ',') {
            let first = self.name("a joint of the guide")?;
            self.stream.skip(1);
            let second = self.name("a second joint of the guide")?;
            return Ok(SlidePath::Line([first, second]));
        }
        let angle = self.sum(PlusMinus::JointIsMistake)?;
        let given = self.stream.eat_word("through");
        let through = if given {
            Some(self.name("a joint of the guide")?)
        } else {
            None
        };
        Ok(SlidePath::Direction { angle, through })
    }

    /// `LINK, LINK [on LINK] teeth a, b`
    fn wheels(&mut self, word: LinkedWord, start: SourceSpan) -> Parsed<WheelsItem> {
        let word = word.word();
        let form = format!("{word} LINK, LINK teeth 20, 40");
        let first = self.name(&format!("the name of a link after `{word}`"))?;
        self.comma(&form)?;
        let second = self.name("the name of the other link")?;
        let given = self.stream.eat_word("on");
        let carrier = if given {
            Some(self.name("the link that carries the pivots")?)
        } else {
            None
        };
        self.stream.eat_punct(',');
        if !self.stream.eat_word("teeth") && !self.stream.eat_word("radii") {
            let help = format!("write `{form}`, or `radii 10mm, 20mm`");
            return self.expected("`teeth` or `radii`", &help);
        }
        let one = self.sum(PlusMinus::JointIsMistake)?;
        self.comma(&form)?;
        let other = self.sum(PlusMinus::JointIsMistake)?;
        Ok(WheelsItem {
            wheels: [first, second],
            carrier,
            span: start.to(other.span),
            sizes: [one, other],
        })
    }

    /// `LINK, LINK, ...`
    fn weld(&mut self) -> Parsed<WeldItem> {
        let mut links = vec![self.name("the name of a link after `weld`")?];
        while self.stream.eat_punct(',') {
            links.push(self.name("the name of a link")?);
        }
        if links.len() < 2 {
            return self.expected("`,` and another link", "write `weld LINK, LINK`");
        }
        Ok(WeldItem { links })
    }

    fn colon(&mut self, name: &Ident, form: &str) -> Parsed<()> {
        if self.stream.eat_punct(':') {
            return Ok(());
        }
        self.expected(&format!("`:` after `{name}`"), &format!("write `{form}`"))
    }

    fn comma(&mut self, form: &str) -> Parsed<()> {
        if self.stream.eat_punct(',') {
            return Ok(());
        }
        self.expected("`,`", &format!("write `{form}`"))
    }

    fn word(&mut self, word: &str, form: &str) -> Parsed<()> {
        if self.stream.eat_word(word) {
            return Ok(());
        }
        self.expected(&format!("`{word}`"), &format!("write `{form}`"))
    }
}

//! Sliders, and marks that items of joints and links share with them.

use proc_macro2::Ident;

use super::expression::PlusMinus;
use super::keyword::LinkedWord;
use super::linked_tree::{SlidePath, SliderItem};
use super::linked_words::SliderWord;
use super::parser::{Parsed, Parser, Reported};
use super::vocabulary::Word;
use crate::diagnostic::text::nearest;

/// The usual form of a slider.
pub(super) const FORM: &str = "slider NAME: joint on LINK along joint, joint";

/// Words that others have for a curved slot.
const ARCS: [&str; 3] = ["arc", "circle", "about"];

impl Parser<'_> {
    /// Reads a slider after its word.
    pub(super) fn slider(&mut self) -> Parsed<SliderItem> {
        let name = self.name_of(LinkedWord::Slider.word(), FORM)?;
        self.colon(
            &name,
            &format!("slider {name}: joint on LINK along joint, joint;"),
        )?;
        let pin = self.name("the name of the joint that slides")?;
        if !self.stream.eat_word(SliderWord::On.word()) {
            let form = format!("write `{FORM}`");
            let help = self.meant_word([SliderWord::On], form);
            return self.expected("`on`", &help);
        }
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
            self.refuse_decimal_comma()?;
            self.stream.eat_punct(',');
            if self.at_end_of_clauses() {
                return Ok(slider);
            }
            if slider.block.is_none() && self.stream.eat_word(SliderWord::Block.word()) {
                slider.block = Some(self.name("the link that does not turn in the guide")?);
            } else if slider.at.is_none() && self.stream.eat_word(SliderWord::At.word()) {
                self.no_equals(SliderWord::At.word())?;
                slider.at = Some(self.sum(PlusMinus::JointIsMistake)?);
            } else {
                return self.not_a_clause_of_slider(&slider.path);
            }
        }
    }

    fn not_a_clause_of_slider<T>(&mut self, path: &SlidePath) -> Parsed<T> {
        let clauses = [SliderWord::Block, SliderWord::At];
        let word = self.stream.ident(0).map(ToString::to_string);
        let word = word.unwrap_or_default();
        if clauses.iter().any(|clause| clause.word() == word) {
            return self.fail(format!("a second `{word}`"), "a slider has one");
        }
        let more = match path {
            SlidePath::Arc { radius: None, .. } => Some(SliderWord::Radius),
            SlidePath::Direction { through: None, .. } => Some(SliderWord::Through),
            SlidePath::Arc { .. } | SlidePath::Direction { .. } | SlidePath::Line(_) => None,
        };
        let form = "clauses of a slider are `block LINK` and `at POSITION`".to_owned();
        let help = self.meant_word(clauses.into_iter().chain(more), form);
        self.expected("a clause or `;`", &help)
    }

    /// Returns a help with the nearest of some words, or another one if none is near.
    fn meant_word(&self, words: impl IntoIterator<Item = SliderWord>, other: String) -> String {
        let found = self.stream.ident(0).map(ToString::to_string);
        let words = words.into_iter().map(SliderWord::word);
        match nearest(&found.unwrap_or_default(), words) {
            Some(near) => format!("did you mean `{near}`?"),
            None => other,
        }
    }

    fn slide_path(&mut self) -> Parsed<SlidePath> {
        self.refuse_other_arc()?;
        if self.stream.eat_word(SliderWord::Around.word()) {
            let centre = self.name("the joint in the middle of the arc")?;
            self.stream.eat_punct(',');
            let given = self.stream.eat_word(SliderWord::Radius.word());
            let radius = if given {
                self.no_equals(SliderWord::Radius.word())?;
                Some(self.toleranced()?)
            } else {
                None
            };
            return Ok(SlidePath::Arc { centre, radius });
        }
        if !self.stream.eat_word(SliderWord::Along.word()) {
            let form = match self.stream.ident(1) {
                Some(joint) if self.stream.is_word(0, SliderWord::Through.word()) => {
                    format!("write the direction before it: `along ANGLE through {joint}`")
                }
                _ => format!("write `{FORM}`, `... along ANGLE` or `... around joint`"),
            };
            let help = self.meant_word([SliderWord::Along, SliderWord::Around], form);
            return self.expected("`along` or `around`", &help);
        }
        if self.stream.ident(0).is_some() && self.stream.is_punct(1, ',') {
            let first = self.name("a joint of the guide")?;
            self.stream.skip(1);
            let second = self.name("a second joint of the guide")?;
            return Ok(SlidePath::Line([first, second]));
        }
        let angle = self.sum(PlusMinus::JointIsMistake)?;
        let given = self.stream.eat_word(SliderWord::Through.word());
        let through = if given {
            Some(self.name("a joint of the guide")?)
        } else {
            None
        };
        Ok(SlidePath::Direction { angle, through })
    }

    /// Reports `along arc m`, `about m` and the like, which mean `around m`.
    fn refuse_other_arc(&mut self) -> Parsed<()> {
        let is_arc = |ahead: usize| {
            let word = self.stream.ident(ahead).map(ToString::to_string);
            word.is_some_and(|word| ARCS.contains(&word.as_str()))
        };
        let along = usize::from(self.stream.is_word(0, SliderWord::Along.word()));
        let others = (along..).take_while(|ahead| is_arc(*ahead)).count();
        let centre = self.stream.ident(along + others).cloned();
        let is_joint = |word: &Ident| SliderWord::from_word(&word.to_string()).is_none();
        let Some(centre) = centre.filter(is_joint).filter(|_| others > 0) else {
            return Ok(());
        };
        let first = self.stream.span();
        self.stream.skip(along + others);
        let span = first.to(self.stream.previous_span());
        let fact = "a slot that is an arc begins with `around`";
        let help = format!("write `around {centre}`, the joint in the middle of the arc");
        let message = self.diagnostics.error_with_help(span, fact, help);
        message.suggest(format!("write `around {centre}`"), span, "around");
        Err(Reported)
    }

    /// Reads the name after the word of an item of this form.
    pub(super) fn name_of(&mut self, word: &str, form: &str) -> Parsed<Ident> {
        let wanted = format!("a name after `{word}`");
        if self.stream.ident(0).is_none() {
            return self.expected(&wanted, &format!("write `{form}`"));
        }
        self.name(&wanted)
    }

    /// Reads `:` after the name of an item of this form.
    pub(super) fn colon(&mut self, name: &Ident, form: &str) -> Parsed<()> {
        if self.stream.eat_punct(':') {
            return Ok(());
        }
        self.expected_mark(":", name, form)
    }

    /// Reports a mark other than the one that follows the name of an item.
    pub(super) fn expected_mark<T>(&mut self, mark: &str, name: &Ident, form: &str) -> Parsed<T> {
        let span = self.stream.span();
        let is_other = self.stream.is_punct(0, ':') || self.stream.is_punct(0, '=');
        let fact = format!("expected `{mark}` after `{name}`, found {}", self.found());
        let help = format!("write `{form}`");
        let message = self.diagnostics.error_with_help(span, fact, help);
        if is_other {
            message.suggest(format!("write `{mark}`"), span, mark);
        }
        Err(Reported)
    }

    /// Refuses `=` between the word of a clause and its value.
    pub(super) fn no_equals(&mut self, word: &str) -> Parsed<()> {
        if !self.stream.is_punct(0, '=') {
            return Ok(());
        }
        let span = self.stream.span();
        let fact = format!("expected a value after `{word}`, found `=`");
        let help = format!("leave `=` out: `{word} VALUE`");
        let message = self.diagnostics.error_with_help(span, fact, help);
        message.suggest("leave `=` out", span, "");
        Err(Reported)
    }
}

//! Items that join whole links: gears, belts and welds.

use super::expression::PlusMinus;
use super::keyword::LinkedWord;
use super::linked_tree::{WeldItem, WheelsItem};
use super::linked_words::WheelsWord;
use super::parser::{Parsed, Parser};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;

impl Parser<'_> {
    /// `LINK, LINK [on LINK] teeth a, b`
    pub(super) fn wheels(&mut self, word: LinkedWord, start: SourceSpan) -> Parsed<WheelsItem> {
        let word = word.word();
        let form = format!("{word} LINK, LINK teeth 20, 40");
        let first = self.name(&format!("the name of a link after `{word}`"))?;
        self.comma(&form)?;
        let second = self.name("the name of the other link")?;
        let given = self.stream.eat_word(WheelsWord::On.word());
        let carrier = if given {
            Some(self.name("the link that carries the pivots")?)
        } else {
            None
        };
        self.stream.eat_punct(',');
        let sizes = [WheelsWord::Teeth, WheelsWord::Radii];
        if !sizes.iter().any(|size| self.stream.eat_word(size.word())) {
            let help = format!("write `{form}`, or `radii 10mm, 20mm`");
            return self.expected("`teeth` or `radii`", &help);
        }
        let one = self.sum(PlusMinus::JointIsMistake)?;
        if !self.stream.eat_punct(',') {
            let help = format!("write both sizes: `{word} {first}, {second} teeth 20, 40;`");
            return self.expected("`,` and the size of the other wheel", &help);
        }
        let other = self.sum(PlusMinus::JointIsMistake)?;
        Ok(WheelsItem {
            wheels: [first, second],
            carrier,
            span: start.to(other.span),
            sizes: [one, other],
        })
    }

    /// `LINK, LINK, ...`
    pub(super) fn weld(&mut self) -> Parsed<WeldItem> {
        let mut links = vec![self.name("the name of a link after `weld`")?];
        while self.stream.eat_punct(',') {
            links.push(self.name("the name of a link")?);
        }
        if links.len() < 2 {
            return self.expected("`,` and another link", "write `weld LINK, LINK`");
        }
        Ok(WeldItem { links })
    }

    fn comma(&mut self, form: &str) -> Parsed<()> {
        if self.stream.eat_punct(',') {
            return Ok(());
        }
        self.expected("`,`", &format!("write `{form}`"))
    }
}

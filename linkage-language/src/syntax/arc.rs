//! Curved slots in texts of loops.

use super::ast::ArcItem;
use super::expression::PlusMinus;
use super::parser::{Parsed, Parser};

const FORM: &str = "arc NAME: point around centre";

impl Parser<'_> {
    /// `NAME: point around point [turned by angle]` after `arc`.
    pub(super) fn arc_item(&mut self) -> Parsed<ArcItem> {
        let help = format!("write `{FORM}`");
        let name = self.name("a name after `arc`")?;
        if !self.stream.eat_punct(':') {
            return self.expected(&format!("`:` after `{name}`"), &help);
        }
        let slider = self.sum(PlusMinus::JointIsMistake)?;
        if !self.stream.eat_word("around") {
            return self.expected("`around`", &help);
        }
        let centre = self.sum(PlusMinus::JointIsMistake)?;
        self.stream.eat_punct(',');
        let given = self.stream.eat_word("turned");
        let turned = if given {
            self.stream.eat_word("by");
            Some(self.sum(PlusMinus::JointIsMistake)?)
        } else {
            None
        };
        Ok(ArcItem {
            name,
            slider,
            centre,
            turned,
        })
    }
}

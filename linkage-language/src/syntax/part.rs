//! Parts: mechanisms within a mechanism.

use proc_macro2::Delimiter;

use super::ast::{GivenPart, Item, PartItem};
use super::clauses::{ClauseRule, Owner};
use super::keyword::ClauseWord;
use super::parser::{Parsed, Parser};
use crate::diagnostic::SourceSpan;

const FORM: &str = "part NAME: MECHANISM { input = expression }";

/// The clauses for the location of a part.
const RULES: [ClauseRule; 3] = [
    ClauseRule::name(ClauseWord::On, "the name of a body"),
    ClauseRule::value(ClauseWord::At),
    ClauseRule::value(ClauseWord::Turned),
];

impl Parser<'_> {
    /// Reads `NAME: MECHANISM { given = expr, ... } CLAUSES ;` after `part`. The flag is true if
    /// its end has been reached.
    pub(super) fn part_item(&mut self) -> Parsed<(Item, bool)> {
        let help = format!("write `{FORM}`");
        let name = self.name("a name after `part`")?;
        if !self.stream.eat_punct(':') {
            return self.expected(&format!("`:` after `{name}`"), &help);
        }
        let mechanism = self.name("the name of a mechanism")?;
        let Some(group) = self.stream.group(0, Delimiter::Brace).cloned() else {
            return self.expected(&format!("`{{` after `{mechanism}`"), &help);
        };
        self.stream.skip(1);
        let given = self.within(&group, |parser| parser.comma_list("}", Parser::given));
        let what = "part";
        let span = SourceSpan::from(&name).to((&mechanism).into());
        let owner = Owner {
            what,
            form: FORM,
            span,
        };
        let mut clauses = self.clauses(owner, &RULES);
        let whole = given.is_ok() && !clauses.broken;
        let item = PartItem {
            name,
            mechanism,
            given: given.map_or_else(|_| Vec::new(), |(given, _)| given),
            whole,
            on: clauses.take_name(ClauseWord::On),
            at: clauses.take_value(ClauseWord::At),
            turned: clauses.take_value(ClauseWord::Turned),
        };
        Ok((Item::Part(item), self.end_of_item().is_ok()))
    }

    /// `phi = shaft`
    fn given(&mut self) -> Parsed<GivenPart> {
        let name = self.name("the name of an input")?;
        if self.stream.is_punct(0, ':') {
            return self.expected("`=`", &format!("write `{name} = expression`"));
        }
        self.equals("write `input = expression`")?;
        let value = self.expression()?;
        Ok(GivenPart { name, value })
    }
}

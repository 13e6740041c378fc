//! Tokens to syntax tree. Never fails: a bad item becomes a diagnostic and is left out.

mod ast;
mod attributes;
mod clauses;
mod dump;
mod expression;
mod function;
mod input;
mod items;
mod joints;
mod literal;
mod loads;
mod operands;
mod parser;
mod power;
mod recovery;
mod spelling;
mod stream;
#[cfg(test)]
mod tests;
mod tolerance;
mod unexpected;
mod units;
mod vocabulary;
mod words;

use proc_macro2::{Delimiter, Ident, TokenStream};

pub(crate) use ast::*;
pub(crate) use dump::dump;
pub(crate) use spelling::units_within;
pub(crate) use units::{Scale, Unit, find_unit, first_spelling, is_unit};
pub(crate) use vocabulary::{Word, vocabulary};

use crate::diagnostic::Diagnostics;
use parser::{Parsed, Parser};
use stream::Stream;

/// Reads the body of the macro (without the facade's path in front). `None` if there is no `struct NAME { ... }`;
/// whatever else is missing or wrong is reported and left out.
pub(crate) fn parse(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Option<MechanismDef> {
    let mut parser = Parser::new(Stream::new(tokens), diagnostics);
    let mut mechanism = None;
    let mut implementations = Vec::new();
    while !parser.stream.at_end() {
        let block = parser.block(&mut mechanism, &mut implementations);
        if block.is_err() {
            parser.skip_block();
        }
    }
    let Some(mut mechanism) = mechanism else {
        if parser.diagnostics.is_empty() {
            let help = "write `pub struct NAME { ... }`";
            let _ = parser.fail::<()>("there is no struct block", help);
        }
        return None;
    };
    for Implementation { name, functions } in implementations {
        parser.check_name(&name, &mechanism.name);
        mechanism.functions.extend(functions);
    }
    Some(mechanism)
}

struct Implementation {
    name: Ident,
    functions: Vec<FunctionDef>,
}

impl Parser<'_> {
    /// A struct block or an `impl` block.
    fn block(
        &mut self,
        mechanism: &mut Option<MechanismDef>,
        implementations: &mut Vec<Implementation>,
    ) -> Parsed<()> {
        let attributes = self.attributes()?;
        if self.stream.is_word(0, "impl") {
            self.only_documentation(&attributes, "`impl`");
            implementations.push(self.implementation()?);
            return Ok(());
        }
        let visibility = self.visibility();
        if !self.stream.is_word(0, "struct") {
            return match mechanism {
                None => self.expected("`struct NAME { ... }`", ""),
                Some(_) => self.expected("`impl NAME { ... }`", "a macro call is one mechanism"),
            };
        }
        if mechanism.is_some() {
            let help = "write another `mechanism!` for another mechanism";
            return self.fail("a second struct block", help);
        }
        self.stream.skip(1);
        let name = self.name("the name of the mechanism")?;
        let mut definition = MechanismDef {
            attributes,
            visibility,
            name,
            items: Vec::new(),
            functions: Vec::new(),
        };
        let body = self.braces(&definition.name.to_string());
        let items = body.map(|group| self.within(&group, |parser| parser.items()));
        let result = items.map(|items| definition.items = items);
        *mechanism = Some(definition);
        result
    }

    /// The braces after `struct NAME` or `impl NAME`.
    fn braces(&mut self, name: &str) -> Parsed<proc_macro2::Group> {
        if let Some(group) = self.stream.group(0, Delimiter::Brace).cloned() {
            self.stream.skip(1);
            return Ok(group);
        }
        if self.stream.is_punct(0, '<') {
            return self.braces_after_generics(name);
        }
        self.expected(&format!("`{{` after `{name}`"), "")
    }

    /// `struct NAME<'a> { ... }`: reported, and read as if it had not been there.
    fn braces_after_generics(&mut self, name: &str) -> Parsed<proc_macro2::Group> {
        let lifetime = self.stream.is_punct(1, '\'');
        let help = match lifetime {
            true => format!("write `{name}` alone: a mechanism borrows nothing"),
            false => "leave the type parameters out: the generated types have one for the scalar"
                .to_owned(),
        };
        let result = self.expected(&format!("`{{` after `{name}`"), &help);
        while !self.stream.at_end() && self.stream.group(0, Delimiter::Brace).is_none() {
            self.stream.skip(1);
        }
        match self.stream.group(0, Delimiter::Brace).cloned() {
            Some(group) => {
                self.stream.skip(1);
                Ok(group)
            }
            None => result,
        }
    }

    fn implementation(&mut self) -> Parsed<Implementation> {
        self.stream.skip(1);
        let name = self.name("the name of the mechanism")?;
        let group = self.braces(&name.to_string())?;
        let functions = self.within(&group, |parser| parser.functions());
        Ok(Implementation { name, functions })
    }

    fn check_name(&mut self, name: &Ident, wanted: &Ident) {
        if name != wanted {
            let fact = format!("the struct is named `{wanted}`, its `impl` block `{name}`");
            let help = format!("write `impl {wanted}`");
            self.diagnostics.error_with_help(name.into(), fact, help);
        }
    }

    /// Past the next braces, after a mistake.
    fn skip_block(&mut self) {
        while !self.stream.at_end() && self.stream.group(0, Delimiter::Brace).is_none() {
            self.stream.skip(1);
        }
        self.stream.skip(1);
    }
}

//! Struct blocks and `impl` blocks: the mechanisms of one call.

use proc_macro2::{Delimiter, Ident, TokenStream};

use super::ast::{FunctionDef, MechanismDef};
use super::link_elements::LinkElements;
use super::parser::{Parsed, Parser};
use super::stream::Stream;
use crate::diagnostic::Diagnostics;
use crate::diagnostic::text::{list, nearest};

/// Reads the body of the macro, without the facade's path. Returns the mechanisms of one call in
/// the order of their structs, none if there is no `struct NAME { ... }`. Anything else that is
/// missing or wrong is reported and left out.
pub fn parse(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Vec<MechanismDef> {
    let mut parser = Parser::new(Stream::new(tokens), diagnostics);
    let mut mechanisms = Vec::new();
    let mut implementations = Vec::new();
    while !parser.stream.at_end() {
        let block = parser.block(&mut mechanisms, &mut implementations);
        if block.is_err() {
            parser.skip_block();
        }
    }
    if mechanisms.is_empty() {
        if parser.diagnostics.is_empty() {
            let help = "write `pub struct NAME { ... }`";
            let _ = parser.fail::<()>("there is no struct block", help);
        }
        return mechanisms;
    }
    for Implementation { name, functions } in implementations {
        if let Some(index) = parser.implemented(&name, &mechanisms) {
            mechanisms[index].functions.extend(functions);
        }
    }
    parser.drop_second(&mut mechanisms);
    mechanisms
}

struct Implementation {
    name: Ident,
    functions: Vec<FunctionDef>,
}

impl Parser<'_> {
    /// A struct block or an `impl` block.
    fn block(
        &mut self,
        mechanisms: &mut Vec<MechanismDef>,
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
            return if mechanisms.is_empty() {
                self.expected("`struct NAME { ... }`", "")
            } else {
                self.expected("`impl NAME { ... }` or another `struct NAME { ... }`", "")
            };
        }
        self.stream.skip(1);
        let name = self.name("the name of the mechanism")?;
        let mut definition = MechanismDef {
            attributes,
            visibility,
            name,
            items: Vec::new(),
            functions: Vec::new(),
            links: None,
            link_elements: LinkElements::default(),
            warnings: Diagnostics::default(),
            links_are_lost: false,
            link_names_are_lost: false,
        };
        let body = self.braces(&definition.name.to_string());
        let items = body.map(|group| self.within(&group, |parser| parser.items()));
        let result = items.map(|items| definition.items = items);
        mechanisms.push(definition);
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
        let help = if lifetime {
            format!("write `{name}` alone: a mechanism borrows nothing")
        } else {
            "leave the type parameters out: the generated types have one for the scalar".to_owned()
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

    /// The mechanism that an `impl` block belongs to, by its number.
    fn implemented(&mut self, name: &Ident, mechanisms: &[MechanismDef]) -> Option<usize> {
        let found = mechanisms
            .iter()
            .position(|mechanism| mechanism.name == *name);
        if found.is_some() {
            return found;
        }
        if let [only] = mechanisms {
            let wanted = &only.name;
            let fact = format!("the struct is named `{wanted}`, its `impl` block `{name}`");
            let help = format!("write `impl {wanted}`");
            let message = self.diagnostics.error_with_help(name.into(), fact, help);
            message.suggest(format!("write `{wanted}`"), name.into(), wanted.to_string());
            return Some(0);
        }
        let names: Vec<String> = mechanisms
            .iter()
            .map(|mechanism| mechanism.name.to_string())
            .collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let fact = format!("there is no struct `{name}` in this call");
        let help = match nearest(&name.to_string(), names.iter().copied()) {
            Some(name) => format!("did you mean `impl {name}`?"),
            None => format!("the structs of this call are {}", list(&names)),
        };
        self.diagnostics.error_with_help(name.into(), fact, help);
        None
    }

    /// Reports two structs of one name, and keeps the first one.
    fn drop_second(&mut self, mechanisms: &mut Vec<MechanismDef>) {
        let mut kept: Vec<MechanismDef> = Vec::new();
        for mechanism in mechanisms.drain(..) {
            let Some(first) = kept.iter().find(|first| first.name == mechanism.name) else {
                kept.push(mechanism);
                continue;
            };
            let name = &mechanism.name;
            let fact = format!("two structs of this call have the name `{name}`");
            self.diagnostics
                .error_with_help(name.into(), fact, "choose another name");
            let fact = format!("`{name}` is first defined here");
            let related = self.diagnostics.error((&first.name).into(), fact);
            related.is_related = true;
        }
        *mechanisms = kept;
    }

    /// Past the next braces, after a mistake.
    fn skip_block(&mut self) {
        while !self.stream.at_end() && self.stream.group(0, Delimiter::Brace).is_none() {
            self.stream.skip(1);
        }
        self.stream.skip(1);
    }
}

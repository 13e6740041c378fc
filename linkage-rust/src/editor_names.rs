//! The names of a mechanism as items that editors know: fields with docs, and an access to the
//! field at each place where the user wrote the name.
//!
//! The facade expands them for rust-analyzer alone. Hover, definitions, references, renaming and
//! completions inside the macro are then those of fields.

mod declared_names;
mod uses;

use linkage_compiler::Driver;
use linkage_language::diagnostic::Diagnostics;
use linkage_language::model::Mechanism;
use linkage_language::syntax;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::split_crate_path;
use declared_names::{Declared, Kind, holder};
use uses::{Block, Use};

/// The names of a mechanism.
struct Names {
    mechanism: Ident,
    declared: Vec<Declared>,
}

impl Names {
    fn find(&self, link: Option<&str>, name: &Ident) -> Option<&Declared> {
        self.declared.iter().find(|declared| {
            let is_of_link = match (&declared.link, link) {
                (Some(declared), Some(link)) => declared == link,
                (declared, link) => declared.is_none() && link.is_none(),
            };
            is_of_link && declared.name == *name
        })
    }
}

/// Returns the names of all mechanisms of the macro's input, as far as it can be read. Mistakes are
/// reported by [`compile`](crate::compile).
pub fn names(input: TokenStream) -> TokenStream {
    let (_, body) = split_crate_path(input);
    let blocks = uses::blocks(body.clone());
    // As they are written, and with the loops that joints and links stand for.
    let written = syntax::parse(body.clone(), &mut Diagnostics::default());
    let resolved = Driver::resolve(body);
    let all: Vec<Names> = written
        .iter()
        .zip(&resolved)
        .map(|(written, (complete, _))| Names {
            mechanism: written.name.clone(),
            declared: declared_names::declared([written, complete]),
        })
        .collect();
    // The accesses come first: while a word is typed, nothing before it changes.
    let mut items = TokenStream::new();
    for (index, names) in all.iter().enumerate() {
        let blocks = blocks.iter().filter(|block| names.mechanism == block.name);
        items.extend(accesses(index, names, &all, &blocks.collect::<Vec<_>>()));
    }
    for (names, (_, model)) in all.iter().zip(&resolved) {
        let mechanism = model.as_ref().map(|model| &model.mechanism);
        items.extend(types(names, mechanism));
    }
    quote!(const _: () = { #items };)
}

/// A function with an access for each use.
fn accesses(index: usize, names: &Names, all: &[Names], blocks: &[&Block]) -> TokenStream {
    let mechanisms = all.iter().enumerate().map(|(index, names)| {
        let (argument, mechanism) = (dimensions(index), &names.mechanism);
        quote!(#argument: #mechanism,)
    });
    let mut arguments: TokenStream = mechanisms.collect();
    let mut results = Vec::new();
    for result in blocks.iter().flat_map(|block| &block.results) {
        let argument = format_ident!("__r{}", results.len());
        let name = &result.name;
        arguments.extend(quote!(#argument: #name,));
        results.push((argument, &result.fields));
    }
    let mut body = TokenStream::new();
    for used in blocks.iter().flat_map(|block| &block.uses) {
        body.extend(access(used, index, all));
        let name = &used.path[0];
        let of_name = results
            .iter()
            .filter(|(_, fields)| fields.iter().any(|field| name == field));
        body.extend(of_name.map(|(argument, _)| quote!(#argument.#name;)));
    }
    let function = format_ident!("__uses_{index}");
    let (argument, holder) = (argument(index), holder(&names.mechanism, None));
    quote!(fn #function(#argument: #holder, #arguments) { #body })
}

/// The argument whose fields are the names of a mechanism.
fn argument(index: usize) -> Ident {
    format_ident!("__n{index}", span = Span::call_site())
}

/// The argument whose fields are the parameters of a mechanism; as long as the other one, so that
/// nothing moves while a word is completed.
fn dimensions(index: usize) -> Ident {
    format_ident!("__m{index}", span = Span::call_site())
}

/// The access to the field of a name and, of parts and links, to those of the names after its dot.
fn access(used: &Use, index: usize, all: &[Names]) -> TokenStream {
    let (argument, names) = (argument(index), &all[index]);
    let (name, members) = used.path.split_first().expect("a name");
    if used.declares {
        return TokenStream::new();
    }
    let Some(declared) = names.find(None, name) else {
        // A name that is being written, too.
        return match uses::is_word(&name.to_string()) {
            true => TokenStream::new(),
            false => quote!(#argument.#name;),
        };
    };
    let mut path = quote!(#argument.#name);
    match &declared.kind {
        Kind::Value => {}
        Kind::Parameter => {
            let dimensions = dimensions(index);
            path = quote!(#dimensions.#name);
        }
        Kind::Link => {
            let member = members.first();
            path.extend(member.map(|member| quote!(.#member)));
        }
        Kind::Part(mechanism) => {
            let (mut mechanism, mut members) = (Some(mechanism), members.iter());
            while let (Some(part), Some(member)) = (mechanism, members.next()) {
                path.extend(quote!(.#member));
                let index = all.iter().position(|names| names.mechanism == *part);
                let declared = index.and_then(|index| all[index].find(None, member));
                mechanism = match declared.map(|declared| &declared.kind) {
                    Some(Kind::Part(mechanism)) => Some(mechanism),
                    Some(Kind::Parameter) => {
                        let dimensions = index.map(dimensions);
                        path.extend(quote!(; #dimensions.#member));
                        None
                    }
                    Some(Kind::Value | Kind::Link) | None => None,
                };
            }
        }
    }
    quote!(#path;)
}

/// The types whose fields are the names: of the mechanism, and of each link.
fn types(names: &Names, mechanism: Option<&Mechanism>) -> TokenStream {
    let of_link = |link: Option<&Ident>| {
        let fields = names
            .declared
            .iter()
            .filter(|declared| declared.link.as_ref() == link);
        let fields = fields.map(|declared| declared.field(&names.mechanism, mechanism));
        let holder = holder(&names.mechanism, link);
        quote!(struct #holder { #(#fields)* })
    };
    let links = names
        .declared
        .iter()
        .filter(|declared| matches!(declared.kind, Kind::Link));
    let links = links.map(|link| of_link(Some(&link.name)));
    let values = of_link(None);
    quote!(#values #(#links)*)
}

//! Accesses to the fields of names, in a function for each mechanism.

use linkage_language::syntax::{first_spelling, is_keyword};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::block_uses::Block;
use super::declared_names::{Declared, Kind, Names, holder};
use super::uses::Use;
use super::vocabulary;

/// A function with an access for each use in the blocks of a mechanism.
///
/// While a word is typed, rust-analyzer looks for its receiver at the same byte of the code without
/// the word. So each word is after a statement with the receiver of names, and the ends of items and
/// blocks have the receivers of the words that may follow.
pub(super) fn function(index: usize, all: &[Names], blocks: &[&Block]) -> TokenStream {
    let mechanisms = all.iter().enumerate().map(|(index, names)| {
        let (argument, mechanism) = (dimensions(index), &names.mechanism);
        quote!(#argument: #mechanism,)
    });
    let mut arguments: TokenStream = mechanisms.collect();
    arguments.extend(vocabulary::receivers());
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
        if let Use::Name { path, .. } = used {
            let name = &path[0];
            let fields = results
                .iter()
                .filter(|(_, fields)| fields.iter().any(|field| name == field));
            body.extend(fields.map(|(argument, _)| quote!(#argument.#name;)));
        }
    }
    // They come last, so that no access moves while an item is written.
    let implemented = blocks.iter().filter_map(|block| block.implemented.as_ref());
    body.extend(implemented.map(|name| quote!(let _: #name;)));
    let function = format_ident!("__uses_{index}");
    let (argument, holder) = (argument(index), holder(&all[index].mechanism, None));
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

fn access(used: &Use, index: usize, all: &[Names]) -> TokenStream {
    let names = argument(index);
    match used {
        Use::Item(word) => vocabulary::item(word),
        Use::Clause(word, clauses) => {
            let word = vocabulary::clause(word, *clauses);
            quote!(#names; #word)
        }
        Use::Unit(unit) => {
            let unit = vocabulary::unit(unit);
            quote!(#names; #unit)
        }
        Use::EndOfItem(clauses) => {
            let receiver = vocabulary::clauses(*clauses);
            quote!(#names; #receiver;)
        }
        Use::EndOfBlock => {
            let receiver = vocabulary::items();
            quote!(#receiver;)
        }
        Use::Call(word) if vocabulary::is_function(&word.to_string()) => {
            let holder = holder(&all[index].mechanism, None);
            quote!(#names; #holder::#word;)
        }
        Use::Call(_) => TokenStream::new(),
        // The link that does not move is a word of the language, also where its joints are.
        Use::Name { path, .. } if all[index].is_frame(&path[0]) => {
            let word = vocabulary::clause(&path[0], None);
            quote!(#names; #word)
        }
        Use::Name { declares: true, .. } => TokenStream::new(),
        Use::Name { path, .. } => {
            let (name, members) = path.split_first().expect("a name");
            match all[index].find(name) {
                Some(declared) => access_of(declared, name, members, index, all),
                None if all.iter().any(|names| names.mechanism == *name) => quote!(let _: #name;),
                None => undeclared(name, &names),
            }
        }
    }
}

/// A word without a declaration: of the language, or a name that is being written.
fn undeclared(word: &Ident, names: &Ident) -> TokenStream {
    match first_spelling(&word.to_string()) {
        Some(_) => {
            let unit = vocabulary::unit(word);
            quote!(#names; #unit)
        }
        None if vocabulary::is_course(word) => {
            let word = vocabulary::clause(word, None);
            quote!(#names; #word)
        }
        None if is_keyword(&word.to_string()) => TokenStream::new(),
        None => quote!(#names.#word;),
    }
}

/// The access to the field of a name and, of parts and links, to those of the names after its dot.
fn access_of(
    declared: &Declared,
    name: &Ident,
    members: &[Ident],
    index: usize,
    all: &[Names],
) -> TokenStream {
    let argument = argument(index);
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
                let declared = index.and_then(|index| all[index].find(member));
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

//! Accesses to the fields of names, in a function for each mechanism.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::declared_names::{Declared, Kind, Names, holder};
use super::uses::{self, Block, Use};
use super::vocabulary;

/// A function with an access for each use in the blocks of a mechanism.
pub(super) fn function(index: usize, all: &[Names], blocks: &[&Block]) -> TokenStream {
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
    let words = words();
    quote!(fn #function(#argument: #holder, __w: #words, #arguments) { #body })
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

/// The name of the type whose fields are words of the language.
pub(super) fn words() -> Ident {
    format_ident!("__words", span = Span::call_site())
}

/// Returns a word of the language that has a meaning.
pub(super) fn word(used: &Use) -> Option<&'static str> {
    let word = match used {
        Use::Name { path, .. } => path.first()?,
        Use::Item(word) => word,
        Use::Call(_) => return None,
    };
    vocabulary::word(&word.to_string())
}

fn access(used: &Use, index: usize, all: &[Names]) -> TokenStream {
    let of_word = |word: &Ident| {
        let is_known = vocabulary::word(&word.to_string()).is_some();
        let raw = vocabulary::raw(word);
        is_known.then(|| quote!(__w.#raw;))
    };
    match used {
        Use::Item(word) => of_word(word).unwrap_or_default(),
        Use::Call(word) if vocabulary::is_function(&word.to_string()) => {
            let holder = holder(&all[index].mechanism, None);
            quote!(#holder::#word;)
        }
        Use::Call(_) | Use::Name { declares: true, .. } => TokenStream::new(),
        Use::Name { path, .. } => {
            let (name, members) = path.split_first().expect("a name");
            match all[index].find(name) {
                Some(declared) => access_of(declared, name, members, index, all),
                // A word, or a name that is being written.
                None if uses::is_word(&name.to_string()) => TokenStream::new(),
                None if all.iter().any(|names| names.mechanism == *name) => quote!(let _: #name;),
                None => of_word(name).unwrap_or_else(|| {
                    let argument = argument(index);
                    quote!(#argument.#name;)
                }),
            }
        }
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

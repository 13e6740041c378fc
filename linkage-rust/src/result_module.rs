//! The types of a function are in a separate private module, from which the module of the call
//! imports them. A module may already have a type of that name, from another mechanism for
//! instance, which no single expansion can know. Its error is then about the import, at the word of
//! the user, and about nothing else: within the private module the names are never ambiguous.
//! Result and columns are imported by name, so there are two errors, since rustc reports each name
//! that is taken, also twice at one word. With the columns imported by a glob there would be one
//! error. But a module that imports other columns of that name by a glob, as tests with `use
//! super::*` do, would have ambiguous names (E0659): a correct program would be refused for a
//! shorter message about an incorrect one.
//!
//! A function with derives of the user's has its types next to everything else: in the body of a
//! function these derives may be imported there, and no module sees that import.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote, quote_spanned};

use super::attribute;
use super::outline::{Function, Outline};

/// The module of a function's types.
fn module(outline: &Outline, function: &Function) -> Option<Ident> {
    let has_module = attribute::split(function.attributes).result.is_empty();
    has_module.then(|| {
        let span = Span::call_site();
        format_ident!("__{}_{}", outline.name, function.name, span = span)
    })
}

/// The import of the types into the block around code, which so never uses those of the module of
/// the call.
pub(super) fn import(outline: &Outline, function: &Function) -> Option<TokenStream> {
    let module = module(outline, function)?;
    let everywhere = &attribute::split(function.attributes).everywhere;
    Some(quote!(#(#everywhere)* use #module::*;))
}

/// The items of a function's types, and the import of these.
pub(super) fn with_imports(
    outline: &Outline,
    function: &Function,
    types: &TokenStream,
    columns: &TokenStream,
) -> TokenStream {
    let runtime = &outline.runtime;
    let with_allocator = |items: TokenStream| match items.is_empty() {
        true => items,
        false => quote!(#runtime::if_alloc! { #items }),
    };
    let swept = with_allocator(columns.clone());
    let Some(module) = module(outline, function) else {
        return quote!(#types #swept);
    };
    let everywhere = &attribute::split(function.attributes).everywhere;
    let allow = attribute::allow();
    let import = |name: &Ident| {
        let word = function.result.span();
        let mut name = name.clone();
        name.set_span(word);
        let mut module = module.clone();
        module.set_span(word);
        let visibility = with_span(function.visibility, word);
        let import = quote_spanned!(word=> #visibility use #module::#name;);
        quote! {
            #(#everywhere)*
            #allow
            #import
        }
    };
    let result = import(function.result);
    let imported = (!columns.is_empty()).then(|| import(&function.columns));
    let imported = with_allocator(imported.unwrap_or_default());
    quote! {
        #(#everywhere)*
        #allow
        mod #module {
            // For links in the docs of the user.
            use super::*;
            #types
            #swept
        }
        #result
        #imported
    }
}

/// Silences lints about a type of a function, which its module does for all types within.
pub(super) fn allow(outline: &Outline, function: &Function) -> TokenStream {
    match module(outline, function) {
        Some(_) => TokenStream::new(),
        None => attribute::allow(),
    }
}

/// The visibility of a type of a function, at the word of the user.
pub(super) fn visibility(outline: &Outline, function: &Function) -> TokenStream {
    let visibility = with_span(function.visibility, function.result.span());
    match module(outline, function) {
        Some(_) => from_below(visibility),
        None => visibility,
    }
}

/// The visibility of the items of these types that only generated code uses.
pub(super) fn private(outline: &Outline, function: &Function) -> TokenStream {
    let module = module(outline, function);
    module.map_or_else(TokenStream::new, |_| quote!(pub(super)))
}

fn with_span(tokens: &TokenStream, span: proc_macro2::Span) -> TokenStream {
    let tokens = tokens.clone().into_iter().map(|mut token| {
        token.set_span(span);
        token
    });
    tokens.collect()
}

/// The same visibility, written in a module below.
fn from_below(visibility: TokenStream) -> TokenStream {
    let tokens: Vec<TokenTree> = visibility.into_iter().collect();
    let [word, TokenTree::Group(scope)] = &tokens[..] else {
        return match tokens.is_empty() {
            true => quote!(pub(super)),
            false => tokens.into_iter().collect(),
        };
    };
    let path: Vec<TokenTree> = scope.stream().into_iter().collect();
    let path = match &path[..] {
        [TokenTree::Ident(first), rest @ ..] if first == "in" => rest,
        path => path,
    };
    let below = match path {
        [TokenTree::Ident(first), rest @ ..] if first == "self" => quote!(in super #(#rest)*),
        [TokenTree::Ident(first), ..] if first == "super" => quote!(in super::#(#path)*),
        _ => scope.stream(),
    };
    let mut below = Group::new(Delimiter::Parenthesis, below);
    below.set_span(scope.span());
    quote!(#word #below)
}

//! The names of a mechanism as items that editors know: fields with docs, and an access to the
//! field at each place where the user wrote the name.
//!
//! The facade expands them for rust-analyzer alone. Hover, definitions, references, renaming and
//! completions inside the macro are then those of fields.

mod accesses;
mod block_uses;
mod declared_names;
mod reader;
mod uses;
mod vocabulary;

use linkage_compiler::Driver;
use linkage_language::diagnostic::Diagnostics;
use linkage_language::syntax;
use proc_macro2::TokenStream;
use quote::quote;

use crate::split_crate_path;
use declared_names::{Names, holder};

/// Returns the names of all mechanisms of the macro's input, as far as it can be read. Mistakes are
/// reported by [`compile`](crate::compile).
pub fn names(input: TokenStream) -> TokenStream {
    let (_, body) = split_crate_path(input);
    let blocks = block_uses::blocks(body.clone());
    // As they are written, and with the loops that joints and links stand for.
    let written = syntax::parse(body.clone(), &mut Diagnostics::default());
    let resolved = Driver::resolve(body);
    let all: Vec<Names> = written
        .iter()
        .zip(&resolved)
        .map(|(written, (complete, _))| Names::new(written, complete))
        .collect();
    // The accesses come first: while a word is typed, nothing before it changes.
    let mut items = TokenStream::new();
    for (index, names) in all.iter().enumerate() {
        let blocks = blocks.iter().filter(|block| names.mechanism == block.name);
        let blocks: Vec<_> = blocks.collect();
        items.extend(accesses::function(index, &all, &blocks));
    }
    items.extend(vocabulary::types());
    for (names, (_, model)) in all.iter().zip(&resolved) {
        let mechanism = model.as_ref().map(|model| &model.mechanism);
        items.extend(names.types(mechanism));
        items.extend(vocabulary::methods(&holder(&names.mechanism, None)));
    }
    quote!(const _: () = { #items };)
}

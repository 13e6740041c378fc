//! The functions of the assembly at the position of a follower.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::docs::doc;
use crate::load::Places;
use crate::outline::{Function, Outline, plain};
use crate::stages::Version;
use crate::{assembly_data, attribute, literal, stages};
use linkage_language::model::FOLLOWER;

/// The name of the follower's type.
pub(super) fn follower_name(outline: &Outline) -> Ident {
    format_ident!("{}{FOLLOWER}", outline.name)
}

/// A function at the position of the follower.
pub(super) fn method(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function {
        visibility, name, ..
    } = function;
    let follower = follower_name(outline);
    let everywhere = &attribute::split(function.attributes).everywhere;
    let others = others(outline, function);
    let result = function.result;
    let doc = doc(&format!(
        "As `{}` of the assembly, where the follower stands.",
        plain(name)
    ));
    let body = outline.body(quote!(#runtime::single(self, [#(#others),*])));
    quote! {
        #(#everywhere)*
        impl<'a, T: #runtime::Scalar> #follower<'a, T> {
            #doc
            #[must_use]
            #[inline]
            #visibility fn #name(&self, #(#others: T),*) -> #result<T> { #body }
        }
    }
}

/// The parameters of such a function: the arguments that it takes and the follower does not know.
fn others<'a>(outline: &Outline, function: &Function<'a>) -> Vec<&'a Ident> {
    let is_input = |name: &Ident| outline.inputs.iter().any(|input| input.name == name);
    let names = function.arguments.iter().copied();
    names.filter(|name| !is_input(name)).collect()
}

/// The function that such a function calls, by a program for plain scalars.
pub(super) fn single_of(outline: &Outline, function: &Function, version: Version) -> TokenStream {
    let runtime = &outline.runtime;
    let follower = follower_name(outline);
    let everywhere = &attribute::split(function.attributes).everywhere;
    let places = Places::all(outline);
    let positions = function.arguments.iter().zip(&function.positions);
    let arguments = positions.map(|(name, &position)| match position < outline.inputs.len() {
        true => {
            let position = literal::index(position);
            quote!(__place[#position])
        }
        false => quote!(#name),
    });
    let states = function.states.iter().flat_map(|&group| {
        let numbers = 0..=outline.starts[group].size;
        numbers.map(move |number| (group, number))
    });
    let states = states.map(|(group, number)| {
        let position = literal::index(places.state(group, number));
        quote!(__place[#position])
    });
    let arguments = quote!([#(#arguments,)* #(#states),*]);
    let core = assembly_data::core(outline, &quote!(__assembly));
    let [plain, refining] =
        [version, Version::refining(function)].map(|version| stages::name(function, version));
    let result = function.result;
    let others = others(outline, function);
    let count = literal::index(others.len());
    quote! {
        #(#everywhere)*
        #[doc(hidden)]
        impl<'a, T: #runtime::Scalar> #runtime::Single<T, #result<T>, #count> for #follower<'a, T> {
            #[inline(always)]
            fn at<const __FUSED: __p::bool>(&self, [#(#others),*]: [T; #count]) -> #result<T> {
                let __assembly = self.assembly();
                let __place = #runtime::Sealed::starts(&self.__sealed);
                #runtime::evaluate::<#plain, #refining, _, _, _, __FUSED, _, _>(#core, #arguments)
            }
        }
    }
}

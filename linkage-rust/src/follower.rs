//! A mechanism that is followed from position to position: inputs and then the states of the
//! coupled groups, and the functions there.

mod functions;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use linkage_compiler::ir::CompiledMechanism;
use linkage_language::model::METHODS_OF_FOLLOWER;

use super::array_types::Types;
use super::docs::doc;
use super::load::Places;
use super::outline::{Outline, plain};
use super::stages::Version;
use super::{assembly_data, attribute, code, literal, stages};
use functions::{method, single_of};

/// True if a coupled group depends on several inputs: tables over one input need no follower.
fn has_follower(outline: &Outline) -> bool {
    outline.starts.iter().any(|start| start.inputs.len() > 1)
}

/// The type of the follower of a mechanism that has one.
pub(super) fn types(outline: &Outline) -> TokenStream {
    match has_follower(outline) {
        true => structure(outline),
        false => TokenStream::new(),
    }
}

/// The functions of the follower of a mechanism that has one.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if !has_follower(outline) {
        return TokenStream::new();
    }
    let mut items = shared(outline);
    items.extend(single(outline, unit));
    for (function, compiled) in outline.functions.iter().zip(&unit.functions) {
        let version = match &compiled.settled {
            Some(settled) => {
                items.extend(stages::items(outline, function, settled, Version::Settled));
                Version::Settled
            }
            None => Version::Called,
        };
        items.extend(method(outline, function));
        items.extend(single_of(outline, function, version));
    }
    items
}

/// The type of the follower of a mechanism with mistakes: it may have one if it has several inputs.
pub(super) fn skeleton_types(outline: &Outline) -> TokenStream {
    if outline.inputs.len() < 2 || is_taken(outline) {
        return TokenStream::new();
    }
    let (runtime, structure) = (&outline.runtime, structure(outline));
    quote!(#runtime::if_alloc! { #structure })
}

/// The functions of the follower of a mechanism with mistakes.
pub(super) fn skeleton(outline: &Outline) -> TokenStream {
    if outline.inputs.len() < 2 || is_taken(outline) {
        return TokenStream::new();
    }
    let mut items = shared(outline);
    let functions = outline.functions.iter();
    items.extend(functions.map(|function| method(outline, function)));
    let runtime = &outline.runtime;
    quote!(#runtime::if_alloc! { #items })
}

/// True if the user's functions have the names of its methods, which is a mistake if it has a
/// follower.
fn is_taken(outline: &Outline) -> bool {
    let functions = outline.functions.iter();
    functions
        .map(|function| plain(function.name))
        .any(|name| METHODS_OF_FOLLOWER.contains(&name.as_str()))
}

/// The construction of the type, and its items besides the functions.
fn shared(outline: &Outline) -> TokenStream {
    let mut items = constructor(outline);
    items.extend(follow(outline));
    items
}

fn structure(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        visibility,
        assembly,
        ..
    } = outline;
    let follower = functions::follower_name(outline);
    let width = literal::index(Places::all(outline).width());
    let doc = doc(&format!(
        "An assembled `{}` that stands at some inputs: it is followed from there to others, whatever the ranges of the inputs, and has all \
         functions of the assembly, at the position where it stands.\n\nIt is a reference and some numbers: a copy remembers a position.",
        outline.title()
    ));
    let allow = attribute::allow();
    quote! {
        #doc
        #allow
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        #visibility struct #follower<'a, T = ::core::primitive::f64> {
            __sealed: #runtime::Sealed<&'a #assembly<T>, [T; #width]>,
        }
    }
}

/// `follower(...)` of the assembly.
fn constructor(outline: &Outline) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let follower = functions::follower_name(outline);
    let inputs: Vec<&Ident> = outline.inputs.iter().map(|input| input.name).collect();
    let starts = assembly_data::starts(outline, &quote!(self));
    let body = outline.body(quote! {
        let __x = Self::__extend(#starts, [#(#inputs),*]);
        let mut __follower = #follower { __sealed: #runtime::Sealed::new(self, __x) };
        __follower.follow(#(#inputs),*)?;
        __p::Ok(__follower)
    });
    quote! {
        impl<T: #runtime::Scalar> #assembly<T> {
            /// A follower that stands at these inputs, where the assembly must serve: at the reference inputs, if no range is declared.
            ///
            /// # Errors
            ///
            /// Where the assembly does not serve.
            pub fn follower(&self, #(#inputs: T),*) -> __p::Result<#follower<'_, T>, #runtime::NotFollowed> {
                #body
            }
        }
    }
}

/// `follow(...)` and the position of the follower.
fn follow(outline: &Outline) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let follower = functions::follower_name(outline);
    let mechanism = outline.name;
    let title = outline.title();
    let inputs: Vec<&Ident> = outline.inputs.iter().map(|input| input.name).collect();
    let count = literal::index(inputs.len());
    let positions = (0..inputs.len()).map(literal::index);
    let follow = quote! {
        match #runtime::single(&*self, [#(#inputs),*]) {
            __p::Ok(__x) => {
                self.__sealed = #runtime::Sealed::new(self.assembly(), __x);
                __p::Ok(())
            }
            __p::Err(__stop) => {
                let __group = Self::__STANDING[__stop.number].group;
                let __structure = #mechanism::<__p::f64>::STRUCTURE;
                __p::Err(#runtime::NotFollowed::new(
                    #title, __group, &__structure.groups[__group], __stop.share, __stop.why,
                ))
            }
        }
    };
    let own_assembly = quote!(*#runtime::Sealed::core(&self.__sealed));
    let own_inputs = quote! {
        let __x = #runtime::Sealed::starts(&self.__sealed);
        [#(__x[#positions]),*]
    };
    let [follow, own_assembly, own_inputs] =
        [follow, own_assembly, own_inputs].map(|body| outline.body(body));
    quote! {
        impl<'a, T: #runtime::Scalar> #follower<'a, T> {
            /// Goes straight to other inputs, in steps that are certain to stay on the assembly: a single one if the way is short.
            ///
            /// # Errors
            ///
            /// Where no step leads any further, as at a dead point; the follower stays where it was.
            pub fn follow(&mut self, #(#inputs: T),*) -> __p::Result<(), #runtime::NotFollowed> { #follow }

            /// The assembly that is followed.
            #[must_use]
            pub fn assembly(&self) -> &'a #assembly<T> { #own_assembly }

            /// The inputs at which it stands, in the order of their declaration.
            #[must_use]
            pub fn inputs(&self) -> [T; #count] { #own_inputs }
        }
    }
}

/// The method that `follow(...)` calls: groups in their order, each corrected by its own program.
fn single(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let follower = functions::follower_name(outline);
    let places = Places::all(outline);
    let [count, width] = [outline.inputs.len(), places.width()].map(literal::index);
    let groups = outline.starts.iter().enumerate();
    let standing = groups.clone().map(|(number, start)| {
        let numbers = [
            unit.coupled[number].group,
            places.state(number, 0),
            start.size,
        ];
        let [group, first, size] = numbers.map(literal::index);
        quote!(#runtime::Standing { group: #group, first: #first, size: #size })
    });
    let last = outline.starts.len() - 1;
    let arms = groups.map(|(number, _)| {
        let pattern = match number == last {
            true => quote!(_),
            false => {
                let number = literal::index(number);
                quote!(#number)
            }
        };
        let method = format_ident!("__correct{number}");
        let first = literal::index(places.state(number, 0));
        quote! {
            #pattern => #runtime::put_corrected(__x, #first, &#assembly::#method::<__FUSED>(
                &__core.dimensions, &__core.modes, &__core.prepared, *__x,
            )),
        }
    });
    let core = assembly_data::core(outline, &quote!(__assembly));
    let arguments = code::tokens(&Types::new(outline).arguments);
    quote! {
        impl<'a, T: #runtime::Scalar> #follower<'a, T> {
            const __STANDING: &'static [#runtime::Standing] = &[#(#standing),*];
        }

        #[doc(hidden)]
        impl<'a, T: #runtime::Scalar> #runtime::Single<T, __p::Result<#arguments, #runtime::Stop>, #count>
            for #follower<'a, T>
        {
            #[inline(always)]
            fn at<const __FUSED: __p::bool>(
                &self,
                __to: [T; #count],
            ) -> __p::Result<#arguments, #runtime::Stop> {
                let __assembly = self.assembly();
                let __core = #core;
                let __from = #runtime::Sealed::starts(&self.__sealed);
                #runtime::follow(__from, __to, Self::__STANDING, |__number, __x: &mut [T; #width]| {
                    match __number { #(#arms)* }
                })
            }
        }
    }
}

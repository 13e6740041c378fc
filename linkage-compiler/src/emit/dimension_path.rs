//! The same assembly for other dimensions.

use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::constructors::explained;
use super::load::Places;
use super::outline::Outline;
use super::{array_types, assembly_data, attribute, literal, survey};
use crate::ir::CompiledMechanism;

/// `assemble_from`.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let at = outline
        .inputs
        .iter()
        .map(|input| literal::float(input.reference));
    let at = quote!([#(T::from_f64(#at)),*]);
    let core = assembly_data::core(outline, &quote!(__assembly));
    let modes = quote!(#core.__modes);
    if unit.groups.is_empty() {
        return method(outline, quote!(#assembly::__assemble(self, #modes, #at)));
    }
    let way = way(outline, unit);
    let float = quote!(::core::primitive::f64);
    let explained = |result: TokenStream| explained(outline, &result);
    let body = match outline.starts.is_empty() {
        true => {
            let assembled = explained(quote!(#assembly::__assemble(self, #modes, #at)));
            quote! {
                #way
                #assembly::__finite(self)?;
                for __lane in 0..T::LANES {
                    #runtime::follow_way(&__way(__lane), #runtime::Vec::new())?;
                }
                #assembled
            }
        }
        false => {
            let assembled = explained(quote! {
                #assembly::__with_starts(self, #modes, #at, &__lanes)
            });
            let prepared = assembly_data::starts(outline, &quote!(__assembly));
            let places = Places::all(outline);
            let vec = quote!(#runtime::Vec);
            let states = outline.starts.iter().enumerate().map(|(number, start)| {
                let first = places.state(number, 0);
                let numbers = (first..first + start.size).map(literal::index);
                quote!(<#vec<_> as ::core::convert::From<[_; _]>>::from([#(T::lane(__x[#numbers], __lane)),*]))
            });
            quote! {
                #way
                #assembly::__finite(self)?;
                let __x = #assembly::<T>::__extend(#prepared, #at);
                let mut __lanes = #runtime::Vec::new();
                for __lane in 0..T::LANES {
                    let __way = __way(__lane);
                    let __states = #runtime::follow_way(
                        &__way,
                        <#vec<_> as ::core::convert::From<[_; _]>>::from([#(#states),*]),
                    )?;
                    __lanes.push(#runtime::prepared_over(
                        &#assembly::<#float>::__GROUPS,
                        &__way.at,
                        &__states,
                        |__number, __starts| {
                            #assembly::<#float>::__coupled(
                                &__way.mechanism(1.0), &__way.modes, __way.at, __number, __starts,
                            )
                        },
                    )?);
                }
                #assembled
            }
        }
    };
    method(outline, body)
}

/// The mechanism between two sets of dimensions, inside the method, which keeps it private.
fn way(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let float = quote!(::core::primitive::f64);
    let parameters = literal::index(outline.scalar_fields().len());
    let inputs = literal::index(outline.inputs.len());
    let modes = Types::new(outline, unit).modes;
    let at = outline
        .inputs
        .iter()
        .map(|input| literal::float(input.reference));
    let count = literal::index(unit.survey.outputs.len());
    let title = outline.title();
    let levels = survey::levels(outline, unit);
    let starts = literal::index(outline.starts.len());
    let (programs, coupled) = match outline.starts.is_empty() {
        true => (quote!(#runtime::NoPrograms), TokenStream::new()),
        false => {
            let coupled = array_types::coupled_name(outline);
            let item = quote! {
                fn coupled(
                    &self,
                    __share: #float,
                    __starts: &[#runtime::Start],
                    __number: ::core::primitive::usize,
                ) -> ::core::option::Option<::core::result::Result<
                    (&'static #runtime::CoupledGroup, #coupled), #runtime::AssemblyError,
                >> {
                    let __lane: [#runtime::Start; #starts] =
                        ::core::array::from_fn(|__k| ::core::clone::Clone::clone(&__starts[__k]));
                    let __groups: &'static [#runtime::CoupledGroup; #starts] =
                        &#assembly::<#float>::__GROUPS;
                    let __made = #assembly::<#float>::__coupled(
                        &self.mechanism(__share), &self.modes, self.at, __number, &__lane,
                    );
                    ::core::option::Option::Some(__made.map(|__made| (&__groups[__number], __made)))
                }
            };
            (quote!(#coupled), item)
        }
    };
    let core = assembly_data::core(outline, &quote!(__assembly));
    let allow = attribute::allow();
    quote! {
        struct __Way {
            from: [#float; #parameters],
            to: [#float; #parameters],
            modes: #modes,
            at: [#float; #inputs],
        }
        #allow
        impl __Way {
            fn mechanism(&self, __share: #float) -> #name<#float> {
                let __values: [#float; #parameters] = ::core::array::from_fn(|__k| {
                    match __share == 1.0 {
                        true => self.to[__k],
                        false => self.from[__k] + __share * (self.to[__k] - self.from[__k]),
                    }
                });
                #runtime::Dimensions::from_values(&__values)
            }
        }
        #allow
        impl #runtime::Way for __Way {
            type Survey = [#float; #count];
            type Programs = #programs;

            const NAME: &'static ::core::primitive::str = #title;
            const LEVELS: &'static [#runtime::Level] = &#levels;
            const GROUPS: &'static [#runtime::Group] = #name::<#float>::STRUCTURE.groups;

            fn inputs(&self) -> &[#float] { &self.at }
            fn survey(&self, __share: #float, __starts: &[#runtime::Start]) -> [#float; #count] {
                let __surveyor = #assembly::<#float>::__surveyor(
                    &self.mechanism(__share), &self.modes, __starts, self.at,
                );
                __surveyor.__survey::<{ #runtime::FUSED }>(self.at)
            }
            #coupled
        }
        let __way = |__lane: ::core::primitive::usize| __Way {
            from: #runtime::Dimensions::values(&#name::__lane(&#core.__mechanism, __lane)),
            to: #runtime::Dimensions::values(&#name::__lane(self, __lane)),
            modes: #core.__modes,
            at: [#(#at),*],
        };
    }
}

/// The method of a mechanism with mistakes.
pub(super) fn skeleton(outline: &Outline) -> TokenStream {
    method(outline, TokenStream::new())
}

fn method(outline: &Outline, body: TokenStream) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let (allow, body) = (attribute::allow(), outline.body(body));
    quote! {
        #runtime::if_alloc! {
            #allow
            impl<T: #runtime::Scalar> #name<T> {
                /// These dimensions in the assembly of a mechanism with others: it is followed along the straight way from those to these, at
                /// the reference inputs, in steps too small to leave it. Each lane of `T` has a way of its own; it is followed in `f64`, on
                /// real parts, and the assembly has the digits and derivatives of `T` as one from `assemble()` has.
                ///
                /// # Errors
                ///
                /// `Blocked` where the assembly ends on the way, in one lane at least; what `assemble()` says of these dimensions.
                pub fn assemble_from(
                    &self,
                    __assembly: &#assembly<T>,
                ) -> ::core::result::Result<#assembly<T>, #runtime::AssemblyError> {
                    #body
                }
            }
        }
    }
}

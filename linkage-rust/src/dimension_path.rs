//! The same assembly for other dimensions.

use proc_macro2::TokenStream;
use quote::quote;

use super::constructors::explained;
use super::load::Places;
use super::outline::Outline;
use super::{assembly_data, literal};
use linkage_compiler::ir::CompiledMechanism;

/// `assemble_from`.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let references = outline.inputs.iter();
    let references: Vec<_> = references
        .map(|input| literal::float(input.reference))
        .collect();
    let at = quote!([#(T::from_f64(#references)),*]);
    let reference = quote!([#(#references),*]);
    let core = assembly_data::core(outline, &quote!(__assembly));
    let modes = quote!(#core.__modes);
    if unit.groups.is_empty() {
        return method(outline, quote!(#assembly::__assemble(self, #modes, #at)));
    }
    let path = path(outline, &reference);
    let float = quote!(__p::f64);
    let explained = |result: TokenStream| explained(outline, &result);
    let body = match outline.starts.is_empty() {
        true => {
            let assembled = explained(quote!(#assembly::__assemble(self, #modes, #at)));
            quote! {
                #assembly::__finite(self)?;
                for __lane in 0..T::LANES {
                    #path
                    #runtime::follow_way(&__path, #runtime::Vec::new())?;
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
                #assembly::__finite(self)?;
                let __x = #assembly::<T>::__extend(#prepared, #at);
                let mut __lanes = #runtime::Vec::new();
                for __lane in 0..T::LANES {
                    #path
                    let __states = #runtime::follow_way(
                        &__path,
                        <#vec<_> as ::core::convert::From<[_; _]>>::from([#(#states),*]),
                    )?;
                    __lanes.push(#runtime::prepared_over(
                        &#assembly::<#float>::__GROUPS,
                        &#reference,
                        &__states,
                        |__number, __starts| {
                            #assembly::<#float>::__coupled(
                                &__to, &#modes, #reference, __number, __starts,
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

/// The path of a lane of the call to its dimensions from those of the assembly.
fn path(outline: &Outline, at: &TokenStream) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let core = assembly_data::core(outline, &quote!(__assembly));
    quote! {
        let __to = #name::__lane(self, __lane);
        let __path = #runtime::MechanismPath::new(
            &#name::__lane(&#core.__mechanism, __lane), &__to, &#core.__modes, #at,
        );
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
    let body = outline.body(body);
    quote! {
        #runtime::if_alloc! {
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
                ) -> __p::Result<#assembly<T>, #runtime::AssemblyError> {
                    #body
                }
            }
        }
    }
}

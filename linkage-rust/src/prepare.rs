//! The values that `assemble()` computes for all calls, by the instruction set that calls choose.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::array_types::Types;
use super::outline::Outline;

/// The call of `__prepare`, and the type that makes it one.
pub(super) fn for_machine(outline: &Outline, types: &Types) -> (TokenStream, TokenStream) {
    if outline.prepared == 0 {
        return (quote!([]), TokenStream::new());
    }
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types {
        modes,
        turns,
        prepared,
        ..
    } = types;
    let preparing = format_ident!("__{name}Preparing");
    let call = quote!(#runtime::single(&#preparing { __m, __modes, __turns }, []));
    let item = quote! {
        struct #preparing<'a, T> {
            __m: &'a #name<T>,
            __modes: &'a #modes,
            __turns: &'a #turns,
        }

        impl<T: #runtime::Scalar> #runtime::Single<T, #prepared, 0> for #preparing<'_, T> {
            #[inline(always)]
            fn at<const __FUSED: __p::bool>(&self, []: [T; 0]) -> #prepared {
                #assembly::__prepare::<__FUSED>(self.__m, self.__modes, self.__turns)
            }
        }
    };
    (call, item)
}

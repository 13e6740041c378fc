//! The loops of a kernel over its rows: blocks of rows, and in a block the rows that are side by
//! side. They name `__count` rows and the arguments `__x` from `__first` on. For the statements
//! inside they name `__row`, at which the block begins, `__start`, at which its vector begins, and
//! `__lane`.

use proc_macro2::TokenStream;
use quote::quote;

use super::outline::Outline;

/// Runs `body` for every block of arguments.
pub(super) fn over_blocks(outline: &Outline, body: &TokenStream) -> TokenStream {
    let runtime = &outline.runtime;
    quote! {
        let __count = #runtime::rows(&__results);
        let mut __done_rows = 0;
        while __done_rows < __count {
            let __vectors = #runtime::next_vectors::<__LANES, __BLOCK>(__count - __done_rows, __count);
            let __rows = __vectors * __LANES;
            let __row = ::core::cmp::Ord::min(__done_rows, __count - __rows);
            __arguments.block::<__FUSED, __LANES, __BLOCK>(__first + __row, __rows, &mut __x.0);
            #body
            __done_rows = __row + __rows;
        }
    }
}

/// Runs `one` for every row of a block, and `then` after the rows that are side by side. The loop
/// counts vectors and not rows, so that the optimiser knows that they fit.
pub(super) fn over_vectors(one: &TokenStream, then: &TokenStream) -> TokenStream {
    quote! {
        let mut __vector = 0;
        while __vector < __vectors {
            let __start = __vector * __LANES;
            let mut __lane = __start;
            while __lane < __start + __LANES {
                #one
                __lane += 1;
            }
            #then
            __vector += 1;
        }
    }
}

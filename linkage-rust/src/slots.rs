//! The slots that a sweep over mechanisms prepares for its rows: those that its function uses.

use std::collections::BTreeSet;

use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::array_fields::entry;
use super::body::{self, Runs};
use super::literal;
use super::load::{Places, loader};
use super::outline::Outline;

/// The largest number of slots not used by a function that its sweeps name one by one and leave to
/// the optimiser. With more of them, as in a machine of many parts, the function has a separate
/// program for the slots that it uses: the length of the code printed for a function does not grow
/// with the machine.
const OTHERS: usize = 64;

/// The slots of one function, in order.
pub(super) struct Slots {
    used: Vec<usize>,
    /// Prepares them alone; `None` where that of all slots does it.
    program: Option<Program>,
}

impl Slots {
    /// Those that stages load; `prepare` is the program of all.
    pub(super) fn for_stages(stages: &[Stage], prepare: &Program) -> Self {
        let used = stages
            .iter()
            .flat_map(|stage| stage.program.prepared_slots());
        let used: Vec<usize> = used.collect::<BTreeSet<usize>>().into_iter().collect();
        let others = prepare.outputs.len() - used.len();
        let program = (others > OTHERS).then(|| prepare.part(used.iter().copied()));
        Self { used, program }
    }

    pub(super) fn count(&self) -> usize {
        self.used.len()
    }

    /// Stores them in the row `__slots` for its dimensions `__m`, by `__modes` and `__turns`.
    pub(super) fn prepare(&self, outline: &Outline) -> TokenStream {
        let runtime = &outline.runtime;
        let stores = self.used.iter().enumerate().map(|(index, &slot)| {
            let index = literal::index(index);
            let value = entry("__value", slot);
            quote!(__slots.put(#index, #value);)
        });
        let values = match &self.program {
            Some(program) => {
                let values = self.used.iter().map(|&slot| entry("__value", slot));
                let places = Places::all(outline);
                let statements = body::statements(program, Runs::Once, &loader(outline, &places));
                let outputs = body::outputs(program);
                quote! {
                                        let [#(#values),*] = { #statements #outputs };
                }
            }
            None => {
                let values = (0..outline.prepared).map(|slot| match self.index_of(slot) {
                    Some(_) => entry("__value", slot).into_token_stream(),
                    None => quote!(_),
                });
                quote! {
                    let [#(#values),*] = #runtime::Compiled::prepare::<__FUSED>(__m, __modes, __turns);
                }
            }
        };
        quote!(#values #(#stores)*)
    }

    /// All slots of the row `__slots`; unused slots are zero.
    pub(super) fn all(&self, outline: &Outline) -> TokenStream {
        let stored = |index: usize| {
            let index = literal::index(index);
            quote!(__slots.number(#index))
        };
        if self.program.is_none() {
            let all = (0..outline.prepared).map(|slot| match self.index_of(slot) {
                Some(index) => stored(index),
                None => quote!(__zero),
            });
            return quote!([#(#all),*]);
        }
        let count = literal::index(outline.prepared);
        let used = self.used.iter().enumerate().map(|(index, &slot)| {
            let (slot, stored) = (literal::index(slot), stored(index));
            quote!(__prepared[#slot] = #stored;)
        });
        quote! {{
            let mut __prepared = [__zero; #count];
            #(#used)*
            __prepared
        }}
    }

    /// The index of a slot among those that are used.
    fn index_of(&self, slot: usize) -> Option<usize> {
        self.used.binary_search(&slot).ok()
    }
}

//! The sources of the arguments of sweeps.

use proc_macro2::TokenStream;
use quote::quote;

use super::Sweeps;
use crate::emit::outline::plain;
use crate::emit::{coupled, literal};

impl Sweeps<'_> {
    /// The runtime's `Inputs`.
    pub(super) fn inputs(&self, title: TokenStream) -> TokenStream {
        let runtime = &self.outline.runtime;
        let arguments = &self.function.arguments;
        let names = arguments.iter().map(|name| plain(name));
        let inputs = quote!(#runtime::Inputs::new(#title, [#(#names),*], [#(#arguments),*]));
        self.extended(inputs, 0)
    }

    /// Rows of arguments followed by the states of coupled groups; inputs follow `before` other
    /// arguments.
    fn extended(&self, rows: TokenStream, before: usize) -> TokenStream {
        if self.function.states.is_empty() {
            return rows;
        }
        let runtime = &self.outline.runtime;
        let states = coupled::states_name(self.outline, self.function);
        let first = literal::index(before);
        quote!(#runtime::Extended { inner: #rows, first: #first, states: #states(self) })
    }

    /// The runtime's `Sets`.
    pub(super) fn sets(&self, title: TokenStream) -> TokenStream {
        let runtime = &self.outline.runtime;
        let (mechanism, sets) = (self.outline.name, &self.sets);
        let arguments = &self.function.arguments;
        let names = arguments.iter().map(|name| plain(name));
        let dimensions = self.outline.scalar_fields().len();
        let [inputs, row] = [arguments.len(), dimensions + arguments.len()].map(literal::index);
        let rows = quote! {
            #runtime::Sets::<_, _, _, #inputs, #row> {
                title: #title,
                names: [#(#names),*],
                sets: #sets,
                slices: [#(#arguments),*],
                dimensions: #mechanism::__values,
            }
        };
        self.extended(rows, dimensions)
    }
}

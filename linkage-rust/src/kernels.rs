//! The sweeps of a function over mechanisms: the prepared values of each mechanism that the
//! function uses.

use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::load::Places;
use super::outline::{Function, Outline};
use super::slots::Slots;
use super::stages::Version;
use super::{attribute, literal, stages};

/// The runtime's `SetStages` for the stages of a function that refines; nothing for a function without
/// inputs. `prepare` computes all prepared slots.
pub(super) fn items(
    outline: &Outline,
    function: &Function,
    stages: &[Stage],
    prepare: &Program,
) -> TokenStream {
    if function.arguments.is_empty() || outline.parameters.is_empty() {
        return TokenStream::new();
    }
    let Outline { runtime, name, .. } = outline;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let marker = stages::name(function, Version::refining(function));
    let slots = Slots::for_stages(stages, prepare);
    let modes = Types::new(outline).modes;
    let prepare = slots.prepare(outline).map(|prepare| {
        quote! {
            #[inline(always)]
            fn prepare<const __FUSED: __p::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __turns: &#runtime::RevolutionsOf<#name<T>>,
                __slots: &mut impl #runtime::RowNumbersMut<T>,
            ) { #prepare }
        }
    });
    let [count, all] = [slots.count(), outline.prepared].map(literal::index);
    let used = slots.numbers();
    let dimensions = outline.scalar_fields().len();
    let arguments = Places::of_function(outline, function).width();
    let widths =
        [0, function.arguments.len(), arguments].map(|width| literal::index(dimensions + width));
    quote! {
        #runtime::if_alloc! {
            #(#everywhere)*
            impl<T: #runtime::Scalar> #runtime::SetStages<#name<T>, #(#widths),*> for #marker {
                type Prepared<const __BLOCK: __p::usize> = #runtime::Block<T, __BLOCK, #count>;
                const COLUMNS: &'static [__p::usize] = &#runtime::columns_of::<#all>(&[#(#used),*]);
                #prepare
            }
        }
    }
}

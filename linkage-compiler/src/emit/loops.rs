//! The loops of a kernel, one for each stage over the rows of a block, each a separate method that
//! is inlined: the time of rustc's borrow checker grows with the square of how often a function
//! reads and writes memory, and all loops together do so thousands of times.

use linkage_symbolic::passes::stages::{Stage, memory};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::array_fields::entries;
use super::evaluator::{Version, stage_name};
use super::load::Places;
use super::outline::{Function, Outline};
use super::{blocks, literal};

/// The loops of one of a function's programs.
pub(super) struct Loops<'a> {
    pub(super) outline: &'a Outline<'a>,
    pub(super) function: &'a Function<'a>,
    pub(super) stages: &'a [Stage],
    pub(super) version: Version,
    pub(super) over: Over,
}

/// The contents of rows.
#[derive(Clone, Copy)]
pub(super) enum Over {
    /// The program's arguments.
    Inputs,
    /// The dimensions of a mechanism, followed by the arguments; `slots` prepared slots are
    /// available.
    Sets { slots: usize },
}

impl Loops<'_> {
    /// The count of numbers in a row.
    pub(super) fn arguments(&self) -> usize {
        self.before() + Places::of_function(self.outline, self.function).width()
    }

    fn before(&self) -> usize {
        match self.over {
            Over::Inputs => 0,
            Over::Sets { .. } => self.outline.scalar_fields().len(),
        }
    }

    /// Blocks for the stages' memory and for the values that a stage finishes, made once for all
    /// rows.
    pub(super) fn buffers(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let memory = literal::index(memory(self.stages));
        let finish = |stage: &Stage| !stage.results.is_empty();
        let stages = self.stages.iter().enumerate();
        let done = stages
            .filter(|(_, stage)| finish(stage))
            .map(|(index, stage)| {
                let (done, finished) = (done(index), literal::index(stage.results.len()));
                quote!(let mut #done = #runtime::Block::<T, __LANES, #finished>::filled(__zero);)
            });
        quote! {
            let mut __memory = #runtime::Block::<T, __BLOCK, #memory>::filled(__zero);
            #(#done)*
        }
    }

    /// Runs the loops, one after the other.
    pub(super) fn calls(&self) -> TokenStream {
        let assembly = &self.outline.assembly;
        let slots = self.slots().map(|_| quote!(&__slots,));
        let calls = self.stages.iter().enumerate().map(|(index, stage)| {
            let method = self.name(index);
            let done = done(index);
            let results = (!stage.results.is_empty()).then(|| quote!(&mut #done, &mut __results,));
            quote! {
                #assembly::#method::<__FUSED, __LANES, __BLOCK>(
                    &__core, &__x, #slots &mut __memory, #results __vectors, __row,
                );
            }
        });
        quote!(#(#calls)*)
    }

    /// The loops as methods.
    pub(super) fn methods(&self) -> TokenStream {
        (0..self.stages.len())
            .map(|index| self.method(index))
            .collect()
    }

    fn method(&self, index: usize) -> TokenStream {
        let Outline { runtime, core, .. } = self.outline;
        let stage = &self.stages[index];
        let (name, row) = (self.name(index), self.row(index));
        let write = stage.results.iter().enumerate().map(|(k, &result)| {
            let [k, result] = [k, result].map(literal::index);
            quote!(__done.write(#k, __results, #result, __row + __start);)
        });
        let vectors = blocks::over_vectors(&row, &quote!(#(#write)*));
        let [arguments, memory, finished, width] = [
            self.arguments(),
            memory(self.stages),
            stage.results.len(),
            self.function.width(),
        ]
        .map(literal::index);
        let slots = self.slots().map(literal::index);
        let slots = slots.map(|count| quote!(__slots: &#runtime::Block<T, __BLOCK, #count>,));
        let results = (!stage.results.is_empty()).then(|| {
            quote! {
                __done: &mut #runtime::Block<T, __LANES, #finished>,
                __results: &mut [&mut [T]; #width],
            }
        });
        quote! {
            #[inline(always)]
            fn #name<
                const __FUSED: ::core::primitive::bool,
                const __LANES: ::core::primitive::usize,
                const __BLOCK: ::core::primitive::usize,
            >(
                __core: &#core<T>,
                __x: &#runtime::Block<T, __BLOCK, #arguments>,
                #slots
                __memory: &mut #runtime::Block<T, __BLOCK, #memory>,
                #results
                __vectors: ::core::primitive::usize,
                __row: ::core::primitive::usize,
            ) {
                #vectors
            }
        }
    }

    /// A stage at one row.
    fn row(&self, index: usize) -> TokenStream {
        let Self {
            outline, function, ..
        } = *self;
        let stage = &self.stages[index];
        let core = match self.over {
            Over::Inputs => quote!(__core),
            Over::Sets { .. } => {
                let (assembly, at_lane) = (&outline.assembly, at_lane(function));
                quote!(#assembly::#at_lane(__core, __x, __slots, __lane))
            }
        };
        let method = stage_name(function, index, self.version);
        let inputs = Places::of_function(outline, function).read(&stage.program);
        let inputs = inputs.into_iter().map(|position| {
            let position = literal::index(self.before() + position);
            quote!(__x.at(#position, __lane))
        });
        let read = stage.taken.iter().map(|&position| {
            let position = literal::index(position);
            quote!(__memory.at(#position, __lane))
        });
        let next = entries("__next", stage.kept.len());
        let keep = next.iter().zip(&stage.kept).map(|(next, &position)| {
            let position = literal::index(position);
            quote!(__memory.set(#position, __lane, #next);)
        });
        let finished = entries("__finished", stage.results.len());
        let finish = finished.iter().enumerate().map(|(k, finished)| {
            let k = literal::index(k);
            quote!(__done.set(#k, __lane - __start, #finished);)
        });
        quote! {
            let ([#(#next),*], [#(#finished),*]) =
                #core.#method::<__FUSED, true>([#(#inputs),*], [#(#read),*]);
            #(#keep)*
            #(#finish)*
        }
    }

    fn slots(&self) -> Option<usize> {
        match self.over {
            Over::Inputs => None,
            Over::Sets { slots } => Some(slots),
        }
    }

    fn name(&self, index: usize) -> Ident {
        let name = self.function.name;
        let word = self.version.word();
        let over = match self.over {
            Over::Inputs => "",
            Over::Sets { .. } => "_sets",
        };
        format_ident!("__loop{index}{word}{over}_of_{name}")
    }
}

/// The method that gives the assembly of one lane.
pub(super) fn at_lane(function: &Function) -> Ident {
    format_ident!("__at_lane_of_{}", function.name)
}

/// The values that stage `index` has finished, for some rows side by side.
fn done(index: usize) -> Ident {
    format_ident!("__done{index}", span = Span::mixed_site())
}

//! What the sweeps of a function run: its stages, each in a loop over a block of positions.

use linkage_symbolic::passes::stages::{Stage, memory};
use linkage_symbolic::program::Program;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::entries::entries;
use super::evaluator::{Version, stage_name};
use super::outline::{Function, Outline};
use super::slots::Slots;
use super::{attribute, blocks, literal, sealed, sweeps};

/// The kernels over inputs and over mechanisms; nothing for a function without inputs. `beside` are the stages of the program for
/// dimensions that tables do not know, if that is another one; `prepare` computes all prepared slots.
pub(super) fn items(
    outline: &Outline,
    function: &Function,
    stages: &[Stage],
    beside: Option<&[Stage]>,
    prepare: &Program,
) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let Outline {
        runtime, assembly, ..
    } = outline;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let mut over_inputs = over_inputs(outline, function, (stages, Version::Called));
    let sets = match beside {
        None => (stages, Version::Called),
        Some(beside) => (beside, Version::Beside),
    };
    if beside.is_some() {
        over_inputs.extend(self::over_inputs(outline, function, sets));
    }
    let over_sets =
        (!outline.parameters.is_empty()).then(|| over_sets(outline, function, sets, prepare));
    let allow = attribute::allow();
    quote! {
        #runtime::if_alloc! {
            #(#everywhere)*
            #allow
            impl<T: #runtime::Scalar> #assembly<T> {
                #over_inputs
                #over_sets
            }
        }
    }
}

fn over_inputs(outline: &Outline, function: &Function, stages: Stages) -> TokenStream {
    let arguments = function.places(outline).width();
    let loops = loops(outline, function, stages, 0, &quote!(__core));
    let buffers = buffers(outline, stages.0);
    let kernel = kernel(outline, function, arguments, &buffers, &loops);
    let method = sweeps::over_inputs(function, stages.1);
    method_of(outline, function, &method, arguments, &kernel)
}

/// A row is the dimensions of a mechanism, then its inputs. The first loop prepares what the function uses.
fn over_sets(
    outline: &Outline,
    function: &Function,
    stages: Stages,
    prepare: &Program,
) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        core,
        ..
    } = outline;
    let dimensions = outline.scalar_fields().len();
    let arguments = dimensions + function.places(outline).width();
    let slots = Slots::of(stages.0, prepare);
    let modes = (slots.count() > 0).then(|| quote!(let #core { __modes, __turns, .. } = __core;));
    let prepare = modes.is_some().then(|| {
        let prepare = slots.prepare(outline);
        // All lanes of the block, also those without a row: only a loop of a fixed length becomes vectors of full width.
        quote! {
            let mut __lane = 0;
            while __lane < __BLOCK {
                let __mechanism = #name::__at_lane(&__x, __lane);
                #prepare
                __lane += 1;
            }
        }
    });
    let at_lane = format_ident!("__at_lane_of_{}", function.name);
    let loops = loops(
        outline,
        function,
        stages,
        dimensions,
        &quote!(#assembly::#at_lane(&__core, &__x, &__slots, __lane)),
    );
    let memory = buffers(outline, stages.0);
    let count = literal::index(slots.count());
    let buffers = quote! {
        #modes
        let mut __slots = #runtime::Block::<T, __BLOCK, #count>::filled(__zero);
        #memory
    };
    let body = quote!(#prepare #loops);
    let kernel = kernel(outline, function, arguments, &buffers, &body);
    let method = sweeps::over_sets(function);
    let method = method_of(outline, function, &method, arguments, &kernel);
    let prepared = slots.all(outline);
    let arguments = literal::index(arguments);
    quote! {
        #method

        /// The assembly of one lane, with what this function uses of it.
        #[inline(always)]
        fn #at_lane<const __BLOCK: ::core::primitive::usize>(
            __core: &#core<T>,
            __x: &#runtime::Block<T, __BLOCK, #arguments>,
            __slots: &#runtime::Block<T, __BLOCK, #count>,
            __lane: ::core::primitive::usize,
        ) -> #core<T> {
            let __zero = T::from_f64(0.0);
            #core {
                __mechanism: #name::__at_lane(__x, __lane),
                __prepared: #prepared,
                ..*__core
            }
        }
    }
}

/// The method `name` that gives a kernel.
fn method_of(
    outline: &Outline,
    function: &Function,
    name: &Ident,
    arguments: usize,
    kernel: &TokenStream,
) -> TokenStream {
    let runtime = &outline.runtime;
    let [arguments, width] = [arguments, function.width()].map(literal::index);
    let core = sealed::core(outline, &quote!(self));
    quote! {
        fn #name(&self) -> impl #runtime::Kernel<T, #arguments, #width> + use<'_, T> {
            #kernel
            __Kernel(#core)
        }
    }
}

fn kernel(
    outline: &Outline,
    function: &Function,
    arguments: usize,
    buffers: &TokenStream,
    body: &TokenStream,
) -> TokenStream {
    let Outline { runtime, core, .. } = outline;
    let [arguments, width] = [arguments, function.width()].map(literal::index);
    let loops = blocks::over_blocks(outline, body);
    quote! {
        struct __Kernel<'a, T>(&'a #core<T>);
        impl<T: #runtime::Scalar> #runtime::Kernel<T, #arguments, #width> for __Kernel<'_, T> {
            #[inline(always)]
            fn evaluate<
                const __FUSED: ::core::primitive::bool,
                const __LANES: ::core::primitive::usize,
                const __BLOCK: ::core::primitive::usize,
            >(
                &self,
                __arguments: &impl #runtime::Arguments<T, #arguments>,
                __first: ::core::primitive::usize,
                mut __results: [&mut [T]; #width],
            ) {
                let __core = *self.0;
                let __zero = T::from_f64(0.0);
                let mut __x = #runtime::Block::<T, __BLOCK, #arguments>::filled(__zero);
                #buffers
                #loops
            }
        }
    }
}

/// Blocks for the stages' memory and for what a stage finishes, made once for all rows.
fn buffers(outline: &Outline, stages: &[Stage]) -> TokenStream {
    let runtime = &outline.runtime;
    let memory = literal::index(memory(stages));
    let done = stages.iter().enumerate().map(|(index, stage)| {
        let (done, finished) = (done(index), literal::index(stage.results.len()));
        quote!(let mut #done = #runtime::Block::<T, __LANES, #finished>::filled(__zero);)
    });
    quote! {
        let mut __memory = #runtime::Block::<T, __BLOCK, #memory>::filled(__zero);
        #(#done)*
    }
}

/// The stages of one of a function's programs.
type Stages<'a> = (&'a [Stage], Version);

/// One loop for each stage. `core` is that of the assembly at `__lane`; the program's arguments follow `before` others.
fn loops(
    outline: &Outline,
    function: &Function,
    (stages, version): Stages,
    before: usize,
    core: &TokenStream,
) -> TokenStream {
    let inputs: Vec<_> = (before..before + function.places(outline).width())
        .map(|input| {
            let input = literal::index(input);
            quote!(__x.at(#input, __lane))
        })
        .collect();
    let mut loops = TokenStream::new();
    for (index, stage) in stages.iter().enumerate() {
        let method = stage_name(function, index, version);
        let read = stage.taken.iter().map(|&place| {
            let place = literal::index(place);
            quote!(__memory.at(#place, __lane))
        });
        let done = done(index);
        let next = entries("__next", stage.kept.len());
        let keep = next.iter().zip(&stage.kept).map(|(next, &place)| {
            let place = literal::index(place);
            quote!(__memory.set(#place, __lane, #next);)
        });
        let finished = entries("__finished", stage.results.len());
        let finish = finished.iter().enumerate().map(|(k, finished)| {
            let k = literal::index(k);
            quote!(#done.set(#k, __lane - __start, #finished);)
        });
        let write = stage.results.iter().enumerate().map(|(k, &result)| {
            let [k, result] = [k, result].map(literal::index);
            quote!(#done.write(#k, &mut __results, #result, __row + __start);)
        });
        let one = quote! {
            let ([#(#next),*], [#(#finished),*]) =
                #core.#method::<__FUSED, true>([#(#inputs),*], [#(#read),*]);
            #(#keep)*
            #(#finish)*
        };
        loops.extend(blocks::over_vectors(&one, &quote!(#(#write)*)));
    }
    loops
}

/// What stage `index` has finished, for some rows side by side.
fn done(index: usize) -> Ident {
    format_ident!("__done{index}", span = Span::mixed_site())
}

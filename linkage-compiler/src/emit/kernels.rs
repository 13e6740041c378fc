//! The items that the sweeps of a function run: its stages, each in a loop over a block of
//! positions.

use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::evaluator::Version;
use super::loops::{Loops, Over, at_lane};
use super::outline::{Function, Outline};
use super::slots::Slots;
use super::{assembly_data, attribute, blocks, literal, sweeps};

/// The kernels over inputs and over mechanisms; none for a function without inputs. `beside` are
/// the stages of the program for dimensions that tables do not know, if that is another one;
/// `prepare` computes all prepared slots.
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

/// The stages of one of a function's programs.
type Stages<'a> = (&'a [Stage], Version);

fn over_inputs(outline: &Outline, function: &Function, (stages, version): Stages) -> TokenStream {
    let loops = Loops {
        outline,
        function,
        stages,
        version,
        over: Over::Inputs,
    };
    let kernel = kernel(&loops, &loops.buffers(), &loops.calls());
    let method = sweeps::over_inputs(function, version);
    let method = method_of(&loops, &method, &kernel);
    let loops = loops.methods();
    quote!(#method #loops)
}

/// A row is the dimensions of a mechanism, then its inputs. The first loop prepares the slots that
/// the function uses.
fn over_sets(
    outline: &Outline,
    function: &Function,
    (stages, version): Stages,
    prepare: &Program,
) -> TokenStream {
    let Outline {
        runtime,
        name,
        core,
        ..
    } = outline;
    let slots = Slots::for_stages(stages, prepare);
    let loops = Loops {
        outline,
        function,
        stages,
        version,
        over: Over::Sets {
            slots: slots.count(),
        },
    };
    let modes = (slots.count() > 0).then(|| quote!(let #core { __modes, __turns, .. } = __core;));
    let prepare = modes.is_some().then(|| {
        let prepare = slots.prepare(outline);
        // All lanes of the block, also those without a row: only a loop of a fixed length becomes
        // vectors of full width.
        quote! {
            let mut __lane = 0;
            while __lane < __BLOCK {
                let __mechanism = #name::__at_lane(&__x, __lane);
                #prepare
                __lane += 1;
            }
        }
    });
    let memory = loops.buffers();
    let count = literal::index(slots.count());
    let buffers = quote! {
        #modes
        let mut __slots = #runtime::Block::<T, __BLOCK, #count>::filled(__zero);
        #memory
    };
    let calls = loops.calls();
    let kernel = kernel(&loops, &buffers, &quote!(#prepare #calls));
    let method = method_of(&loops, &sweeps::over_sets(function), &kernel);
    let at_lane = at_lane(function);
    let prepared = slots.all(outline);
    let arguments = literal::index(loops.arguments());
    let loops = loops.methods();
    quote! {
        #method
        #loops

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
fn method_of(loops: &Loops, name: &Ident, kernel: &TokenStream) -> TokenStream {
    let runtime = &loops.outline.runtime;
    let [arguments, width] = [loops.arguments(), loops.function.width()].map(literal::index);
    let core = assembly_data::core(loops.outline, &quote!(self));
    quote! {
        fn #name(&self) -> impl #runtime::Kernel<T, #arguments, #width> + use<'_, T> {
            #kernel
            __Kernel(#core)
        }
    }
}

fn kernel(loops: &Loops, buffers: &TokenStream, body: &TokenStream) -> TokenStream {
    let outline = loops.outline;
    let Outline { runtime, core, .. } = outline;
    let [arguments, width] = [loops.arguments(), loops.function.width()].map(literal::index);
    let loops = blocks::over_blocks(outline, body);
    quote! {
        struct __Kernel<'a, T>(&'a #core<T>);
        impl<T: #runtime::Scalar> #runtime::Kernel<T, #arguments, #width> for __Kernel<'_, T> {
            const WIDE: ::core::primitive::bool = !::core::cfg!(debug_assertions);

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

//! Tracking of the continuous angles through the ranges of the inputs, lane by lane.

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::body;
use super::body::Runs;
use super::load::{Places, loader};
use super::outline::Outline;
use super::{array_types, literal};
use linkage_compiler::ir::{CompiledMechanism, ContinuousAngle};

/// The centres and windings of the continuous angles, lane by lane. If they cannot be found because
/// a loop does not close, the error is about that loop.
pub(super) fn turning(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        inputs,
        ..
    } = outline;
    if unit.angles.is_empty() {
        return quote!(#runtime::Turns { centres: [], windings: [] });
    }
    let title = outline.title();
    let at_estimates = at_estimates(outline, unit);
    let (starts, at) = match outline.starts.is_empty() {
        true => (TokenStream::new(), quote!(__at)),
        false => (
            quote!(&#assembly::<__p::f64>::__starts(::core::slice::from_ref(&__lanes[__lane])),),
            quote!(__x),
        ),
    };
    let count = literal::index(unit.angles.len());
    let lane = (0..inputs.len()).map(|input| {
        let input = literal::index(input);
        quote!(T::lane(__at[#input], __lane))
    });
    quote! {
        match #runtime::turns(|__lane| {
            let __lane_mechanism: #name<__p::f64> = #name::__lane(__m, __lane);
            #assembly::<__p::f64>::__wind(
                &__lane_mechanism, &__modes, #starts [#(#lane),*], #count,
            )
        }) {
            __p::Ok(__turns) => __turns,
            __p::Err(__unknown) => {
                let __turns = #at_estimates;
                let __prepared = Self::__prepare_for_machine(__m, &__modes, &__turns);
                Self::__close(__m, &__modes, &__prepared, #at)?;
                return __p::Err(#runtime::AssemblyError::NoWinding {
                    mechanism: #title,
                    unknown: __unknown,
                });
            }
        }
    }
}

/// Centres at the start estimates, no winding.
pub(super) fn at_estimates(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let runtime = &outline.runtime;
    let angles = unit.angles.iter();
    let estimates = angles.map(|angle| literal::float(angle.estimate));
    quote!(#runtime::Turns::at_estimates([#(#estimates),*]))
}

/// `__wind` and the program of the directions; nothing for a mechanism without continuous angles.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if unit.angles.is_empty() {
        return TokenStream::new();
    }
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types {
        modes,
        arguments,
        prepared,
        ..
    } = Types::new(outline, unit);
    let angle_count = literal::index(unit.angles.len());
    let input_count = literal::index(unit.inputs.len());
    let table = unit.angles.iter().map(|angle| search(outline, unit, angle));
    let inputs = unit.inputs.iter();
    let references = inputs.map(|input| literal::float(input.reference));
    let directions = pairs(outline, &unit.directions);
    let (bearings, bearings_of) = bearings(outline, unit);
    let (starts, argument) = match outline.starts.is_empty() {
        true => (TokenStream::new(), quote!(__x)),
        false => {
            let starts = array_types::starts_type(outline);
            (
                quote!(__starts: &#starts,),
                quote!(Self::__extend(__starts, __x)),
            )
        }
    };
    quote! {
        impl #assembly<__p::f64> {
            #[inline]
            fn __wind(
                __m: &#name<__p::f64>,
                __modes: &#modes,
                #starts
                __at: [__p::f64; #input_count],
                __count: __p::usize,
            ) -> __p::Result<
                #runtime::Turns<__p::f64, #angle_count, #input_count>,
                &'static __p::str,
            > {
                #runtime::wind(&[#(#table),*], &#bearings, __count, [#(#references),*], __at, |__turns| {
                    let __prepared = Self::__prepare_for_machine(__m, __modes, __turns);
                    move |__x| Self::__directions::<{ #runtime::FUSED }>(__m, __modes, &__prepared, #argument)
                })
            }
        }
        impl<T: #runtime::Scalar> #assembly<T> {
            fn __directions<const __FUSED: __p::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> [[T; 2]; #angle_count] { #directions }
            #bearings_of
        }
    }
}

/// The runtime's `Angle`: which angle, and along which inputs it is followed.
fn search(outline: &Outline, unit: &CompiledMechanism, angle: &ContinuousAngle) -> TokenStream {
    let runtime = &outline.runtime;
    let unknown = &unit.unknowns[angle.unknown].name;
    let estimate = literal::float(angle.estimate);
    let along = angle.inputs.iter().map(|&input| {
        let (low, high) = unit.inputs[input].followed;
        let (low, high) = (literal::float(low), literal::float(high));
        let rates = unit.inputs[input]
            .rates
            .iter()
            .map(|rate| literal::float(*rate));
        let input = literal::index(input);
        quote!(#runtime::Along { input: #input, low: #low, high: #high, rates: &[#(#rates),*] })
    });
    let phases = angle.phases.iter().map(|phase| match &phase.turns {
        Some(turns) => {
            let turns = turns.iter().map(|turns| literal::float(*turns));
            quote!(__p::Some([#(#turns),*]))
        }
        None => quote!(__p::None),
    });
    quote! {
        #runtime::Angle { unknown: #unknown, estimate: #estimate, along: &[#(#along),*], phases: &[#(#phases),*] }
    }
}

/// The expression that requests the vectors of all phases, and the function that computes them.
fn bearings(outline: &Outline, unit: &CompiledMechanism) -> (TokenStream, TokenStream) {
    let Outline { runtime, name, .. } = outline;
    if unit.bearings.outputs.is_empty() {
        return (quote!([]), TokenStream::new());
    }
    let modes = Types::new(outline, unit).modes;
    let count = literal::index(unit.bearings.outputs.len() / 2);
    let vectors = pairs(outline, &unit.bearings);
    let function = quote! {
        fn __bearings<const __FUSED: __p::bool>(
            __m: &#name<T>,
            __modes: &#modes,
        ) -> [[T; 2]; #count] { #vectors }
    };
    let call = quote!(Self::__bearings::<{ #runtime::FUSED }>(__m, __modes));
    (call, function)
}

/// A program that ends in pairs, `[[cosine, sine], ...]`.
fn pairs(outline: &Outline, program: &Program) -> TokenStream {
    let places = Places::all(outline);
    let statements = body::statements(program, Runs::Once, &loader(outline, &places));
    let pairs = program.outputs.chunks(2).map(|pair| {
        let names = pair.iter().map(|value| body::name(*value));
        quote!([#(#names),*])
    });
    quote!(#statements [#(#pairs),*])
}

//! The mechanism as the runtime assembles it: the trait `Compiled`.

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::{Types, starts_type};
use super::body::Runs;
use super::load::{Places, loader};
use super::outline::Outline;
use super::{body, literal};
use linkage_compiler::ir::{CompiledMechanism, ContinuousAngle};

/// The trait.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types {
        modes,
        inputs,
        centres,
        windings,
        prepared,
        arguments,
    } = Types::new(outline);
    let states = starts_type(outline);
    let description = description(outline, unit);
    let all = match outline.starts.is_empty() {
        true => quote!(*__inputs),
        false => quote!(#assembly::<T>::__extend(__states, *__inputs)),
    };
    let prepare = program(outline, &unit.prepare, put_prepared);
    let gaps = by_build(outline, &unit.gaps, body::outputs);
    let directions = by_build(outline, &unit.directions, body::pairs);
    let bearings = by_build(outline, &unit.bearings, body::pairs);
    let as_ref = quote!(impl #runtime::AsRef);
    quote! {
        impl<T: #runtime::Scalar> #runtime::Compiled for #name<T> {
            type Scalar = T;
            type Plain = #name<__p::f64>;
            type Assembly = #assembly<T>;
            type Modes = #modes;
            type Inputs = #inputs;
            type Centres = #centres;
            type Windings = #windings;
            type Prepared = #prepared;
            type States = #states;
            type Arguments = #arguments;

            fn description(&self) -> &'static #runtime::Description { const { &#description } }

            fn assembly(__sealed: #runtime::DataOf<Self>) -> #assembly<T> { #assembly { __sealed } }

            #[inline(always)]
            fn data(__assembly: &#assembly<T>) -> &#runtime::DataOf<Self> { &__assembly.__sealed }

            #[inline(always)]
            fn dimensions(&self) -> #as_ref<[T]> { __values(self) }

            #[inline(always)]
            fn with_dimensions(&self, __dimension: impl #runtime::Fn(__p::usize) -> T) -> Self {
                __of(__dimension)
            }

            fn plain(&self, __dimension: impl #runtime::Fn(__p::usize) -> __p::f64) -> Self::Plain {
                __of(__dimension)
            }

            #[inline(always)]
            fn arguments(&self, __states: &#states, __inputs: &#inputs) -> #arguments { #all }

            #[inline(always)]
            fn prepare<const __FUSED: __p::bool>(
                &self,
                __modes: &#modes,
                __turns: &#runtime::RevolutionsOf<Self>,
                __slots: &mut impl #runtime::RowNumbersMut<T>,
            ) {
                let __m = self;
                #prepare
            }

            fn gaps(&self, __modes: &#modes, __prepared: &#prepared, __x: #arguments) -> #as_ref<[T]> {
                #gaps
            }

            fn directions(
                &self,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> #as_ref<[[T; 2]]> {
                #directions
            }

            fn bearings(&self, __modes: &#modes) -> #as_ref<[[T; 2]]> { #bearings }
        }
    }
}

/// Puts the outputs of the program that prepares an assembly into the slots of these numbers.
fn put_prepared(prepare: &Program) -> TokenStream {
    put(prepare, 0..prepare.outputs.len())
}

/// Puts outputs into the slots of these numbers.
pub(super) fn put(program: &Program, slots: impl IntoIterator<Item = usize>) -> TokenStream {
    let values = slots.into_iter().zip(program.outputs.iter().copied());
    body::puts(quote!(__slots.put), values)
}

/// A program of the mechanism `self`, by the instructions of the build.
fn by_build(
    outline: &Outline,
    of_mechanism: &Program,
    outputs: fn(&Program) -> TokenStream,
) -> TokenStream {
    let runtime = &outline.runtime;
    let program = program(outline, of_mechanism, outputs);
    quote! {
        const __FUSED: __p::bool = #runtime::FUSED;
        let __m = self;
        #program
    }
}

/// A program over all inputs and states of the mechanism, ending in its outputs.
pub(super) fn program(
    outline: &Outline,
    program: &Program,
    outputs: fn(&Program) -> TokenStream,
) -> TokenStream {
    let places = Places::all(outline);
    let statements = body::statements(program, Runs::Once, &loader(outline, &places));
    let outputs = outputs(program);
    quote!(#statements #outputs)
}

/// The literal of the runtime's `Description`.
fn description(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let title = outline.title();
    let constants = quote!(#name::<__p::f64>);
    let needed = unit.groups.iter().flat_map(|group| &group.parameters);
    let needed = needed.map(|&index| literal::index(index));
    let units = unit.groups.iter().map(|group| &group.gap_unit);
    let prepared = literal::index(outline.prepared);
    let modes = outline.default_modes();
    let angles = unit.angles.iter().map(|one| angle(outline, unit, one));
    quote! {
        #runtime::Description {
            name: #title,
            inputs: #constants::INPUTS,
            parameters: #constants::PARAMETERS,
            groups: #constants::STRUCTURE.groups,
            needed: &[#(#needed),*],
            gap_units: &[#(#units),*],
            prepared: #prepared,
            modes: &#modes,
            angles: &[#(#angles),*],
        }
    }
}

/// The runtime's `Angle`: which angle, and along which inputs it is followed.
fn angle(outline: &Outline, unit: &CompiledMechanism, angle: &ContinuousAngle) -> TokenStream {
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
            quote!(__p::Some(&[#(#turns),*]))
        }
        None => quote!(__p::None),
    });
    quote! {
        #runtime::Angle { unknown: #unknown, estimate: #estimate, along: &[#(#along),*], phases: &[#(#phases),*] }
    }
}

//! The mechanism of sweeps over sets whose coupled groups are followed from its dimensions to
//! others.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::array_fields::entries;
use crate::array_types::Types;
use crate::load::Places;
use crate::outline::{Function, Outline};
use crate::stages::Version;
use crate::{attribute, code, literal, stages};

/// The type of the mechanism that changes its dimensions.
fn moving_name(outline: &Outline) -> Ident {
    format_ident!("__{}Moving", outline.name, span = Span::call_site())
}

/// The runtime's `Moving`, and how an assembly begins to move.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        visibility,
        name,
        assembly,
        ..
    } = outline;
    let moving = moving_name(outline);
    let float = quote!(__p::f64);
    let modes = code::tokens(&Types::new(outline).modes);
    let dimensions = outline.scalar_fields().len();
    let [parameters, angles, inputs, width, groups] = [
        dimensions,
        outline.continuous_angles,
        outline.inputs.len(),
        dimensions + Places::all(outline).width(),
        outline.starts.len(),
    ]
    .map(literal::index);
    let kernels = outline
        .starts
        .iter()
        .enumerate()
        .map(|(number, start)| kernel(outline, number, start.size + 2));
    let last = outline.starts.len() - 1;
    let corrections = (0..=last).map(|number| {
        let kernel = kernel_name(outline, number);
        let pattern = match number == last {
            true => quote!(_),
            false => {
                let number = literal::index(number);
                quote!(#number)
            }
        };
        quote!(#pattern => #runtime::fill(&#runtime::OverInputs::<_, #kernel>::new(&self), __rows, __columns),)
    });
    let core = &outline.core;
    let functions = outline
        .functions
        .iter()
        .map(|function| of_function(outline, function));
    quote! {
        #[doc(hidden)]
        #visibility struct #moving {
            __m: #name<#float>,
            __modes: #modes,
            __turns: #runtime::Turns<#float, #angles, #inputs>,
        }
        impl #runtime::StageData<#float> for #moving {}
        #(#kernels)*
        impl #runtime::Moving<#parameters, #width> for #moving {
            const GROUPS: &'static [#runtime::CoupledGroup] = {
                const __GROUPS: &[#runtime::CoupledGroup; #groups] = &#assembly::<#float>::__GROUPS;
                __GROUPS
            };

            #[inline]
            fn dimensions(&self) -> [#float; #parameters] { #runtime::Dimensions::values(&self.__m) }

            #[inline]
            fn correct(
                &self,
                __group: __p::usize,
                __rows: &impl #runtime::Arguments<#float, #width>,
                __columns: &mut #runtime::Columns<#float>,
            ) {
                match __group { #(#corrections)* }
            }
        }
        impl<T: #runtime::Scalar> #assembly<T> {
            /// One lane, where it stands.
            fn __moving(__core: &#core<T>, __lane: __p::usize) -> #moving {
                #moving {
                    __m: #runtime::Compiled::lane(&__core.dimensions, __lane),
                    __modes: __core.modes,
                    __turns: __core.revolutions.lane(__lane),
                }
            }
        }
        #(#functions)*
    }
}

fn kernel_name(outline: &Outline, number: usize) -> Ident {
    format_ident!(
        "__{}Correct{number}",
        outline.name,
        span = Span::call_site()
    )
}

/// The program that corrects a group, over rows of dimensions and arguments: it has `outputs`
/// outputs.
fn kernel(outline: &Outline, number: usize, outputs: usize) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let float = quote!(__p::f64);
    let size = quote!(__p::usize);
    let (kernel, moving) = (kernel_name(outline, number), moving_name(outline));
    let method = format_ident!("__correct{number}");
    let dimensions = outline.scalar_fields().len();
    let position_columns = dimensions..dimensions + Places::all(outline).width();
    let width = literal::index(position_columns.end);
    let arguments = position_columns.map(|column| {
        let column = literal::index(column);
        quote!(__row.number(#column))
    });
    let found = entries("__found", outputs);
    let columns: Vec<_> = (0..outputs).map(literal::index).collect();
    let [outputs, prepared] = [outputs, outline.prepared].map(literal::index);
    quote! {
        struct #kernel;
        impl<'a> #runtime::Staged<#float, &'a #moving, #width, #outputs> for #kernel {
            const WIDE: __p::bool = !::core::cfg!(debug_assertions);
            type Memory<const __BLOCK: #size> = #runtime::Block<#float, __BLOCK, 0>;

            #[inline(always)]
            fn run(__stages: &mut impl #runtime::RunStages<#float, &'a #moving, Self>) {
                __stages.stage::<0>();
            }
        }
        impl<'a> #runtime::Stage<#float, &'a #moving, 0> for #kernel {
            #[inline(always)]
            fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
                __moving: &&'a #moving,
                __row: &mut impl #runtime::StageRow<#float>,
            ) {
                let #moving { __modes, __turns, .. } = *__moving;
                let __m: #name<#float> = __of(|__k| __row.number(__k));
                let mut __prepared = [0.0; #prepared];
                #runtime::Compiled::prepare::<__FUSED>(&__m, __modes, __turns, &mut __prepared);
                let [#(#found),*] = #assembly::<#float>::#method::<__FUSED>(
                    &__m, __modes, &__prepared, [#(#arguments),*],
                );
                #(__row.finish(#columns, #found);)*
            }

            #[inline(always)]
            fn write(__rows: &mut impl #runtime::FinishedRows) { #(__rows.write(#columns);)* }
        }
    }
}

/// The runtime's `FollowedStages` for a function; nothing if it uses no states or has no sweep.
fn of_function(outline: &Outline, function: &Function) -> TokenStream {
    if function.states.is_empty() || function.arguments.is_empty() {
        return TokenStream::new();
    }
    let Outline {
        runtime,
        assembly,
        core,
        ..
    } = outline;
    let stages = stages::name(function, Version::refining(function));
    let everywhere = &attribute::split(function.attributes).everywhere;
    let moving = moving_name(outline);
    let all = Places::all(outline);
    let states = function.states.iter().flat_map(|&group| {
        let first = all.state(group, 0);
        first..=first + outline.starts[group].size
    });
    let dimensions = outline.scalar_fields().len();
    // Speeds and loads are numbers of the function's rows, and none of the mechanism's.
    let inputs = function.positions.iter().copied();
    let inputs = inputs.map(|position| Some(position).filter(|&p| p < outline.inputs.len()));
    let places = inputs
        .chain(states.map(Some))
        .map(|position| match position {
            None => quote!(__p::Option::None),
            Some(position) => {
                let index = literal::index(dimensions + position);
                quote!(__p::Option::Some(#index))
            }
        });
    let groups = function.states.iter().map(|&group| {
        let [number, first, size] = [
            group,
            dimensions + all.state(group, 0),
            outline.starts[group].size,
        ]
        .map(literal::index);
        quote!((#number, #first, #size))
    });
    let [parameters, width] = [dimensions, dimensions + all.width()].map(literal::index);
    quote! {
        #(#everywhere)*
        impl<T: #runtime::Scalar> #runtime::FollowedStages<#core<T>, #parameters, #width> for #stages {
            type Moving = #moving;
            const PLACES: &'static [__p::Option<__p::usize>] = &[#(#places),*];
            const GROUPS: &'static [(__p::usize, __p::usize, __p::usize)] =
                &[#(#groups),*];

            fn moving(__core: &#core<T>, __lane: __p::usize) -> #moving {
                #assembly::__moving(__core, __lane)
            }
        }
    }
}

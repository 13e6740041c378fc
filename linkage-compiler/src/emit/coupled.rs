//! What an assembly with coupled groups has beside the others: prepared starts, the arguments that they add to programs, and the
//! programs that prepare them.

use linkage_runtime::numeric::roots::Variable;
use linkage_symbolic::program::Program;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::assembly::Types;
use super::facts::Facts;
use super::load::{Places, loader};
use super::outline::{Function, Outline, Start};
use super::{attribute, body, literal};
use crate::lower::{Coupled, Lowered};
use crate::model::Mechanism;

/// The type of all starts.
pub(super) fn starts_type(outline: &Outline) -> TokenStream {
    let runtime = &outline.runtime;
    let types = outline.starts.iter().map(|start| {
        let size = literal::index(start.size);
        match start.inputs.len() {
            1 => quote!(#runtime::Coupled<#size>),
            inputs => {
                let inputs = literal::index(inputs);
                quote!(#runtime::CoupledGrid<#inputs, #size>)
            }
        }
    });
    quote!((#(#types,)*))
}

/// Everything for the coupled groups of a mechanism; nothing if it has none.
pub(super) fn items(
    outline: &Outline,
    mechanism: &Mechanism,
    facts: &Facts,
    lowered: &Lowered,
) -> TokenStream {
    if outline.starts.is_empty() {
        return TokenStream::new();
    }
    let mut items = lookups(outline);
    items.extend(programs(outline, facts, lowered));
    items.extend(preparing(outline, mechanism, facts, lowered));
    items
}

/// From the starts of the lanes to those of the assembly, and from inputs to arguments.
fn lookups(outline: &Outline) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let starts = starts_type(outline);
    let count = literal::index(outline.starts.len());
    let made = outline.starts.iter().enumerate().map(|(number, start)| {
        let number = literal::index(number);
        let size = literal::index(start.size);
        match start.inputs.len() {
            1 => quote!(#runtime::Coupled::<#size>::of::<T>(|__lane| &__lanes[__lane][#number])),
            inputs => {
                let inputs = literal::index(inputs);
                quote!(#runtime::CoupledGrid::<#inputs, #size>::of::<T>(|__lane| &__lanes[__lane][#number]))
            }
        }
    });
    let all: Vec<usize> = (0..outline.inputs.len()).collect();
    let groups: Vec<usize> = (0..outline.starts.len()).collect();
    let together = extend(outline, &quote!(__starts), &all, &groups);
    let inputs = literal::index(outline.inputs.len());
    let width = literal::index(Places::new(outline, &all, &groups).width());
    let functions = outline.functions.iter().map(|function| {
        let body = extend(
            outline,
            &quote!(self.__starts),
            &function.positions,
            &function.states,
        );
        let name = extend_name(function);
        let [before, after] =
            [function.positions.len(), function.places(outline).width()].map(literal::index);
        let everywhere = &attribute::split(function.attributes).everywhere;
        quote! {
            #(#everywhere)*
            #[inline(always)]
            fn #name(&self, __x: [T; #before]) -> [T; #after] { #body }
        }
    });
    let allow = attribute::allow();
    quote! {
        #allow
        impl<T: #runtime::Scalar> #assembly<T> {
            fn __starts(__lanes: &[[#runtime::Start; #count]]) -> #starts { (#(#made,)*) }

            #[inline(always)]
            fn __extend(__starts: &#starts, __x: [T; #inputs]) -> [T; #width] { #together }

            #(#functions)*
        }
    }
}

/// The method that adds the states of the groups that a function uses to its arguments.
pub(super) fn extend_name(function: &Function) -> Ident {
    format_ident!("__extend_{}", function.name)
}

/// `__x` followed by the states of groups; `inputs` are the inputs in `__x`.
fn extend(
    outline: &Outline,
    starts: &TokenStream,
    inputs: &[usize],
    groups: &[usize],
) -> TokenStream {
    let own = (0..inputs.len()).map(|k| {
        let k = literal::index(k);
        quote!(__x[#k])
    });
    let mut looked_up = TokenStream::new();
    let mut numbers: Vec<TokenStream> = own.collect();
    for &group in groups {
        let Start { inputs: of, size } = &outline.starts[group];
        let name = format_ident!("__state{group}");
        let number = literal::index(group);
        let at: Vec<TokenStream> = of
            .iter()
            .map(|input| {
                let place = inputs.iter().position(|i| i == input);
                let place = literal::index(place.expect("a function has the inputs of its groups"));
                quote!(__x[#place])
            })
            .collect();
        let at = match &at[..] {
            [one] => one.clone(),
            several => quote!([#(#several),*]),
        };
        looked_up.extend(quote!(let #name = #starts.#number.at::<T>(#at);));
        numbers.extend((0..*size).map(|k| {
            let k = literal::index(k);
            quote!(#name.0[#k])
        }));
        numbers.push(quote!(#name.1));
    }
    quote!(#looked_up [#(#numbers),*])
}

/// The programs of all groups as functions of the plumbing's arguments.
fn programs(outline: &Outline, facts: &Facts, lowered: &Lowered) -> TokenStream {
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
    } = Types::new(outline, facts, lowered);
    let places = Places::all(outline);
    let program = |kind: &str, number: usize, program: &Program| {
        let method = format_ident!("__{kind}{number}");
        let statements = body::statements(program, &loader(outline, &places));
        let outputs = body::outputs(program);
        let count = literal::index(program.outputs.len());
        quote! {
            fn #method<const __FUSED: ::core::primitive::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> [T; #count] { #statements #outputs }
        }
    };
    let methods = lowered.coupled.iter().enumerate().map(|(number, group)| {
        let system = program("system", number, &group.system);
        let correct = program("correct", number, &group.correct);
        let placed = program("placed", number, &group.placed);
        quote!(#system #correct #placed)
    });
    let allow = attribute::allow();
    quote! {
        #allow
        impl<T: #runtime::Scalar> #assembly<T> { #(#methods)* }
    }
}

/// The groups on plain numbers, as the runtime prepares them.
fn preparing(
    outline: &Outline,
    mechanism: &Mechanism,
    facts: &Facts,
    lowered: &Lowered,
) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types { modes, .. } = Types::new(outline, facts, lowered);
    let float = quote!(::core::primitive::f64);
    let prepared = prepared_of(outline, &float);
    let starts = starts_type(outline);
    let coupled = format_ident!("__{}Coupled", outline.name);
    let inputs = literal::index(outline.inputs.len());
    let width = literal::index(Places::all(outline).width());
    let count = literal::index(outline.starts.len());
    let arms = |arm: &dyn Fn(usize, &Coupled) -> TokenStream| -> TokenStream {
        let last = lowered.coupled.len() - 1;
        let arms = lowered.coupled.iter().enumerate().map(|(number, group)| {
            let pattern = match number == last {
                true => quote!(_),
                false => {
                    let number = literal::index(number);
                    quote!(#number)
                }
            };
            let arm = arm(number, group);
            quote!(#pattern => { #arm })
        });
        quote!(match self.__number { #(#arms)* })
    };
    let place = arms(&|_, group| {
        let inputs = group.inputs.iter().enumerate().map(|(k, &input)| {
            let [k, input] = [k, input].map(literal::index);
            quote!(self.__at[#input] = __own[#k];)
        });
        quote!(#(#inputs)*)
    });
    let call = |kind: &str, number: usize| {
        let method = format_ident!("__{kind}{number}");
        quote! {
            #assembly::<#float>::#method::<{ #runtime::FUSED }>(
                &self.__m, &self.__modes, &self.__prepared, __x,
            )
        }
    };
    let with_state = |number: usize| {
        let first = literal::index(Places::all(outline).state(number, 0));
        quote! {
            let mut __x = self.__place(__own);
            #runtime::put_state(&mut __x, #first, __state);
        }
    };
    let correct = arms(&|number, _| {
        let (with_state, call) = (with_state(number), call("correct", number));
        quote!(#with_state #runtime::stepped(__state, &#call))
    });
    let system = arms(&|number, _| {
        let call = call("system", number);
        quote!(let __x = self.__place(__own); #runtime::pairs(&#call))
    });
    let placed = arms(&|number, group| {
        let (with_state, call) = (with_state(number), call("placed", number));
        let angles = group.unknowns.iter().map(|unknown| unknown.angle);
        let reach = literal::float(group.reach);
        quote!(#with_state #runtime::placed(&[#(#angles),*], #reach, &#call))
    });
    let groups = lowered
        .coupled
        .iter()
        .map(|g| group(outline, mechanism, facts, g));
    let turns = turns(outline, lowered);
    let allow = attribute::allow();
    quote! {
        #allow
        #[derive(::core::clone::Clone)]
        struct #coupled {
            __number: ::core::primitive::usize,
            __m: #name<#float>,
            __modes: #modes,
            __prepared: #prepared,
            __starts: #starts,
            __at: [#float; #inputs],
        }
        #allow
        impl #coupled {
            fn __place(&mut self, __own: &[#float]) -> [#float; #width] {
                #place
                #assembly::<#float>::__extend(&self.__starts, self.__at)
            }
        }
        #allow
        impl #runtime::Correction for #coupled {
            fn correct(&mut self, __own: &[#float], __state: &mut [#float]) -> #runtime::Step { #correct }
        }
        #allow
        impl #runtime::CoupledPrograms for #coupled {
            fn system(&mut self, __own: &[#float]) -> #runtime::Vec<[#float; 2]> { #system }
            fn placed(&mut self, __own: &[#float], __state: &[#float]) -> #runtime::Vec<[#float; 2]> { #placed }
        }
        #allow
        impl #assembly<#float> {
            const __GROUPS: [#runtime::CoupledGroup; #count] = [#(#groups),*];

            /// Group `__number` with what is prepared of those before it.
            fn __coupled(
                __m: &#name<#float>,
                __modes: &#modes,
                __at: [#float; #inputs],
                __number: ::core::primitive::usize,
                __prepared_starts: &[#runtime::Start; #count],
            ) -> ::core::result::Result<#coupled, #runtime::AssemblyError> {
                let __starts = Self::__starts(::core::slice::from_ref(__prepared_starts));
                #turns
                let __prepared = <#assembly<#float>>::__prepare::<{ #runtime::FUSED }>(__m, __modes, &__turns);
                ::core::result::Result::Ok(#coupled {
                    __number, __m: *__m, __modes: *__modes, __prepared, __starts, __at,
                })
            }
        }
    }
}

/// The turns of angles on which a coupled group depends, found with what is prepared before it.
fn turns(outline: &Outline, lowered: &Lowered) -> TokenStream {
    let runtime = &outline.runtime;
    let title = outline.title();
    if lowered.coupled.iter().all(|group| group.turning == 0) {
        let estimates = lowered
            .continuous_angles
            .iter()
            .map(|angle| literal::float(angle.estimate));
        return quote!(let __turns = #runtime::Turns::at_estimates([#(#estimates),*]););
    }
    let counts = lowered
        .coupled
        .iter()
        .map(|group| literal::index(group.turning));
    quote! {
        let __count = [#(#counts),*][__number];
        let __turns = Self::__wind(__m, __modes, &__starts, __at, __count).map_err(|__unknown| {
            #runtime::AssemblyError::NoWinding { mechanism: #title, unknown: __unknown }
        })?;
    }
}

/// The prepared slots as plain numbers.
fn prepared_of(outline: &Outline, float: &TokenStream) -> TokenStream {
    let count = literal::index(outline.prepared);
    quote!([#float; #count])
}

/// The runtime's description of a group.
fn group(outline: &Outline, mechanism: &Mechanism, facts: &Facts, group: &Coupled) -> TokenStream {
    let runtime = &outline.runtime;
    let title = outline.title();
    let own = &facts.groups[group.group];
    let index = literal::index(group.group);
    let kind = &own.kind;
    let loops = own.loops.iter().map(|n| literal::index(*n));
    let names = &own.unknowns;
    let unknowns = group.unknowns.iter().map(|placed| {
        let unknown = &mechanism.unknowns[placed.unknown];
        let name = match placed.component {
            None => unknown.name.clone(),
            Some(k) => format!("{}.{}", unknown.name, crate::algebra::AXES[k]),
        };
        let estimate = literal::float(placed.estimate);
        let scale = literal::float(if placed.angle { 1.0 } else { facts.longest });
        let unit = match placed.angle {
            true => String::new(),
            false => unknown
                .ty
                .dimension()
                .map_or_else(String::new, |d| d.unit(mechanism.unit)),
        };
        let angle = placed.angle;
        quote! {
            #runtime::CoupledUnknown { name: #name, estimate: #estimate, scale: #scale, unit: #unit, angle: #angle }
        }
    });
    let variables = group.variables.iter().map(|variable| match variable {
        Variable::Unit => quote!(#runtime::Variable::Unit),
        Variable::Length => quote!(#runtime::Variable::Length),
        Variable::Point => quote!(#runtime::Variable::Point),
        Variable::Conjugate => quote!(#runtime::Variable::Conjugate),
    });
    let terms = group.terms.iter().map(|(equation, exponents)| {
        let equation = literal::index(*equation);
        let exponents = exponents
            .iter()
            .map(|&e| proc_macro2::Literal::i8_unsuffixed(e));
        quote!(#runtime::Term { equation: #equation, exponents: &[#(#exponents),*] })
    });
    let inputs = group.inputs.iter().map(|&input| {
        let item = &mechanism.inputs[input];
        let (name, unit) = (&item.name, item.dimension.unit(mechanism.unit));
        let angle = item.dimension.half_lengths == 0;
        let index = literal::index(input);
        let facts = &facts.inputs[input];
        let (low, high) = facts.followed;
        let (low, high) = (literal::float(low), literal::float(high));
        let declared = facts.range.is_some();
        quote! {
            #runtime::CoupledInput {
                name: #name, unit: #unit, index: #index, declared: #declared,
                range: #runtime::Range { low: #low, high: #high, turn: #angle },
            }
        }
    });
    quote! {
        #runtime::CoupledGroup {
            mechanism: #title,
            group: #index,
            kind: #kind,
            loops: &[#(#loops),*],
            names: &[#(#names),*],
            unknowns: &[#(#unknowns),*],
            variables: &[#(#variables),*],
            terms: &[#(#terms),*],
            inputs: &[#(#inputs),*],
        }
    }
}

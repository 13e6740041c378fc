//! The mechanism as the runtime searches its assemblies, group by group: the traits `Grouped` and
//! `PlainGroups`.

use linkage_core::range_check::Slack;
use linkage_core::{Cycle, Level};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::array_types::{Types, start_type};
use super::body::Runs;
use super::load::{Places, loader};
use super::outline::Outline;
use super::{body, code, literal};
use linkage_compiler::ir::CompiledMechanism;

/// Both traits.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let name = code::text(outline.name);
    let Types {
        arguments,
        starts: states,
        ..
    } = Types::new(outline);
    let places = Places::all(outline);
    let coupled = !outline.starts.is_empty();
    let (count, numbers) = (outline.starts.len(), unit.survey.outputs.len());
    let data = data(outline, unit);
    let starts = outline.starts.iter().enumerate().map(|(number, start)| {
        let ty = code::text(&start_type(outline, start));
        format!("<{ty}>::of::<T>(|__lane| &__lanes[__lane][{number}]),")
    });
    let starts: String = starts.collect();
    let survey = survey(outline, unit, &places);
    let state = outline.starts.iter().enumerate().map(|(number, start)| {
        let first = places.state(number, 0);
        format!("{number} => &mut __x[{first}..{}],", first + start.size)
    });
    let state_mut = match coupled {
        true => format!(
            "fn state_mut(__x: &mut {arguments}, __number: __p::usize) -> &mut [T] {{
                match __number {{ {} _ => &mut [] }}
            }}",
            state.collect::<String>()
        ),
        false => String::new(),
    };
    let plain = plain(outline, unit);
    let grouped = code::tokens(&format!(
        "impl<T: __p::Scalar> __p::Grouped for {name}<T> {{
            const COUPLED: __p::bool = {coupled};
            type Lane = [__p::Start; {count}];
            type Survey = [T; {numbers}];

            fn group_data(&self) -> &'static __p::GroupData {{ const {{ &{data} }} }}

            fn states(&self, __lanes: &[[__p::Start; {count}]]) -> {states} {{ ({starts}) }}

            fn survey<const __SLACKS: __p::bool>(
                __core: &__p::CoreOf<Self>,
                __x: {arguments},
            ) -> [T; {numbers}] {{
                const __FUSED: __p::bool = __p::FUSED;
                let (__m, __modes, __prepared) = __core.loaded();
                {survey}
            }}
            {state_mut}
        }}"
    ));
    quote!(__p::if_alloc! { #grouped #plain })
}

/// The body of the survey, which ends after the slacks if only they are asked for.
fn survey(outline: &Outline, unit: &CompiledMechanism, places: &Places) -> String {
    let slacks = 1..=unit.groups.len();
    let (survey, count) = unit.survey.beginning_with(slacks.clone());
    let load = loader(outline, places);
    let [first, rest] = body::parts(&survey, Runs::Once, &load, count);
    let slacks = body::array(&survey.outputs[slacks]);
    let outputs = body::outputs(&survey);
    format!("{first} if __SLACKS {{ return __p::slacks({slacks}); }} {rest} {outputs}")
}

/// The runtime's `GroupData`.
fn data(outline: &Outline, unit: &CompiledMechanism) -> String {
    let levels = unit.levels().into_iter().map(|level| match level {
        Level::Modes(mode) => format!("__p::Level::Modes({mode}),"),
        Level::Coupled(number) => format!("__p::Level::Coupled({number}),"),
        Level::Single => "__p::Level::Single,".to_owned(),
    });
    let slacks = unit.groups.iter().map(|group| match group.slack {
        Slack::Number => "__p::Slack::Number,",
        Slack::Relative => "__p::Slack::Relative,",
        Slack::Signed => "__p::Slack::Signed,",
        Slack::Prepared => "__p::Slack::Prepared,",
    });
    let groups = match outline.starts.is_empty() {
        true => "&[]".to_owned(),
        false => format!("&{}::<__p::f64>::__GROUPS", outline.assembly),
    };
    let surveying = unit.surveying;
    let unknowns = unit.surveyed.iter().map(|surveyed| {
        let unknown = &unit.unknowns[surveyed.unknown];
        let name = &unknown.name;
        let angle = surveyed.angle;
        let unit = match angle {
            true => "",
            false => &unknown.unit,
        };
        format!(
            "__p::surveyed({name:?}, {unit:?}, {angle}, {}),",
            surveyed.numbers
        )
    });
    let repeats = unit.repeats();
    let cycle = match &unit.inputs[..] {
        [input] => {
            let Cycle {
                low,
                high,
                angle,
                samples,
            } = input.cycle();
            let [low, high] = [low, high].map(literal::float_text);
            format!(
                "__p::Some(__p::Cycle {{ low: {low}, high: {high}, angle: {angle}, samples: {samples} }})"
            )
        }
        _ => "__p::None".to_owned(),
    };
    let levels: String = levels.collect();
    let (slacks, unknowns) = (slacks.collect::<String>(), unknowns.collect::<String>());
    format!(
        "__p::GroupData {{
            levels: &[{levels}],
            slacks: &[{slacks}],
            coupled: {groups},
            surveying: {surveying},
            unknowns: &[{unknowns}],
            repeats: {repeats},
            cycle: {cycle},
        }}"
    )
}

/// The programs of the coupled groups on plain numbers, and bounds of surveys.
fn plain(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let assembly = &outline.assembly;
    let float = quote!(__p::f64);
    let width = literal::index(Places::all(outline).width());
    let mut arms = TokenStream::new();
    for (number, group) in unit.coupled.iter().enumerate() {
        let others: &[(&str, &str)] = match group.followed {
            true => &[("Estimate", "estimate"), ("Missed", "missed")],
            false => &[("System", "system")],
        };
        let programs = [("Correct", "correct"), ("Placed", "placed")];
        for (program, method) in programs.iter().chain(others) {
            let program = format_ident!("{program}");
            let method = format_ident!("__{method}{number}");
            let number = literal::index(number);
            arms.extend(quote! {
                (#number, #runtime::GroupProgram::#program) => __read(
                    &#assembly::<#float>::#method::<{ #runtime::FUSED }>(__m, __modes, __prepared, __x),
                ),
            });
        }
    }
    let run = (!unit.coupled.is_empty()).then(|| {
        quote! {
            #[inline]
            fn run<__R>(
                __core: &#runtime::CoreOf<Self>,
                __number: __p::usize,
                __program: #runtime::GroupProgram,
                __x: [#float; #width],
                __read: impl #runtime::FnOnce(&[#float]) -> __R,
            ) -> __R {
                let (__m, __modes, __prepared) = __core.loaded();
                match (__number, __program) { #arms _ => __read(&[]) }
            }
        }
    });
    let residuals = residuals(outline, unit);
    let one_input = unit.inputs.len() == 1 && !unit.groups.is_empty();
    let bounds = one_input.then(|| {
        quote! {
            #[inline]
            fn bounds(
                __data: &#runtime::DataOf<Self>,
                __group: __p::usize,
            ) -> __p::Option<#runtime::Bounds<'static>> {
                let __m = &#runtime::Sealed::core(__data).dimensions;
                __p::Some(#runtime::bounds(__m.cast::<#runtime::Enclosure>(), __data, __group))
            }
        }
    });
    quote! {
        impl #runtime::PlainGroups for #name<#float> {
            #run
            #residuals
            #bounds
        }
    }
}

/// The residuals of groups that are followed from their estimates.
fn residuals(outline: &Outline, unit: &CompiledMechanism) -> Option<TokenStream> {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let enclosure = quote!(#runtime::Enclosure);
    let cast = quote!(<#enclosure as #runtime::Scalar>::from_f64);
    let width = literal::index(Places::all(outline).width());
    let groups = unit.coupled.iter().enumerate();
    let followed = groups.filter(|(_, group)| group.followed);
    let arms: Vec<_> = followed
        .map(|(number, _)| {
            let method = format_ident!("__residuals{number}");
            let number = literal::index(number);
            quote! {
                #number => <#runtime::Vec<_> as ::core::convert::From<[_; _]>>::from(
                    #assembly::<#enclosure>::#method::<{ #runtime::FUSED }>(
                        &__m.cast(), __modes, &__prepared.map(#cast), __x,
                    ),
                ),
            }
        })
        .collect();
    if arms.is_empty() {
        return None;
    }
    let float = quote!(__p::f64);
    let name = outline.name;
    Some(quote! {
        #[inline]
        fn residuals(
            __core: &#runtime::CoreOf<Self>,
            __number: __p::usize,
            __x: [#float; #width],
            __state: &[#enclosure],
        ) -> #runtime::Vec<#enclosure> {
            let (__m, __modes, __prepared) = __core.loaded();
            let mut __x = __x.map(#cast);
            let __state_numbers = <#name<#enclosure> as #runtime::Grouped>::state_mut(&mut __x, __number);
            __state_numbers[..__state.len()].copy_from_slice(__state);
            match __number { #(#arms)* _ => #runtime::Vec::new() }
        }
    })
}

//! The mechanism as the runtime assembles it: the trait `Compiled`.

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;

use super::array_types::Types;
use super::body::Runs;
use super::load::{Places, loader};
use super::outline::Outline;
use super::{body, code, literal};
use linkage_compiler::ir::{CompiledMechanism, ContinuousAngle};

/// The trait.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let name = code::text(outline.name);
    let assembly = code::text(&outline.assembly);
    let Types {
        modes,
        inputs,
        centres,
        windings,
        prepared,
        arguments,
        starts,
    } = Types::new(outline);
    let description = description(outline, unit);
    let all = match outline.starts.is_empty() {
        true => "*__inputs".to_owned(),
        false => format!("{assembly}::<T>::__extend(__states, *__inputs)"),
    };
    let prepare = program(outline, &unit.prepare, put_prepared);
    let [gaps, directions, bearings] = [
        program(outline, &unit.gaps, body::outputs),
        program(outline, &unit.directions, body::pairs),
        program(outline, &unit.bearings, body::pairs),
    ];
    let by_build = "const __FUSED: __p::bool = __p::FUSED; let __m = self;";
    code::tokens(&format!(
        "impl<T: __p::Scalar> __p::Compiled for {name}<T> {{
            type Scalar = T;
            type Plain = {name}<__p::f64>;
            type Assembly = {assembly}<T>;
            type Modes = {modes};
            type Inputs = {inputs};
            type Centres = {centres};
            type Windings = {windings};
            type Prepared = {prepared};
            type States = {starts};
            type Arguments = {arguments};

            fn description(&self) -> &'static __p::Description {{ const {{ &{description} }} }}

            fn assembly(__sealed: __p::DataOf<Self>) -> {assembly}<T> {{ {assembly} {{ __sealed }} }}

            #[inline(always)]
            fn data(__assembly: &{assembly}<T>) -> &__p::DataOf<Self> {{ &__assembly.__sealed }}

            #[inline(always)]
            fn dimensions(&self) -> impl __p::AsRef<[T]> {{ __values(self) }}

            #[inline(always)]
            fn with_dimensions(&self, __dimension: impl __p::Fn(__p::usize) -> T) -> Self {{
                __of(__dimension)
            }}

            fn plain(&self, __dimension: impl __p::Fn(__p::usize) -> __p::f64) -> Self::Plain {{
                __of(__dimension)
            }}

            #[inline(always)]
            fn arguments(&self, __states: &{starts}, __inputs: &{inputs}) -> {arguments} {{ {all} }}

            #[inline(always)]
            fn prepare<const __FUSED: __p::bool>(
                &self,
                __modes: &{modes},
                __turns: &__p::RevolutionsOf<Self>,
                __slots: &mut impl __p::RowNumbersMut<T>,
            ) {{ let __m = self; {prepare} }}

            fn gaps(&self, __modes: &{modes}, __prepared: &{prepared}, __x: {arguments}) -> impl __p::AsRef<[T]> {{
                {by_build} {gaps}
            }}

            fn directions(
                &self,
                __modes: &{modes},
                __prepared: &{prepared},
                __x: {arguments},
            ) -> impl __p::AsRef<[[T; 2]]> {{
                {by_build} {directions}
            }}

            fn bearings(&self, __modes: &{modes}) -> impl __p::AsRef<[[T; 2]]> {{ {by_build} {bearings} }}
        }}"
    ))
}

/// Puts the outputs of the program that prepares an assembly into the slots of these numbers.
fn put_prepared(prepare: &Program) -> String {
    put(prepare, 0..prepare.outputs.len())
}

/// Puts outputs into the slots of these numbers.
pub(super) fn put(program: &Program, slots: impl IntoIterator<Item = usize>) -> String {
    let values = slots.into_iter().zip(program.outputs.iter().copied());
    body::puts("__slots.put", values)
}

/// A program over all inputs and states of the mechanism, ending in its outputs.
pub(super) fn program(
    outline: &Outline,
    program: &Program,
    outputs: fn(&Program) -> String,
) -> String {
    let places = Places::all(outline);
    let statements = body::statements(program, Runs::Once, &loader(outline, &places));
    statements + &outputs(program)
}

/// The literal of the runtime's `Description`.
fn description(outline: &Outline, unit: &CompiledMechanism) -> String {
    let title = outline.title();
    let name = code::text(outline.name);
    let needed = unit.groups.iter().flat_map(|group| &group.parameters);
    let needed: Vec<usize> = needed.copied().collect();
    let units: Vec<&String> = unit.groups.iter().map(|group| &group.gap_unit).collect();
    let prepared = outline.prepared;
    let modes = code::text(&outline.default_modes());
    let angles: String = unit.angles.iter().map(|one| angle(unit, one)).collect();
    format!(
        "__p::Description {{
            name: {title:?},
            inputs: {name}::<__p::f64>::INPUTS,
            parameters: {name}::<__p::f64>::PARAMETERS,
            groups: {name}::<__p::f64>::STRUCTURE.groups,
            needed: &{needed:?},
            gap_units: &{units:?},
            prepared: {prepared},
            modes: &{modes},
            angles: &[{angles}],
        }}"
    )
}

/// The runtime's `Angle`: which angle, and along which inputs it is followed.
fn angle(unit: &CompiledMechanism, angle: &ContinuousAngle) -> String {
    let unknown = &unit.unknowns[angle.unknown].name;
    let estimate = literal::float_text(angle.estimate);
    let along = angle.inputs.iter().map(|&input| {
        let described = &unit.inputs[input];
        let (low, high) = described.followed;
        let [low, high] = [low, high].map(literal::float_text);
        let rates = floats(&described.rates);
        format!("__p::Along {{ input: {input}, low: {low}, high: {high}, rates: &{rates} }},")
    });
    let phases = angle.phases.iter().map(|phase| match &phase.turns {
        Some(turns) => format!("__p::Some(&{}),", floats(turns)),
        None => "__p::None,".to_owned(),
    });
    let (along, phases) = (along.collect::<String>(), phases.collect::<String>());
    format!(
        "__p::Angle {{ unknown: {unknown:?}, estimate: {estimate}, along: &[{along}], phases: &[{phases}] }},"
    )
}

/// Numbers as an array.
fn floats(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| literal::float_text(*x)).collect();
    format!("[{}]", numbers.join(","))
}

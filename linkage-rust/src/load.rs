//! The names in generated code of the numbers that a program loads. Every function that prints a
//! program binds some of the same names: `__m` the mechanism, `__modes`, `__turns` the centres and
//! windings of the continuous angles, `__prepared`, [`CARRIED`] with a number for each value from
//! the stage before, and `__x` the inputs followed by the prepared states of coupled groups.

use linkage_symbolic::program::{Instruction, Program, Source};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::array_fields::entry;
use super::literal;
use super::outline::{Function, Outline};

/// The values that a stage takes over from the one before, entry by entry.
pub(super) const CARRIED: &str = "__carried";

/// The values that a stage reads of `__x`, by their index there.
pub(super) const INPUT: &str = "__input";

/// The order of the numbers in `__x`.
#[derive(Clone, Debug)]
pub(super) struct Places {
    inputs: Vec<usize>,
    /// First place of each coupled group's state, if it is there.
    states: Vec<Option<usize>>,
    width: usize,
}

impl Places {
    /// The inputs `inputs`, then the states of the coupled groups `groups`, each with its least
    /// determinant.
    pub(super) fn new(outline: &Outline, inputs: &[usize], groups: &[usize]) -> Self {
        let mut places = Self {
            inputs: inputs.to_vec(),
            states: vec![None; outline.starts.len()],
            width: inputs.len(),
        };
        for &group in groups {
            places.states[group] = Some(places.width);
            places.width += outline.starts[group].size + 1;
        }
        places
    }

    /// The arguments of a function's programs.
    pub(super) fn of_function(outline: &Outline, function: &Function) -> Self {
        Self::new(outline, &function.positions, &function.states)
    }

    /// All inputs and all states.
    pub(super) fn all(outline: &Outline) -> Self {
        let inputs: Vec<usize> = (0..outline.inputs.len()).collect();
        let groups: Vec<usize> = (0..outline.starts.len()).collect();
        Self::new(outline, &inputs, &groups)
    }

    /// The count of numbers.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// The place of a component of a group's state.
    pub(super) fn state(&self, group: usize, component: usize) -> usize {
        self.states[group].expect("a program uses only its states") + component
    }

    /// The index of a number that a program loads, if the number is in `__x`.
    fn index_of(&self, source: Source) -> Option<usize> {
        match source {
            Source::Input(input) => {
                let position = self.inputs.iter().position(|i| *i == input);
                Some(position.expect("a program uses only its inputs"))
            }
            Source::State(group, component) => Some(self.state(group, component)),
            _ => None,
        }
    }

    /// The places that a program loads, in order.
    pub(super) fn read(&self, program: &Program) -> Vec<usize> {
        let loads = program
            .instructions
            .iter()
            .filter_map(|instruction| match instruction {
                Instruction::Load(source) => self.index_of(*source),
                _ => None,
            });
        let mut places: Vec<usize> = loads.collect();
        places.sort_unstable();
        places.dedup();
        places
    }
}

/// Prints loads, those of `__x` as entries of an array.
pub(super) fn loader<'a>(
    outline: &'a Outline,
    places: &'a Places,
) -> impl Fn(Source) -> TokenStream + 'a {
    loader_by(outline, places, |position| {
        let position = literal::index(position);
        quote!(__x[#position])
    })
}

/// Prints loads, those of `__x` by `at`.
pub(super) fn loader_by<'a>(
    outline: &'a Outline,
    places: &'a Places,
    at: impl Fn(usize) -> TokenStream + 'a,
) -> impl Fn(Source) -> TokenStream + 'a {
    let runtime = &outline.runtime;
    let fields = outline.scalar_fields();
    move |source| match source {
        Source::Parameter(index) => {
            let field = &fields[index];
            quote!(__m.#field)
        }
        Source::Input(_) | Source::State(..) => at(places
            .index_of(source)
            .expect("inputs and states stand there")),
        Source::Limit => quote!(T::from_f64(T::CORRECTION_LIMIT)),
        Source::Mode(mode) => {
            let mode = literal::index(mode);
            quote!(T::from_f64(#runtime::AssemblyMode::sign(__modes[#mode])))
        }
        Source::Centre(angle) => {
            let angle = literal::index(angle);
            quote!(__turns.centres[#angle])
        }
        Source::Winding(angle, input) => {
            let (angle, input) = (literal::index(angle), literal::index(input));
            quote!(__turns.windings[#angle][#input])
        }
        Source::Prepared(slot) => {
            let slot = literal::index(slot);
            quote!(__prepared[#slot])
        }
        Source::Carried(index) => entry(CARRIED, index).into_token_stream(),
    }
}

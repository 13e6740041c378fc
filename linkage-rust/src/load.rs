//! The names in generated code of the numbers that a program loads. Every function that prints a
//! program binds some of the same names: `__m` the mechanism, `__modes`, `__turns` the centres and
//! windings of the continuous angles, `__prepared`, and `__x` the inputs followed by the prepared
//! states of coupled groups. A stage has all of these in its `__core` and its `__row`.

use linkage_symbolic::program::Source;

use super::code::{self, put};
use super::outline::{Function, Outline};

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

    /// The index of an input in `__x`.
    fn input(&self, input: usize) -> usize {
        let position = self.inputs.iter().position(|i| *i == input);
        position.expect("a program uses only its inputs")
    }
}

/// Prints the loads of a program over arrays.
pub(super) fn loader<'a>(
    outline: &'a Outline,
    places: &'a Places,
) -> impl Fn(Source, &mut String) + 'a {
    let names = Names {
        mechanism: "__m",
        modes: "__modes",
        number: "__x",
        prepared: "__prepared",
        kept: "",
        brackets: ['[', ']'],
    };
    loader_by(outline, places, names, &[])
}

/// Prints the loads of a stage that takes over the kept numbers `taken`.
pub(super) fn stage_loader<'a>(
    outline: &'a Outline,
    places: &'a Places,
    taken: &'a [usize],
) -> impl Fn(Source, &mut String) + 'a {
    let names = Names {
        mechanism: "__core.dimensions",
        modes: "__core.modes",
        number: "__row.number",
        prepared: "__row.prepared",
        kept: "__row.kept",
        brackets: ['(', ')'],
    };
    loader_by(outline, places, names, taken)
}

/// The names of the numbers, those of lists without the index.
struct Names {
    mechanism: &'static str,
    modes: &'static str,
    /// Inputs and states.
    number: &'static str,
    prepared: &'static str,
    /// Numbers of earlier stages; a program that is no stage takes nothing over.
    kept: &'static str,
    /// Around the index.
    brackets: [char; 2],
}

impl Names {
    fn entry(&self, list: &str, index: usize, code: &mut String) {
        let [before, behind] = self.brackets;
        put(format_args!("{list}{before}{index}{behind}"), code);
    }
}

fn loader_by<'a>(
    outline: &'a Outline,
    places: &'a Places,
    names: Names,
    taken: &'a [usize],
) -> impl Fn(Source, &mut String) + 'a {
    let fields = outline.scalar_fields();
    let fields: Vec<String> = fields.iter().map(code::text).collect();
    move |source, code| match source {
        Source::Parameter(index) => {
            put(format_args!("{}.{}", names.mechanism, fields[index]), code);
        }
        Source::Input(input) => names.entry(names.number, places.input(input), code),
        Source::State(group, component) => {
            names.entry(names.number, places.state(group, component), code);
        }
        Source::Limit => code.push_str("T::from_f64(T::CORRECTION_LIMIT)"),
        Source::Mode(mode) => put(
            format_args!(
                "T::from_f64(__p::AssemblyMode::sign({}[{mode}]))",
                names.modes
            ),
            code,
        ),
        Source::Centre(angle) => put(format_args!("__turns.centres[{angle}]"), code),
        Source::Winding(angle, input) => {
            put(format_args!("__turns.windings[{angle}][{input}]"), code);
        }
        Source::Prepared(slot) => names.entry(names.prepared, slot, code),
        Source::Carried(index) => names.entry(names.kept, taken[index], code),
    }
}

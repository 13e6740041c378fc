//! The equation of motion of a mechanism, from a function that returns its accelerations.

use linkage_compiler::ir::Role;

use crate::compiled::Assembly;
use crate::error::NotDriven;
use crate::mechanism::Mechanism;

/// The equation of motion of a mechanism without drives: a function with the
/// `driven_acceleration` of each input, and its arguments at the start.
///
/// Loads keep the values of the start. [`accelerations`](Self::accelerations) is the closure that
/// an integrator needs, such as `linkage::dynamics::Problem`.
#[derive(Clone, Debug)]
pub struct Driven<'m> {
    mechanism: &'m Mechanism,
    function: usize,
    start: Vec<f64>,
    inputs: Vec<DrivenInput>,
}

/// An input that moves: where a function has its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DrivenInput {
    /// Index of its value among the arguments of the function.
    pub value: usize,
    /// Index of its speed among them.
    pub speed: usize,
    /// Index of its acceleration among them, if the function takes that.
    pub acceleration: Option<usize>,
    /// Index of the column with its `driven_acceleration`.
    pub column: usize,
}

/// Returns the first function with the `driven_acceleration` of all inputs.
pub(crate) fn driven_function(mechanism: &Mechanism) -> Option<usize> {
    let mut functions = 0..mechanism.headings().len();
    functions.find(|&function| acceleration_columns(mechanism, function).is_some())
}

/// Indices of an input, its speed and its acceleration among the arguments of a function.
struct MovingArguments {
    value: usize,
    speed: usize,
    acceleration: Option<usize>,
}

/// Returns the columns of a function with the accelerations of all inputs, in the order of the
/// inputs.
fn acceleration_columns(mechanism: &Mechanism, function: usize) -> Option<Vec<usize>> {
    let fields = &mechanism.compiled().functions[function].fields;
    let mut first = 0;
    let mut columns = vec![None; mechanism.inputs().len()];
    for field in fields {
        if let Some(input) = field.driven_acceleration {
            columns[input].get_or_insert(first);
        }
        first += field.shape.width();
    }
    let columns: Option<Vec<usize>> = columns.into_iter().collect();
    columns.filter(|columns| !columns.is_empty())
}

/// Returns the index of an argument of this role among the arguments of all functions.
fn argument_of(mechanism: &Mechanism, role: Role) -> Option<usize> {
    let mut arguments = mechanism.compiled().arguments.iter();
    let index = arguments.position(|argument| argument.role == role)?;
    Some(mechanism.inputs().len() + index)
}

/// Returns the name of the speed of an input, or a common one without it.
fn speed_name(mechanism: &Mechanism, input: usize) -> String {
    let speed = argument_of(mechanism, Role::Speed(input));
    let name = speed.map_or("omega", |index| mechanism.argument(index).0);
    name.to_owned()
}

fn moving_arguments(
    mechanism: &Mechanism,
    function: usize,
    input: usize,
) -> Result<MovingArguments, NotDriven> {
    let listed = &mechanism.compiled().functions[function].arguments;
    let at = |wanted: usize| listed.iter().position(|&argument| argument == wanted);
    let of_role = |role: Role| argument_of(mechanism, role).and_then(at);
    let function = mechanism.headings()[function].function;
    let name = mechanism.inputs()[input].name;
    let Some(value) = at(input) else {
        return Err(NotDriven::Input {
            function,
            input: name,
            speed: speed_name(mechanism, input),
        });
    };
    let Some(speed) = of_role(Role::Speed(input)) else {
        return Err(NotDriven::Speed {
            function,
            input: name,
            speed: speed_name(mechanism, input),
        });
    };
    Ok(MovingArguments {
        value,
        speed,
        acceleration: of_role(Role::Acceleration(input)),
    })
}

impl<'m> Driven<'m> {
    /// Resolves a function and its arguments at the start.
    pub(crate) fn new(
        mechanism: &'m Mechanism,
        function: usize,
        start: &[f64],
    ) -> Result<Self, NotDriven> {
        let heading = mechanism.headings()[function];
        assert_eq!(start.len(), heading.arguments.len(), "its arguments");
        let Some(first) = mechanism.inputs().first() else {
            return Err(NotDriven::NoInput {
                mechanism: mechanism.name(),
            });
        };
        let inputs = 0..mechanism.inputs().len();
        let arguments = inputs.map(|input| moving_arguments(mechanism, function, input));
        let arguments: Vec<MovingArguments> = arguments.collect::<Result<_, _>>()?;
        let Some(columns) = acceleration_columns(mechanism, function) else {
            return Err(NotDriven::Accelerations {
                function: heading.function,
                input: first.name,
                speed: speed_name(mechanism, 0),
            });
        };
        let inputs = arguments.into_iter().zip(columns);
        let inputs = inputs.map(|(arguments, column)| DrivenInput {
            value: arguments.value,
            speed: arguments.speed,
            acceleration: arguments.acceleration,
            column,
        });
        Ok(Self {
            mechanism,
            function,
            start: start.to_vec(),
            inputs: inputs.collect(),
        })
    }

    /// Returns the mechanism.
    #[must_use]
    pub const fn mechanism(&self) -> &'m Mechanism {
        self.mechanism
    }

    /// Returns the number of the function.
    #[must_use]
    pub const fn function(&self) -> usize {
        self.function
    }

    /// Returns all inputs, in the order of the mechanism.
    #[must_use]
    pub fn inputs(&self) -> &[DrivenInput] {
        &self.inputs
    }

    /// Returns the arguments of the function at the start.
    #[must_use]
    pub fn start_arguments(&self) -> &[f64] {
        &self.start
    }

    /// Returns inputs and speeds at the start.
    ///
    /// # Panics
    ///
    /// If the mechanism has fewer than `N` inputs.
    #[must_use]
    pub fn start<const N: usize>(&self) -> [[f64; N]; 2] {
        [
            std::array::from_fn(|k| self.start[self.inputs[k].value]),
            std::array::from_fn(|k| self.start[self.inputs[k].speed]),
        ]
    }

    /// Returns names and units of all inputs, then of all speeds.
    #[must_use]
    pub fn titles(&self) -> Vec<(&'m str, &'m str)> {
        let arguments = &self.mechanism.compiled().functions[self.function].arguments;
        let values = self.inputs.iter().map(|input| input.value);
        let speeds = self.inputs.iter().map(|input| input.speed);
        let all = values.chain(speeds);
        all.map(|index| self.mechanism.argument(arguments[index]))
            .collect()
    }

    /// Returns the accelerations of all inputs. They are NaN where the loops do not close, even if
    /// accelerations do not depend on these loops.
    ///
    /// # Panics
    ///
    /// If the mechanism has another number of inputs.
    #[must_use]
    pub fn accelerations<const N: usize>(
        &self,
        assembly: &Assembly<'_>,
        inputs: [f64; N],
        speeds: [f64; N],
    ) -> [f64; N] {
        if assembly.gaps(&inputs).iter().any(|gap| *gap > 0.0) {
            return [f64::NAN; N];
        }
        let results = assembly.call(self.function, &self.arguments(inputs, speeds));
        std::array::from_fn(|input| results[self.inputs[input].column])
    }

    /// Returns all results of the function at a state. If the function takes accelerations, these
    /// are those of the state.
    ///
    /// # Panics
    ///
    /// If the mechanism has another number of inputs.
    #[must_use]
    pub fn results<const N: usize>(
        &self,
        assembly: &Assembly<'_>,
        inputs: [f64; N],
        speeds: [f64; N],
    ) -> Vec<f64> {
        let mut arguments = self.arguments(inputs, speeds);
        let results = assembly.call(self.function, &arguments);
        let mut is_taken = false;
        for input in &self.inputs {
            if let Some(argument) = input.acceleration {
                arguments[argument] = results[input.column];
                is_taken = true;
            }
        }
        match is_taken {
            true => assembly.call(self.function, &arguments),
            false => results,
        }
    }

    /// Returns the arguments of the function at a state, with accelerations of the start.
    fn arguments<const N: usize>(&self, inputs: [f64; N], speeds: [f64; N]) -> Vec<f64> {
        let mut arguments = self.start.clone();
        for (k, input) in self.inputs.iter().enumerate() {
            arguments[input.value] = inputs[k];
            arguments[input.speed] = speeds[k];
        }
        arguments
    }
}

//! Functions that the page of a motion needs and its text does not have: those for the check of the
//! energy and for the drawing.

use linkage_compiler::ir::Role;
use linkage_engine::{Assembly, Driven, Mechanism, Source};

use crate::derived_functions::{Missing, free, selections, with_further_functions};

/// A mechanism with the functions of its page of a motion.
#[derive(Clone, Debug)]
pub struct MotionFunctions {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// The functions of the energy; `None` if the compiler refuses them.
    pub energy: Option<EnergyFunctions>,
}

/// Names of the functions with which a page checks the energy of a motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EnergyFunctions {
    /// Returns the generalised forces of all inputs, the derivatives of the potential energy with
    /// respect to them, the kinetic and the potential energy.
    pub loads: String,
    /// Returns the drives of all inputs that hold the weights at rest.
    pub weights: String,
}

impl EnergyFunctions {
    /// Returns the power of all loads without a potential at a state: that of all loads and weights,
    /// less the decrease of the potential energy.
    ///
    /// # Panics
    ///
    /// If the mechanism of `driven` lacks one of the functions.
    #[must_use]
    pub fn power(
        &self,
        driven: &Driven<'_>,
        assembly: &Assembly<'_>,
        inputs: &[f64],
        speeds: &[f64],
    ) -> f64 {
        let called = |name: &str| {
            let function = driven.mechanism().function(name);
            let function = function.unwrap_or_else(|error| panic!("{error}"));
            let arguments = state_arguments(driven, function, inputs, speeds);
            assembly.call(function, &arguments)
        };
        let (loads, weights) = (called(&self.loads), called(&self.weights));
        let (forces, slopes) = loads.split_at(speeds.len());
        let rates = speeds.iter().zip(forces).zip(slopes).zip(&weights);
        rates
            .map(|(((speed, force), slope), held)| speed * (force + slope - held))
            .sum()
    }
}

/// The arguments of a further function at a state.
fn state_arguments(
    driven: &Driven<'_>,
    function: usize,
    inputs: &[f64],
    speeds: &[f64],
) -> Vec<f64> {
    let mut known = driven.start_arguments().to_vec();
    for (k, input) in driven.inputs().iter().enumerate() {
        known[input.value] = inputs[k];
        known[input.speed] = speeds[k];
    }
    let headings = driven.mechanism().headings();
    let names = headings[driven.function()].arguments;
    let taken = headings[function].arguments.iter();
    taken
        .filter_map(|name| Some(known[names.iter().position(|other| other == name)?]))
        .collect()
}

/// Returns a mechanism of a text with further functions: those for the check of the energy along
/// the motion of `driven`, and a drawing if there is none.
#[must_use]
pub fn with_motion_functions(source: &Source, driven: &Driven<'_>) -> MotionFunctions {
    let mechanism = driven.mechanism();
    let drawings = drawings(mechanism);
    let compiled = |functions: &str| match functions {
        "" => None,
        functions => with_further_functions(source, mechanism.name(), functions),
    };
    for force in FORCES {
        let (functions, names) = energy_functions(driven, force);
        for drawing in &drawings {
            if let Some(mechanism) = compiled(&format!("{functions}{drawing}")) {
                return MotionFunctions {
                    mechanism,
                    energy: Some(names),
                };
            }
        }
    }
    let others = drawings.iter().find_map(|drawing| compiled(drawing));
    MotionFunctions {
        mechanism: others.unwrap_or_else(|| mechanism.clone()),
        energy: None,
    }
}

/// The generalised force of an input. In a mechanism without loads it is zero, and has no quantity.
const FORCES: [fn(&str) -> String; 2] = [
    |input| format!("generalised_force({input})"),
    |_| "0".to_owned(),
];

/// The function for a drawing with each selection of inputs, then none.
fn drawings(mechanism: &Mechanism) -> Vec<String> {
    let mut all = Vec::new();
    if Missing::in_mechanism(mechanism) != Missing::Nothing {
        let inputs: Vec<&str> = mechanism.inputs().iter().map(|input| input.name).collect();
        let name = free_name(mechanism, "picture");
        all.extend(selections(&inputs).into_iter().map(|inputs| {
            let inputs = inputs.join(", ");
            format!("fn {name}({inputs}) -> WholePicture {{ shape: picture() }}\n")
        }));
    }
    all.push(String::new());
    all
}

fn free_name(mechanism: &Mechanism, name: &str) -> String {
    let functions = mechanism.compiled().functions.iter();
    free(functions.map(|function| &function.name[..]), name)
}

/// Both functions of the energy, and their names. A function takes exactly the arguments that its
/// results depend on; therefore each argument is also a result.
fn energy_functions(driven: &Driven<'_>, force: fn(&str) -> String) -> (String, EnergyFunctions) {
    let mechanism = driven.mechanism();
    let names = EnergyFunctions {
        loads: free_name(mechanism, "motion_loads"),
        weights: free_name(mechanism, "motion_weights"),
    };
    let unit = mechanism.compiled();
    let taken = &unit.functions[driven.function()].arguments;
    let inputs: Vec<&str> = mechanism.inputs().iter().map(|input| input.name).collect();
    let role = |index: usize| {
        let number = index.checked_sub(inputs.len())?;
        Some(unit.arguments[number].role)
    };
    let of_kind = |keeps: fn(Option<Role>) -> bool| -> Vec<&str> {
        let kept = taken.iter().filter(|index| keeps(role(**index)));
        kept.map(|&index| mechanism.argument(index).0).collect()
    };
    let moving = of_kind(|role| !matches!(role, Some(Role::Acceleration(_))));
    let resting = of_kind(|role| matches!(role, None | Some(Role::Load)));
    let loads = [
        fields(&inputs, "force", force),
        fields(&inputs, "slope", |input| {
            format!("d(potential_energy(), {input})")
        }),
        vec![
            "kinetic: kinetic_energy()".to_owned(),
            "potential: potential_energy()".to_owned(),
        ],
        fields(&moving, "given", str::to_owned),
    ];
    let weights = [
        fields(&inputs, "held", |input| format!("bias({input})")),
        fields(&resting, "given", str::to_owned),
    ];
    let functions = function(&names.loads, "MotionEnergy", &moving, &loads.concat())
        + &function(&names.weights, "MotionWeights", &resting, &weights.concat());
    (functions, names)
}

/// A field for each name, with a number in its own name.
fn fields(names: &[&str], stem: &str, value: impl Fn(&str) -> String) -> Vec<String> {
    let names = names.iter().enumerate();
    names
        .map(|(index, name)| format!("{stem}_{index}: {}", value(name)))
        .collect()
}

fn function(name: &str, result: &str, arguments: &[&str], fields: &[String]) -> String {
    let (arguments, fields) = (arguments.join(", "), fields.join(", "));
    format!("fn {name}({arguments}) -> {result} {{ {fields} }}\n")
}

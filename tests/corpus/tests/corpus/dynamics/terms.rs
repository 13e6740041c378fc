//! The functions with the terms of the equation of motion, and their arguments.

use std::fmt::Write;

use linkage_compiler::check_names;
use linkage_engine::Mechanism;
use linkage_random::Random;
use proc_macro2::TokenStream;

/// An input with the names of its speed and its acceleration.
struct Driven {
    name: String,
    turns: bool,
    rates: [Option<String>; 2],
}

/// The inputs and loads of a mechanism.
pub(super) struct Terms {
    inputs: Vec<Driven>,
    /// Names of loads, with their indices among the arguments.
    loads: Vec<(String, usize)>,
    has_loads: bool,
    has_friction: bool,
}

/// Numbers for the arguments.
pub(super) struct Arguments {
    inputs: Vec<f64>,
    /// 0 for an input whose speed has no name.
    pub(super) speeds: Vec<f64>,
    accelerations: Vec<f64>,
    loads: Vec<f64>,
}

impl Terms {
    /// `None` for a mechanism without masses or without inputs.
    pub(super) fn new(text: TokenStream) -> Option<Self> {
        let all = check_names(text);
        let model = all.last()?.model.as_ref()?;
        let mechanism = &model.mechanism;
        let mut bodies = mechanism.bodies.iter();
        let has_masses = bodies.any(|body| !body.masses.is_empty() || !body.inertias.is_empty());
        if !has_masses || mechanism.inputs.is_empty() {
            return None;
        }
        let name = |argument: Option<usize>| Some(mechanism.arguments[argument?].name.clone());
        let inputs = mechanism.inputs.iter().map(|input| Driven {
            name: input.name.clone(),
            turns: input.dimension.half_lengths == 0,
            rates: [name(input.speed), name(input.acceleration)],
        });
        let arguments = mechanism.arguments.iter().enumerate();
        let loads = arguments.filter(|(_, argument)| argument.reference.is_some());
        Some(Self {
            inputs: inputs.collect(),
            loads: loads
                .map(|(index, load)| (load.name.clone(), mechanism.inputs.len() + index))
                .collect(),
            has_loads: !mechanism.loads.is_empty()
                || !mechanism.elements.is_empty()
                || !mechanism.frictions.is_empty(),
            has_friction: !mechanism.frictions.is_empty(),
        })
    }

    /// Removes a load that a message refuses as an argument.
    pub(super) fn drop_unneeded(&mut self, message: &str) -> bool {
        let count = self.loads.len();
        self.loads
            .retain(|(name, _)| !message.contains(&format!("does not need the argument `{name}`")));
        self.loads.len() < count
    }

    /// Pairs of a residual and the size of its terms: at given accelerations, without drives, of
    /// energies. Then the change of the inertia's energy and the biases, the weights, the matrix.
    pub(super) fn functions(&self) -> String {
        let inputs = self.names(&|input| Some(&input.name));
        let speeds = self.names(&|input| input.rates[0].as_ref());
        let accelerations = self.names(&|input| input.rates[1].as_ref());
        let loads: Vec<&str> = self.loads.iter().map(|(name, _)| name.as_str()).collect();
        let motion = [&inputs[..], &speeds[..]].concat();
        let driven = [&motion[..], &accelerations[..], &loads[..]].concat();
        let free = [&motion[..], &loads[..]].concat();
        let mut text = String::new();
        self.add(&mut text, "driven", &driven, self.driven_residuals());
        self.add(&mut text, "free", &free, self.free_residuals());
        self.add(&mut text, "energies", &motion, self.energy_residuals());
        let biases = || inputs.iter().map(|a| format!("bias({a})"));
        let change = self
            .change()
            .unwrap_or_else(|| format!("0 * bias({})", inputs[0]));
        let moving = std::iter::once(change).chain(biases());
        self.add(&mut text, "moving", &motion, moving.collect());
        self.add(&mut text, "rest", &inputs, biases().collect());
        self.add(&mut text, "matrix", &inputs, vec!["inertia()".to_owned()]);
        text
    }

    fn names<'t>(&'t self, of: &dyn Fn(&'t Driven) -> Option<&'t String>) -> Vec<&'t str> {
        self.inputs
            .iter()
            .filter_map(of)
            .map(String::as_str)
            .collect()
    }

    fn add(&self, text: &mut String, name: &str, arguments: &[&str], quantities: Vec<String>) {
        let _ = write!(
            text,
            "fn terms_of_{name}({}) -> Terms_of_{name} {{ ",
            arguments.join(", ")
        );
        for (index, quantity) in quantities.iter().enumerate() {
            let _ = write!(text, "term_{index}: {quantity}, ");
        }
        text.push_str("}\n");
    }

    /// `torque - (M q" + h - Q)`
    fn driven_residuals(&self) -> Vec<String> {
        let rows = self.inputs.iter().map(|a| {
            let (name, word) = (&a.name, if a.turns { "torque" } else { "force" });
            let parts = self.inputs.iter().filter_map(|b| {
                Some(format!(
                    "inertia({name}, {}) * {}",
                    b.name,
                    b.rates[1].as_ref()?
                ))
            });
            let parts = parts.chain(std::iter::once(format!("bias({name})")));
            let mut parts: Vec<String> = parts.collect();
            let drive = format!("{word}({name})");
            let mut sum = parts.join(" + ");
            if self.has_loads {
                let force = format!("generalised_force({name})");
                sum = format!("{sum} - {force}");
                parts.push(force);
            }
            parts.push(drive.clone());
            [format!("{drive} - ({sum})"), sizes(&parts)]
        });
        rows.flatten().collect()
    }

    /// `M q" + h - Q` for the accelerations without drives. Friction depends on the accelerations:
    /// that of `Q` is for those that the function lists.
    fn free_residuals(&self) -> Vec<String> {
        if self.has_friction {
            let accelerations = self.inputs.iter();
            let accelerations =
                accelerations.map(|input| format!("driven_acceleration({})", input.name));
            let [zero, _] = self.nothing();
            return accelerations
                .flat_map(|acceleration| [zero.clone(), sizes(&[acceleration])])
                .collect();
        }
        let rows = self.inputs.iter().map(|a| {
            let name = &a.name;
            let parts = self
                .inputs
                .iter()
                .map(|b| format!("inertia({name}, {0}) * driven_acceleration({0})", b.name));
            let mut parts: Vec<String> = parts.collect();
            parts.push(format!("bias({name})"));
            let mut sum = parts.join(" + ");
            if self.has_loads {
                let force = format!("generalised_force({name})");
                sum = format!("{sum} - {force}");
                parts.push(force);
            }
            [sum, sizes(&parts)]
        });
        rows.flatten().collect()
    }

    /// A residual of nothing.
    fn nothing(&self) -> [String; 2] {
        let zero = format!("0 * inertia({0}, {0})", self.inputs[0].name);
        [zero.clone(), zero]
    }

    /// `T - q'. M q' / 2`, and the change of `T` with the inputs against that of `M`.
    fn energy_residuals(&self) -> Vec<String> {
        let Some(change) = self.change() else {
            return self.nothing().to_vec();
        };
        let moving = || self.inputs.iter().filter(|input| input.rates[0].is_some());
        let energy = moving().map(|k| {
            let (k, w) = (&k.name, k.rates[0].as_deref().unwrap_or_default());
            format!("d(kinetic_energy(), {k}) * {w}")
        });
        let energy = energy.collect::<Vec<_>>().join(" + ");
        let half = self.products(|a, b| format!("inertia({a}, {b})"));
        vec![
            format!("kinetic_energy() - ({half}) / 2"),
            "kinetic_energy()".to_owned(),
            format!("{energy} - ({change})"),
            // A constant inertia has derivatives of rounding.
            format!("kinetic_energy() / 1s + {}", sizes(&[change])),
        ]
    }

    /// `q'. M' q' / 2`; `None` if no speed has a name.
    fn change(&self) -> Option<String> {
        let moving = self
            .inputs
            .iter()
            .filter_map(|k| Some((&k.name, k.rates[0].as_ref()?)));
        let parts = moving.map(|(k, w)| {
            let sum = self.products(|a, b| format!("d(inertia({a}, {b}), {k})"));
            format!("({sum}) * {w} / 2")
        });
        let parts: Vec<String> = parts.collect();
        (!parts.is_empty()).then(|| parts.join(" + "))
    }

    /// The sum of a matrix times all products of two speeds.
    fn products(&self, entry: impl Fn(&str, &str) -> String) -> String {
        let moving = || {
            self.inputs
                .iter()
                .filter_map(|k| Some((&k.name, k.rates[0].as_ref()?)))
        };
        let parts = moving().flat_map(|(a, v)| {
            let entry = &entry;
            moving().map(move |(b, w)| format!("{} * {v} * {w}", entry(a, b)))
        });
        parts.collect::<Vec<_>>().join(" + ")
    }

    /// Positions in the ranges, speeds and accelerations of any size, loads near their defaults.
    pub(super) fn random_arguments(&self, mechanism: &Mechanism, random: &mut Random) -> Arguments {
        let mut rate = |name: &Option<String>| match name {
            Some(_) => random.between(-20.0, 20.0),
            None => 0.0,
        };
        let speeds = self
            .inputs
            .iter()
            .map(|input| rate(&input.rates[0]))
            .collect();
        let accelerations = self
            .inputs
            .iter()
            .map(|input| rate(&input.rates[1]))
            .collect();
        let inputs = mechanism.inputs().iter().map(|input| {
            let (start, end) = input.ends();
            random.between(start, end)
        });
        let inputs = inputs.collect();
        let loads = self.loads.iter().map(|(_, index)| {
            let reference = mechanism.default_argument(*index).unwrap_or_default();
            reference * random.between(-2.0, 2.0)
        });
        Arguments {
            inputs,
            speeds,
            accelerations,
            loads: loads.collect(),
        }
    }
}

impl Arguments {
    /// Those of a function, in its order.
    pub(super) fn of(&self, function: &str, terms: &Terms) -> Vec<f64> {
        let named = |values: &[f64], order: usize| {
            let pairs = terms.inputs.iter().zip(values);
            let named = pairs.filter(|(input, _)| input.rates[order].is_some());
            named.map(|(_, &value)| value).collect::<Vec<f64>>()
        };
        let mut values = self.inputs.clone();
        if matches!(function, "driven" | "free" | "energies" | "moving") {
            values.extend(named(&self.speeds, 0));
        }
        if function == "driven" {
            values.extend(named(&self.accelerations, 1));
        }
        if matches!(function, "driven" | "free") {
            values.extend(&self.loads);
        }
        values
    }
}

/// The sum of the sizes of terms.
fn sizes(parts: &[String]) -> String {
    let sizes = parts.iter().map(|part| format!("abs({part})"));
    sizes.collect::<Vec<_>>().join(" + ")
}

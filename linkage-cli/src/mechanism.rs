//! A mechanism in the types of the runtime. These are made for generated code and hold constants,
//! so the description of a mechanism lives as long as the process.

mod describe;
pub(crate) mod forever;

use linkage_compiler::Checked;
use linkage_compiler::ir::{CompiledMechanism, plain};
use linkage_runtime::support::{Angle, CoupledGroup};
use linkage_runtime::{AssemblyMode, Heading, Input, Parameter, Structure};

use forever::forever;

/// A mechanism without a mistake: its programs and their description.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// The name of its struct.
    pub name: &'static str,
    /// Its programs.
    pub unit: CompiledMechanism,
    /// The constant `INPUTS` of the macro's struct.
    pub inputs: &'static [Input],
    /// The constant `PARAMETERS`.
    pub parameters: &'static [Parameter],
    /// The constant `STRUCTURE`.
    pub structure: &'static Structure,
    /// The columns of each function.
    pub headings: Vec<&'static Heading>,
    pub(crate) gap_units: Vec<&'static str>,
    pub(crate) groups: &'static [CoupledGroup],
    pub(crate) angles: Vec<Angle<Vec<f64>>>,
}

impl Mechanism {
    /// Describes a checked mechanism; `None` if it has mistakes.
    #[must_use]
    pub fn new(checked: &Checked) -> Option<Self> {
        let unit = checked.unit.clone()?;
        let name = forever(checked.name.as_deref().unwrap_or_default());
        let gap_units = unit
            .groups
            .iter()
            .map(|group| forever(group.gap_unit.as_str()));
        Some(Self {
            name,
            inputs: describe::inputs(&unit),
            parameters: describe::parameters(&unit),
            structure: describe::structure(&unit),
            headings: describe::headings(&unit),
            gap_units: gap_units.collect(),
            groups: describe::groups(name, &unit),
            angles: describe::angles(&unit),
            unit,
        })
    }

    /// The dimensions of the declaration.
    #[must_use]
    pub fn dimensions(&self) -> Vec<f64> {
        self.unit.scalars().map(|scalar| scalar.nominal).collect()
    }

    /// Another tolerance of a dimension, by its place among the parameters.
    pub(crate) fn set_tolerance(&mut self, index: usize, tolerance: f64) {
        let mut parameters = self.parameters.to_vec();
        parameters[index].tolerance = tolerance;
        self.parameters = forever(parameters);
        let parameters = self.unit.parameters.iter_mut();
        let mut scalars = parameters.flat_map(|parameter| &mut parameter.scalars);
        if let Some(scalar) = scalars.nth(index) {
            scalar.tolerance = tolerance;
        }
    }

    /// The reference inputs.
    #[must_use]
    pub fn reference(&self) -> Vec<f64> {
        let inputs = self.unit.inputs.iter();
        inputs.map(|input| input.reference).collect()
    }

    /// The groups whose assembly is followed from the estimates, as numbers in `structure`.
    pub(crate) fn followed(&self) -> impl Iterator<Item = usize> {
        let followed = self.unit.coupled.iter().filter(|coupled| coupled.followed);
        followed.map(|followed| followed.group)
    }

    /// The modes that the start estimates choose.
    pub(crate) fn modes(&self) -> Vec<AssemblyMode> {
        let modes = self.unit.modes().into_iter();
        modes
            .map(|plus| match plus {
                true => AssemblyMode::Plus,
                false => AssemblyMode::Minus,
            })
            .collect()
    }

    /// Name and unit of an argument of functions, by its place among inputs and arguments.
    pub(crate) fn argument(&self, index: usize) -> (&str, &str) {
        match index.checked_sub(self.inputs.len()) {
            None => (self.inputs[index].name, self.inputs[index].unit),
            Some(number) => {
                let argument = &self.unit.arguments[number];
                (plain(&argument.name), &argument.unit)
            }
        }
    }
}

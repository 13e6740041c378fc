//! A mechanism as the runtime's types describe it. These are made for generated code and hold constants, so what describes a mechanism
//! lives as long as the process.

mod describe;

use linkage_compiler::Checked;
use linkage_compiler::ir::{CompiledMechanism, plain};
use linkage_runtime::generated::{Angle, CoupledGroup};
use linkage_runtime::{AssemblyMode, Heading, Input, Parameter, Structure};

/// A mechanism without a mistake: its programs, and what they are about.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// As its struct is called.
    pub name: &'static str,
    /// Its programs.
    pub unit: CompiledMechanism,
    /// As the constant `INPUTS` of the macro's struct.
    pub inputs: &'static [Input],
    /// As the constant `PARAMETERS`.
    pub parameters: &'static [Parameter],
    /// As the constant `STRUCTURE`.
    pub structure: &'static Structure,
    /// What the columns of each function are.
    pub headings: Vec<&'static Heading>,
    pub(crate) gap_units: Vec<&'static str>,
    pub(crate) groups: &'static [CoupledGroup],
    pub(crate) angles: Vec<Angle<Vec<f64>>>,
}

impl Mechanism {
    /// What was checked; `None` if it has mistakes.
    #[must_use]
    pub fn new(checked: &Checked) -> Option<Self> {
        let unit = checked.unit.clone()?;
        let name = forever(checked.name.as_deref().unwrap_or_default());
        let gap_units = unit.groups.iter().map(|own| forever(own.gap_unit.as_str()));
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
    pub(crate) fn set_tolerance(&mut self, place: usize, tolerance: f64) {
        let mut parameters = self.parameters.to_vec();
        parameters[place].tolerance = tolerance;
        self.parameters = forever(parameters);
        let parameters = self.unit.parameters.iter_mut();
        let mut scalars = parameters.flat_map(|own| &mut own.scalars);
        if let Some(scalar) = scalars.nth(place) {
            scalar.tolerance = tolerance;
        }
    }

    /// The reference inputs.
    #[must_use]
    pub fn reference(&self) -> Vec<f64> {
        let inputs = self.unit.inputs.iter();
        inputs.map(|input| input.reference).collect()
    }

    /// The modes that the start estimates choose.
    /// The groups whose assembly is followed from the estimates, as numbers in `structure`.
    pub(crate) fn followed(&self) -> impl Iterator<Item = usize> {
        let followed = self.unit.coupled.iter().filter(|own| own.followed);
        followed.map(|own| own.group)
    }

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
    pub(crate) fn argument(&self, place: usize) -> (&str, &str) {
        match place.checked_sub(self.inputs.len()) {
            None => (self.inputs[place].name, self.inputs[place].unit),
            Some(number) => {
                let own = &self.unit.arguments[number];
                (plain(&own.name), &own.unit)
            }
        }
    }
}

/// Something that lives as long as the process.
pub(crate) fn forever<T: ?Sized, B: Into<Box<T>>>(own: B) -> &'static T {
    Box::leak(own.into())
}

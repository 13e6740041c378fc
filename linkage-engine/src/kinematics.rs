//! Assemblies of a mechanism, its circuits, the effects of its tolerances, and its equation of motion.

use linkage_runtime::support::{
    AssemblyData, Core, assemble_coupled, assemble_from, assemblies_at, circuits_of,
};
use linkage_runtime::{AssemblyError, Circuits};

use crate::compiled::{Assembly, Compiled};
use crate::driven::{Driven, driven_function};
use crate::error::NotDriven;
use crate::mechanism::Mechanism;
use crate::tolerance_effects::{SensitiveQuantity, sensitive_quantities};

impl Mechanism {
    /// The assembly that the start estimates choose, closed at the reference inputs.
    ///
    /// # Errors
    ///
    /// As the method `assemble` of the macro's struct.
    pub fn assemble(&self, dimensions: &[f64]) -> Result<Assembly<'_>, AssemblyError> {
        assemble_coupled(&Compiled::new(self, dimensions))
    }

    /// Every assembly at the inputs `at`, the one that the start estimates choose first.
    ///
    /// # Errors
    ///
    /// As the method `assemblies` of the macro's struct.
    pub fn assemblies(
        &self,
        dimensions: &[f64],
        at: &[f64],
    ) -> Result<Vec<Assembly<'_>>, AssemblyError> {
        assemblies_at(&Compiled::new(self, dimensions), &at.to_vec())
    }

    /// Assembles other dimensions in the assembly of `from`, which is followed along the straight
    /// way to them, at the reference inputs, in steps too small to leave it.
    ///
    /// # Errors
    ///
    /// `Blocked` where the assembly ends on the way; those of [`assemble`](Self::assemble) for
    /// these dimensions.
    pub fn assemble_from(
        &self,
        dimensions: &[f64],
        from: &Assembly<'_>,
    ) -> Result<Assembly<'_>, AssemblyError> {
        // The mechanism is this one, and may be borrowed longer.
        let core = AssemblyData::core(&from.data);
        let core = Core {
            dimensions: Compiled::new(self, from.dimensions()),
            modes: core.modes.clone(),
            revolutions: core.revolutions.clone(),
            prepared: core.prepared.clone(),
        };
        let data = AssemblyData::new(core, from.starts().clone());
        assemble_from(&Compiled::new(self, dimensions), &Assembly { data })
    }

    /// Every assembly over the range of the input; `None` for a mechanism without groups or with
    /// another number of inputs than one.
    ///
    /// # Errors
    ///
    /// As the method `circuits` of the macro's struct.
    pub fn circuits(
        &self,
        dimensions: &[f64],
    ) -> Option<Result<Circuits<Assembly<'_>>, AssemblyError>> {
        let searched = self.compiled.inputs.len() == 1 && !self.compiled.groups.is_empty();
        searched.then(|| circuits_of(&Compiled::new(self, dimensions)))
    }

    /// Returns the quantities of a function, by its number, that have derivatives by parameters.
    ///
    /// # Panics
    ///
    /// If there is no such function.
    #[must_use]
    pub fn sensitive_quantities(&self, function: usize) -> Vec<SensitiveQuantity> {
        sensitive_quantities(self, function)
    }

    /// Returns the first function with the `driven_acceleration` of all inputs.
    #[must_use]
    pub fn driven_function(&self) -> Option<usize> {
        driven_function(self)
    }

    /// Returns the equation of motion of a function. `start` are its arguments at the start: inputs
    /// in rad or in the length unit, speeds per second, loads in their units. Accelerations among
    /// them have no effect.
    ///
    /// # Errors
    ///
    /// If the function lacks the acceleration, the value or the speed of an input.
    ///
    /// # Panics
    ///
    /// If there is no such function, or it takes another number of arguments.
    ///
    /// ```
    /// use linkage_engine::Mechanism;
    ///
    /// let mechanism = Mechanism::compile("
    ///     pub struct Stone {
    ///         unit m;
    ///         input y = 0m at v;
    ///         gravity = (0, -10m/s^2);
    ///         body stone = slide on frame at (0, y) along (0, 1), mass 1kg at (0, y);
    ///     }
    ///     impl Stone { pub fn fall(y, v) -> Fall { a: driven_acceleration(y) } }")?;
    /// let assembly = mechanism.assemble(&mechanism.dimensions())?;
    /// let driven = mechanism.driven(0, &[0.0, 0.0])?;
    /// assert_eq!(driven.accelerations(&assembly, [2.0], [3.0]), [-10.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn driven(&self, function: usize, start: &[f64]) -> Result<Driven<'_>, NotDriven> {
        Driven::new(self, function, start)
    }
}

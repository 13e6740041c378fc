//! Assemblies of a mechanism, its circuits, and the effects of its tolerances.

use linkage_runtime::support::{assemblies, explained_by};
use linkage_runtime::{AssemblyError, Circuits};

use crate::assembled::{Assembly, all_assembled, assembled};
use crate::circuits::circuits_of;
use crate::mechanism::Mechanism;
use crate::other_dimensions::continued;
use crate::tolerance_effects::{SensitiveQuantity, sensitive_quantities};

impl Mechanism {
    /// The assembly that the start estimates choose, closed at the reference inputs.
    ///
    /// # Errors
    ///
    /// As the method `assemble` of the macro's struct.
    pub fn assemble(&self, dimensions: &[f64]) -> Result<Assembly<'_>, AssemblyError> {
        let at = self.reference();
        let result = assembled(self, dimensions, self.modes(), &at);
        explained_by(result, self.parameters, dimensions)
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
        let result = assemblies(self.name, self.modes(), |modes| {
            all_assembled(self, dimensions, modes, at)
        });
        explained_by(result, self.parameters, dimensions)
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
        continued(self, dimensions, from)
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
        circuits_of(self, dimensions)
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
}

//! The state of the structural analysis, and the stages that it can go back to.

use crate::algebra::{Names, Nominal};
use crate::structure::fault::StructureFault;
use crate::structure::form::Form;
use crate::structure::group::Group;
use crate::structure::reductions::Reductions;

/// The state of the analysis.
pub(crate) struct Analysis<'a, 'm> {
    pub(crate) names: &'a mut Names<'m>,
    pub(crate) nominal: &'a Nominal,
    /// The groups so far, in the order of their solution.
    pub(crate) groups: Vec<Group<'m>>,
    pub(crate) faults: Vec<StructureFault>,
    pub(crate) reductions: Reductions<'m>,
    /// The number of reductions so far.
    pub(crate) steps: usize,
    /// The number of separations so far.
    pub(crate) separations: usize,
}

/// A stage of the analysis, to which it can go back.
pub(crate) struct Checkpoint {
    groups: usize,
    faults: usize,
    explicit: usize,
    kept_axes: usize,
    angles: usize,
    steps: usize,
    separations: usize,
}

/// Returns the current stage.
pub(crate) fn checkpoint(analysis: &Analysis) -> Checkpoint {
    Checkpoint {
        groups: analysis.groups.len(),
        faults: analysis.faults.len(),
        explicit: analysis.reductions.explicit.len(),
        kept_axes: analysis.reductions.kept_axes.len(),
        angles: analysis.names.angles.len(),
        steps: analysis.steps,
        separations: analysis.separations,
    }
}

/// True if the component since then is coupled, not solved, or was separated late.
pub(crate) fn is_open_since(analysis: &Analysis, before: &Checkpoint) -> bool {
    let groups = &analysis.groups[before.groups..];
    groups.iter().any(|g| matches!(g.form, Form::Coupled(_)))
        || analysis.faults.len() > before.faults
        || analysis.separations > before.separations
}

/// Forgets all that has been found since a stage.
pub(crate) fn return_to(analysis: &mut Analysis, before: &Checkpoint) {
    analysis.groups.truncate(before.groups);
    analysis.faults.truncate(before.faults);
    analysis
        .reductions
        .truncate(before.explicit, before.kept_axes);
    analysis.names.angles.truncate(before.angles);
    analysis.steps = before.steps;
    analysis.separations = before.separations;
}

//! The speeds of drives that a function lists, and the variables of derivatives.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{SymbolId, Vn};

use crate::model::Mechanism;

/// The speeds and accelerations that a function lists, as places among inputs and arguments, by
/// drive.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Speeds {
    pub(super) speeds: Vec<Option<usize>>,
    pub(super) accelerations: Vec<Option<usize>>,
}

/// The variable of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum By {
    /// An input, which moves the unknowns, too.
    Input(usize),
    /// An unknown or input that changes alone.
    Alone(SymbolId),
}

/// Angular velocities of bodies, made when they are asked for.
pub(super) type AngularVelocities<'m> = Map<(usize, By), Vn<'m>>;

impl Speeds {
    /// The same speeds without accelerations.
    pub(super) fn steady(&self) -> Self {
        Self {
            speeds: self.speeds.clone(),
            accelerations: vec![None; self.accelerations.len()],
        }
    }

    /// Those among the arguments that a function lists.
    pub(super) fn listed(mechanism: &Mechanism, listed: &[usize]) -> Self {
        let drives = mechanism.inputs.len();
        let listed_index = |argument: Option<usize>| {
            let index = argument.map(|argument| drives + argument);
            index.filter(|index| listed.contains(index))
        };
        let inputs = mechanism.inputs.iter();
        Self {
            speeds: inputs
                .clone()
                .map(|input| listed_index(input.speed))
                .collect(),
            accelerations: inputs
                .map(|input| listed_index(input.acceleration))
                .collect(),
        }
    }
}

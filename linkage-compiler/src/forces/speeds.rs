//! The speeds of drives that a function lists, and the variables of derivatives.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{SymbolId, Vn};

use crate::model::Mechanism;

/// The speeds and accelerations that a function lists, as places among inputs and arguments, by
/// drive.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Speeds {
    pub(super) speeds: Vec<Option<Rate>>,
    pub(super) accelerations: Vec<Option<Rate>>,
}

/// The speed or acceleration of a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Rate {
    /// An argument of the function, as a place among inputs and arguments.
    Listed(usize),
    /// One radian or one unit of length in a second, or in the square of one: the result is
    /// multiplied later, once.
    Unit,
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

    /// The only drive with a speed, and a motion of it alone at unit speed.
    pub(super) fn single(&self) -> Option<(usize, Self)> {
        let mut moving = (0..self.speeds.len()).filter(|&drive| self.speeds[drive].is_some());
        let drive = moving.next()?;
        let mut unit = self.steady();
        unit.speeds[drive] = Some(Rate::Unit);
        moving.next().is_none().then_some((drive, unit))
    }

    /// No speed, and no acceleration.
    pub(super) fn at_rest(mechanism: &Mechanism) -> Self {
        let none = vec![None; mechanism.inputs.len()];
        Self {
            speeds: none.clone(),
            accelerations: none,
        }
    }

    /// One drive with the speed 1, the others at rest.
    pub(super) fn unit_speed(mechanism: &Mechanism, drive: usize) -> Self {
        let mut speeds = Self::at_rest(mechanism);
        speeds.speeds[drive] = Some(Rate::Unit);
        speeds
    }

    /// One drive with the acceleration 1, from rest.
    pub(super) fn unit_acceleration(mechanism: &Mechanism, drive: usize) -> Self {
        let mut speeds = Self::at_rest(mechanism);
        speeds.accelerations[drive] = Some(Rate::Unit);
        speeds
    }

    /// True if a drive has a speed.
    pub(super) fn has_speed(&self) -> bool {
        self.speeds.iter().any(Option::is_some)
    }

    /// Those among the arguments that a function lists.
    pub(super) fn listed(mechanism: &Mechanism, listed: &[usize]) -> Self {
        let drives = mechanism.inputs.len();
        let listed_index = |argument: Option<usize>| {
            let index = argument.map(|argument| drives + argument);
            let index = index.filter(|index| listed.contains(index));
            index.map(Rate::Listed)
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

//! The arguments of quantities.

use super::function_words::{MechanicsWord, MotionWord, QuantityWord};

impl QuantityWord {
    /// Returns the arguments of a call; those that may be left out end with `?`.
    pub fn parameters(self) -> &'static [&'static str] {
        match self {
            QuantityWord::Motion(word) => word.parameters(),
            QuantityWord::Mechanics(word) => word.parameters(),
        }
    }
}

impl MechanicsWord {
    /// See [`QuantityWord::parameters`].
    fn parameters(self) -> &'static [&'static str] {
        match self {
            MechanicsWord::Reaction | MechanicsWord::Moment => &["joint"],
            MechanicsWord::Torque
            | MechanicsWord::Force
            | MechanicsWord::Bias
            | MechanicsWord::GeneralisedForce
            | MechanicsWord::DrivenAcceleration => &["input"],
            MechanicsWord::Inertia => &["input?", "input?"],
            MechanicsWord::ShakingMoment => &["point?"],
            MechanicsWord::Power
            | MechanicsWord::FrictionPower
            | MechanicsWord::Efficiency
            | MechanicsWord::KineticEnergy
            | MechanicsWord::PotentialEnergy
            | MechanicsWord::ShakingForce => &[],
        }
    }
}

impl MotionWord {
    /// See [`QuantityWord::parameters`].
    fn parameters(self) -> &'static [&'static str] {
        match self {
            MotionWord::Derivative => &["quantity", "variable", "variable?"],
            MotionWord::Velocity | MotionWord::Acceleration | MotionWord::Jerk => &["quantity"],
            MotionWord::Omega
            | MotionWord::Alpha
            | MotionWord::ScrewPoint
            | MotionWord::ScrewDirection
            | MotionWord::ScrewPitch => &["frame"],
            MotionWord::Sensitivity => &["quantity", "[parameters]?"],
            MotionWord::Margin => &[],
            MotionWord::Picture => &["[points]?"],
        }
    }
}
